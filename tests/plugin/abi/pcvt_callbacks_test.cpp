#include <gmock/gmock.h>
#include <pcvt.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "io/bytes/output_error.hpp"
#include "plugin/abi/guard.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt::abi {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::StrEq;

pcvt_options options_for(int n_sites) {
    pcvt_options options;
    EXPECT_EQ(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION), PCVT_OK);
    options.n_sites = n_sites;
    return options;
}

/// Generates with a progress callback and frees the result.
pcvt_status generate_with(pcvt_progress_callback progress, void* data = nullptr) {
    pcvt_options options = options_for(100);
    options.progress = progress;
    options.progress_data = data;
    pcvt_result* result = nullptr;
    const pcvt_status status = pcvt_generate(&options, &result);
    EXPECT_EQ(result != nullptr, status == PCVT_OK);
    pcvt_free(result);
    return status;
}

TEST(Callbacks, AThrownExceptionBecomesAStatus) {
    EXPECT_EQ(
        generate_with([](const pcvt_progress*, void*) -> int { throw std::runtime_error("ouch"); }),
        PCVT_ERROR_DOMAIN);
    EXPECT_THAT(pcvt_last_error(), StrEq("the progress callback threw: ouch"));
    EXPECT_EQ(generate_with([](const pcvt_progress*, void*) -> int { throw 7; }),
              PCVT_ERROR_DOMAIN);
    EXPECT_EQ(generate_with([](const pcvt_progress*, void*) -> int { throw std::bad_alloc(); }),
              PCVT_ERROR_DOMAIN);
    EXPECT_EQ(generate_with(nullptr), PCVT_OK);
}

TEST(Callbacks, ADensityMayThrowToo) {
    pcvt_options options = options_for(100);
    options.density = [](const double*, std::size_t, double*, void*) -> int {
        throw std::runtime_error("ouch");
    };
    pcvt_result* result = nullptr;
    EXPECT_EQ(pcvt_generate(&options, &result), PCVT_ERROR_DOMAIN);
    EXPECT_EQ(result, nullptr);
    EXPECT_THAT(pcvt_last_error(), StrEq("the density callback threw: ouch"));
}

TEST(Callbacks, ADensityIsEvaluatedOnTheCallingThreadOnly) {
    std::thread::id caller = std::this_thread::get_id();
    pcvt_options options = options_for(3000);
    options.n_threads = 4;
    options.max_iterations = 1;
    options.density_data = &caller;
    options.density = [](const double*, std::size_t n, double* values, void* data) {
        std::fill(values, values + n, 1.0);
        return static_cast<int>(*static_cast<std::thread::id*>(data) != std::this_thread::get_id());
    };
    pcvt_result* result = nullptr;
    EXPECT_GE(pcvt_generate(&options, &result), PCVT_OK) << pcvt_last_error();
    pcvt_free(result);
}

TEST(Callbacks, RunOnTheCallingThreadOnly) {
    std::thread::id caller;
    const auto note = [](const pcvt_progress*, void* data) {
        return static_cast<int>(*static_cast<std::thread::id*>(data) != std::this_thread::get_id());
    };
    std::thread([&] {
        caller = std::this_thread::get_id();
        EXPECT_EQ(generate_with(note, &caller), PCVT_OK);
    }).join();
}

TEST(Callbacks, MayCallTheLibrary) {
    const auto nested = [](const pcvt_progress* progress, void*) {
        return static_cast<int>(progress->iteration == 3 && generate_with(nullptr) != PCVT_OK);
    };
    EXPECT_EQ(generate_with(nested), PCVT_OK);
}

/// The words of the phases that a call has reported; the call is cancelled in phase `last`.
struct Phases {
    int last = -1;
    std::vector<std::string> words = {};

    static int note(const pcvt_progress* progress, void* data) {
        Phases& phases = *static_cast<Phases*>(data);
        EXPECT_GE(progress->fraction, 0);
        EXPECT_LE(progress->fraction, 1);
        if (phases.words.empty() || phases.words.back() != progress->phase_text) {
            phases.words.emplace_back(progress->phase_text);
        }
        return static_cast<int>(progress->phase == phases.last);
    }
};

/// A result of 1000 sites, whose run reported to `phases`.
pcvt_result* generated(Phases& phases, int dimension = 2) {
    pcvt_options options = options_for(1000);
    options.dimension = dimension;
    options.tolerance = 1e-3;
    options.progress = Phases::note;
    options.progress_data = &phases;
    pcvt_result* result = nullptr;
    EXPECT_EQ(pcvt_generate(&options, &result), PCVT_OK);
    return result;
}

/// Writes to `path` and reports to `phases`.
pcvt_status written(const pcvt_result* result, const std::string& path, Phases& phases) {
    pcvt_write_options options{};
    options.struct_size = sizeof options;
    options.progress = Phases::note;
    options.progress_data = &phases;
    return pcvt_write(result, path.c_str(), &options);
}

// A step that is late reports "starting" first.
TEST(Callbacks, PhasesOfARunAndOfAWriteAreNamed) {
    const pcvt::testing::TemporaryFolder folder;
    Phases of_run;
    Phases of_write;
    pcvt_result* result = generated(of_run);
    EXPECT_THAT(of_run.words, IsSupersetOf({"placing the sites", "optimising"}));
    EXPECT_EQ(written(result, folder / "t.ply", of_write), PCVT_OK);
    EXPECT_THAT(of_write.words,
                IsSupersetOf({"building the tile", "proving the tile", "writing t.ply, 1 of 1"}));
    // The second file takes the tile of the first.
    of_write.words.clear();
    EXPECT_EQ(written(result, folder / "t.obj", of_write), PCVT_OK);
    EXPECT_THAT(of_write.words, Contains("writing t.obj, 1 of 1"));
    EXPECT_THAT(of_write.words, Not(Contains("building the tile")));
    pcvt_free(result);
}

TEST(Callbacks, PhasesInSpaceAreNamed) {
    const pcvt::testing::TemporaryFolder folder;
    Phases of_run;
    Phases of_write;
    pcvt_result* result = generated(of_run, 3);
    EXPECT_THAT(of_run.words, Contains("optimising"));
    EXPECT_EQ(written(result, folder / "t.vtu", of_write), PCVT_OK);
    EXPECT_THAT(of_write.words,
                IsSupersetOf({"building the cells", "proving the cells", "writing t.vtu, 1 of 1"}));
    // The second file takes the cells of the first.
    of_write.words.clear();
    EXPECT_EQ(written(result, folder / "t.msh", of_write), PCVT_OK);
    EXPECT_THAT(of_write.words, IsSupersetOf({"building the tetrahedra", "writing t.msh, 1 of 1"}));
    EXPECT_THAT(of_write.words, Not(Contains("building the cells")));
    pcvt_free(result);
}

TEST(Callbacks, AWriteIsCancelledInAnyPhase) {
    for (const int last : {PCVT_PHASE_BUILD, PCVT_PHASE_PROVE, PCVT_PHASE_WRITE}) {
        const pcvt::testing::TemporaryFolder folder;
        Phases of_run;
        Phases of_write{.last = last};
        pcvt_result* result = generated(of_run);
        EXPECT_EQ(written(result, folder / "t.ply", of_write), PCVT_CANCELLED);
        EXPECT_THAT(pcvt_last_error(), StrEq("cancelled by the progress callback"));
        EXPECT_THAT(folder.names(), IsEmpty());
        pcvt_free(result);
    }
}

TEST(LastError, BelongsToTheThread) {
    EXPECT_EQ(pcvt_generate(nullptr, nullptr), PCVT_ERROR_ARGUMENT);
    const std::string here = pcvt_last_error();
    std::thread([] {
        EXPECT_THAT(pcvt_last_error(), StrEq(""));
        EXPECT_EQ(pcvt_options_init(nullptr, 0, 0), PCVT_ERROR_ARGUMENT);
    }).join();
    EXPECT_EQ(pcvt_last_error(), here);
}

TEST(LastError, IsTruncatedIfItIsVeryLong) {
    set_last_error((std::string(5000, 'x') + "\n").c_str());
    EXPECT_EQ(last_error(), std::string(1023, 'x'));
    set_last_error("two\nlines");
    EXPECT_THAT(last_error(), StrEq("two lines"));
}

template <class Thrown>
pcvt_status status_of(const Thrown& thrown) {
    return note_failure(std::make_exception_ptr(thrown));
}

TEST(Status, IsDecidedByTheThrownType) {
    EXPECT_EQ(status_of(AbiMismatch("x")), PCVT_ERROR_ABI);             // law 1
    EXPECT_EQ(status_of(CallbackFault("x")), PCVT_ERROR_DOMAIN);        // law 2
    EXPECT_EQ(status_of(BadGeometry("x")), PCVT_ERROR_GEOMETRY);        // law 3
    EXPECT_EQ(status_of(DuplicateSites(1, 2)), PCVT_ERROR_GEOMETRY);    // law 3
    EXPECT_EQ(status_of(InvalidInput("x")), PCVT_ERROR_ARGUMENT);       // law 4
    EXPECT_EQ(status_of(OutputError("x")), PCVT_ERROR_IO);              // law 5
    EXPECT_EQ(status_of(OutputExists("x")), PCVT_ERROR_IO);             // law 5
    EXPECT_EQ(status_of(LimitExceeded("x")), PCVT_ERROR_MEMORY);        // law 6
    EXPECT_EQ(status_of(std::bad_alloc()), PCVT_ERROR_MEMORY);          // law 6
    EXPECT_EQ(status_of(std::length_error("x")), PCVT_ERROR_MEMORY);    // law 6
    EXPECT_EQ(status_of(InternalError("x")), PCVT_ERROR_INTERNAL);      // law 7
    EXPECT_EQ(status_of(std::out_of_range("x")), PCVT_ERROR_INTERNAL);  // law 7
    EXPECT_EQ(status_of(7), PCVT_ERROR_INTERNAL);                       // law 7
}

TEST(Sites, WhoseCellsAreTooSmallAreBadGeometry) {
    // All corners of the cell of site 0 lie within the distance at which corners are merged.
    std::vector<double> sites{0.5, 0.5};
    for (const double d : {-2e-10, 2e-10}) {
        sites.insert(sites.end(), {0.5 + d, 0.5, 0.5, 0.5 + d});
    }
    pcvt_options options = options_for(5);
    options.sites = sites.data();
    options.max_iterations = 0;
    pcvt_result* result = nullptr;
    EXPECT_EQ(pcvt_generate(&options, &result), PCVT_ERROR_GEOMETRY);
    EXPECT_THAT(pcvt_last_error(), HasSubstr("site"));
    pcvt_free(result);
}

}  // namespace
}  // namespace pcvt::abi
