#include "plugin/cli/exit_code.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "io/bytes/output_error.hpp"
#include "io/forms/tile_file.hpp"
#include "mesher/base/error.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/cli/terminal/start_guard.hpp"

namespace pcvt::cli {
namespace {

constexpr const char* kName = "pcvt: ";
static_assert(static_cast<int>(ExitCode::kLimit) == kOutOfMemoryCode);

Failure failure(ExitCode code, const char* prefix, const char* reason, const char* advice = "") {
    Failure result{code, {}};
    std::snprintf(result.line.data(), result.line.size(), "%s%s%s", prefix, reason, advice);
    // Line ends within the reason become blanks, and trailing ones vanish.
    char* const begin = result.line.data();
    char* end = begin + std::strlen(begin);
    while (end > begin && end[-1] == '\n') *--end = '\0';
    std::replace_if(
        begin, end, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return result;
}

Failure fault(const char* what) {
    return failure(ExitCode::kFault, kName, what, "; this is a fault of pcvt, please report it");
}

}  // namespace

Failure describe_failure(const std::exception_ptr& exception) noexcept {
    try {
        std::rethrow_exception(exception);
    } catch (const BadFile& error) {
        return failure(ExitCode::kBadInput, "", error.what());
    } catch (const InvalidInput& error) {
        return failure(ExitCode::kBadInput, kName, error.what());
    } catch (const OutputExists& error) {
        return failure(ExitCode::kNotWritten, kName, error.what(), "; use --force to replace it");
    } catch (const OutputError& error) {
        return failure(ExitCode::kNotWritten, kName, error.what());
    } catch (const LimitExceeded& error) {
        return failure(ExitCode::kLimit, kName, error.what());
    } catch (const NoMemoryAfterFiles& error) {
        return failure(ExitCode::kLimit, kName, error.what());
    } catch (const std::bad_alloc&) {
        return failure(ExitCode::kLimit, "", kOutOfMemory);
    } catch (const std::length_error&) {
        return failure(ExitCode::kLimit, kName, "too large for this machine; take fewer sites");
    } catch (const std::exception& error) {
        return fault(error.what());
    } catch (...) {
        return fault("an unknown exception");
    }
}

std::string exit_code_help() {
    return "Exit codes:\n"
           "  0    done and verified\n"
           "  1    a fault of pcvt\n"
           "  2    bad input, or a file that is not a periodic tile, or an output whose single\n"
           "       precision does not hold the tile; the other outputs are written then\n"
           "  3    an output could not be written, or exists and --force is not given\n"
           "  4    out of memory, or a limit of pcvt\n"
           "  5    not converged, with --strict\n"
           "  130  cancelled by Ctrl-C; 143 by SIGTERM\n"
           "A pipe that its reader has closed changes no exit code.\n";
}

}  // namespace pcvt::cli
