#include "plugin/job/job_report.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using Json = nlohmann::ordered_json;

Job example_job() {
    Job job;
    job.in_plane().lattice = plane::Lattice({1, 0}, {0.37, 0.81});
    job.n_sites = 1000;
    job.seed = ~std::uint64_t{0};
    return job;
}

RunSummary example_summary() {
    RunSummary summary;
    summary.run = {
        .stop = Stop::kConverged, .cg_products = 450, .energy = 0.1 + 0.2, .residual = 1e-320};
    summary.n_sites = 1000;
    summary.energy_bound = 1e-7 / 3;
    summary.minimum = Minimum::kYes;
    summary.n_mirrors = 1'000'000;
    summary.valences = {{5, 50}, {6, 900}, {7, 50}};
    summary.files = {"a \"b\".obj", "\xC3\xBC.txt"};
    summary.seconds = {0, 1.5, 2, 3.5};
    return summary;
}

Json report(const RunSummary& summary) {
    return Json::parse(encode_job_report(example_job(), summary));
}

TEST(JobReport, KeysFollowTheContractInItsOrder) {
    std::vector<std::string> keys;
    const Json json = report(example_summary());
    for (const auto& [key, value] : json.items()) {
        keys.push_back(key);
    }
    EXPECT_THAT(keys, ::testing::ElementsAre("version", "dimension", "sites", "lattice", "seed",
                                             "solver", "start", "stop", "iterations", "evaluations",
                                             "hessians", "cg_products", "energy", "energy_bound",
                                             "residual", "rms_residual", "minimum", "hexagons",
                                             "valences", "mirrors", "threads", "seconds", "files"));
}

TEST(JobReport, ValuesReadBackExactly) {
    const Json json = report(example_summary());
    EXPECT_EQ(json["seed"].get<std::uint64_t>(), ~std::uint64_t{0});
    EXPECT_EQ(json["energy"].get<double>(), 0.1 + 0.2);
    EXPECT_EQ(json["energy_bound"].get<double>(), 1e-7 / 3);
    EXPECT_EQ(json["residual"].get<double>(), 1e-320);
    EXPECT_EQ(json["lattice"].dump(), "[[1,0],[0.37,0.81]]");
    EXPECT_EQ(json["valences"].dump(), "{\"5\":50,\"6\":900,\"7\":50}");
    EXPECT_EQ(json["mirrors"].dump(), "1000000");
    EXPECT_EQ(json["cg_products"].dump(), "450");
    EXPECT_EQ(json["minimum"].get<std::string>(), "yes");
    EXPECT_EQ(json["seconds"]["total"].get<double>(), 3.5);
    EXPECT_EQ(json["files"][0].get<std::string>(), "a \"b\".obj");
    EXPECT_EQ(json["files"][1].get<std::string>(), "\xC3\xBC.txt");
}

TEST(JobReport, UnknownValuesAreNull) {
    RunSummary summary = example_summary();
    summary.energy_bound.reset();
    summary.n_mirrors.reset();
    summary.minimum.reset();
    summary.valences.clear();
    summary.files = {"not UTF-8: \xFF"};
    const Json json = report(summary);
    EXPECT_TRUE(json["energy_bound"].is_null());
    EXPECT_TRUE(json["mirrors"].is_null());
    EXPECT_TRUE(json["minimum"].is_null());
    EXPECT_EQ(json["valences"], Json::object());
}

TEST(JobReport, APatternIsTheLastKey) {
    RunSummary summary = example_summary();
    summary.start.pattern = PatternFigures{.basis = Eigen::Matrix2d{{0.5, -0.5}, {0.5, 0.5}},
                                           .hermite = {2, 1, 1},
                                           .energy = 0.25,
                                           .stability = {.minimum = Minimum::kNo}};
    EXPECT_EQ(report(summary).back().dump(),
              "{\"basis\":[[0.5,0.5],[-0.5,0.5]],\"hermite\":[2,1,1],\"energy\":0.25,"
              "\"minimum\":\"no\",\"smallest_eigenvalue\":null}");
}

TEST(JobReport, TheKeysOfBothDimensionsAreThoseOfThePlaneWithoutHexagons) {
    Job job = example_job();
    job.domain = SpaceDomain{space::Lattice::box(1, 2, 3)};
    RunSummary summary = example_summary();
    summary.valences = {{13, 400}, {14, 600}};
    summary.polyhedra = PolyhedraFigures{.n_removed_edges = 7};
    const Json plane = report(example_summary());
    const Json space = Json::parse(encode_job_report(job, summary));
    for (const auto& [key, value] : plane.items()) {
        EXPECT_EQ(space.contains(key), key != "hexagons") << key;
    }
    EXPECT_EQ(space["dimension"], 3);
    EXPECT_EQ(space["lattice"].dump(), "[[1,0,0],[0,2,0],[0,0,3]]");
    EXPECT_EQ(space["valences"].dump(), "{\"13\":400,\"14\":600}");
    EXPECT_EQ(space["faces"], space["valences"]);
    EXPECT_EQ(space["removed_edges"], 7);
    EXPECT_EQ(plane["dimension"], 2);
}

TEST(JobReport, OnlyRunsWithADensityHaveItsKeys) {
    RunSummary summary = example_summary();
    EXPECT_FALSE(report(summary).contains("density"));
    summary.density = plane::DensityFigures{.least = 0.01,
                                            .greatest = 1,
                                            .evaluations_per_site = 54.25,
                                            .mass = 0.3,
                                            .mass_deviation = -1e-12,
                                            .spacing_deviation = 0.0125,
                                            .expected_energy = 2e-7,
                                            .quadrature_error = 1e-9,
                                            .n_rough_cells = 3};
    Job job = example_job();
    job.density_name = "1 + \"u\"";
    const Json json = Json::parse(encode_job_report(job, summary));
    EXPECT_EQ(json["density"].get<std::string>(), "1 + \"u\"");
    EXPECT_EQ(json["density_evaluations"].get<double>(), 54.25);
    EXPECT_EQ(json["mass_deviation"].get<double>(), -1e-12);
    EXPECT_EQ(json["rough_cells"].get<int>(), 3);
    EXPECT_EQ(json.size(), report(example_summary()).size() + 10);
}

TEST(JobReport, NonFiniteNumbersAreInternalErrors) {
    RunSummary summary = example_summary();
    summary.run.energy = std::nan("");
    EXPECT_THROW(report(summary), InternalError);
}

}  // namespace
}  // namespace pcvt
