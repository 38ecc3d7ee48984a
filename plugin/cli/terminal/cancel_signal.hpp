#pragma once

namespace pcvt::cli {

/// From now on SIGINT and SIGTERM are only noted, so that the run can end in order:
///
///   catch_cancel_signals();
///   run_job(job, [](const JobProgress&) { return cancel_signal() == 0; });
void catch_cancel_signals();

/// The last signal noted, or 0.
int cancel_signal();

/// From now on a file that reaches the size limit (EFBIG), and a pipe that nobody reads (EPIPE),
/// make the write fail, and do not end the process.
void ignore_signals_of_writes();

}  // namespace pcvt::cli
