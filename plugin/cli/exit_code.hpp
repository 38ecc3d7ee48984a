#pragma once

#include <exception>
#include <string>

namespace pcvt::cli {

/// How the command ends. What is thrown decides it (laws, tested by number):
///   (1) InvalidInput, with BadFile, DuplicateSites, NotATile   kBadInput
///   (2) OutputError                                            kNotWritten
///   (3) LimitExceeded, bad_alloc, length_error                 kLimit
///   (4) everything else, InternalError among it                kFault
/// kNotConverged, kInterrupted and kTerminated are no exceptions but ends of a run.
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

/// What the command says of an exception, and the code that it ends with.
struct Failure {
    ExitCode code;
    /// One line without its end. Faults of a file begin with the file, all others with "pcvt: ".
    std::string line;
};

/// @pre exception is not null.
Failure describe_failure(const std::exception_ptr& exception);

/// The texts for a top-level `--help`: one line a code.
std::string exit_code_help();

}  // namespace pcvt::cli
