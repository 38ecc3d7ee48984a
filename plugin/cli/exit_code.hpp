#pragma once

#include <array>
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
///   std::fprintf(stderr, "%s\n", failure.line.data());
struct Failure {
    ExitCode code;
    /// One line without a line end. Faults of a file begin with its name, all others with "pcvt: ".
    /// A longer message loses its end: this array needs no memory that may be exhausted.
    std::array<char, 8192> line;
};

/// Allocates nothing.
/// @pre exception is not null.
Failure describe_failure(const std::exception_ptr& exception) noexcept;

/// The text for a top-level `--help`: one line for each code.
std::string exit_code_help();

}  // namespace pcvt::cli
