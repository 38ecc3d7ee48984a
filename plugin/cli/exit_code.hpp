#pragma once

#include <exception>
#include <string>

namespace pcvt::cli {

/// How the command ends. An exception decides it (laws, tested by number):
///   (1) InvalidInput, with BadFile, DuplicateSites, NotATile   kBadInput
///   (2) OutputError                                            kNotWritten
///   (3) LimitExceeded, bad_alloc, length_error                 kLimit
///   (4) everything else, InternalError among it                kFault
/// kNotConverged, kInterrupted and kTerminated are not exceptions, but ends of a run.
enum class ExitCode {
    kDone = 0,
    kFault = 1,
    kBadInput = 2,
    kNotWritten = 3,
    kLimit = 4,
    kNotConverged = 5,
    kInterrupted = 130,
    kTerminated = 143,
};

/// The message of an exception, and the exit code of the command.
///
///   const Failure failure = describe_failure(std::current_exception());
///   std::fprintf(stderr, "%s\n", failure.line.c_str());
struct Failure {
    ExitCode code;
    /// One line without a line end. Faults of a file begin with its name, all others with "pcvt: ".
    std::string line;
};

/// @pre exception is not null.
Failure describe_failure(const std::exception_ptr& exception);

/// The text for a top-level `--help`: one line for each code.
std::string exit_code_help();

}  // namespace pcvt::cli
