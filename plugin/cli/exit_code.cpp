#include "plugin/cli/exit_code.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "io/bytes/output.hpp"
#include "io/tiles/tile_file.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::cli {
namespace {

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

Failure fault(const std::string& what) {
    return {ExitCode::kFault,
            one_line("pcvt: " + what + "; this is a fault of pcvt, please report it")};
}

}  // namespace

Failure describe_failure(const std::exception_ptr& exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const BadFile& error) {
        return {ExitCode::kBadInput, one_line(error.what())};
    } catch (const InvalidInput& error) {
        return {ExitCode::kBadInput, one_line(std::string("pcvt: ") + error.what())};
    } catch (const OutputExists& error) {
        return {ExitCode::kNotWritten,
                one_line(std::string("pcvt: ") + error.what() + "; use --force to replace it")};
    } catch (const OutputError& error) {
        return {ExitCode::kNotWritten, one_line(std::string("pcvt: ") + error.what())};
    } catch (const LimitExceeded& error) {
        return {ExitCode::kLimit, one_line(std::string("pcvt: ") + error.what())};
    } catch (const std::bad_alloc&) {
        return {ExitCode::kLimit, "pcvt: out of memory; take fewer sites or a larger machine"};
    } catch (const std::length_error&) {
        return {ExitCode::kLimit, "pcvt: too large for this machine; take fewer sites"};
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
           "  2    bad input, or a file that is no periodic tile\n"
           "  3    an output could not be written, or exists and --force is not given\n"
           "  4    out of memory, or a limit of pcvt\n"
           "  5    not converged, with --strict\n"
           "  130  cancelled by Ctrl-C; 143 by SIGTERM\n";
}

}  // namespace pcvt::cli
