#pragma once

namespace pcvt::cli {

/// From now on SIGINT and SIGTERM are only noted, so that the run can end in order:
///
///   catch_cancel_signals();
///   run_job(job, [](const JobProgress&) { return cancel_signal() == 0; });
void catch_cancel_signals();

/// The last signal noted, or 0.
int cancel_signal();

/// From now on a file that reaches the size limit makes the write fail (EFBIG), and does not end
/// the process.
void ignore_file_size_signal();

}  // namespace pcvt::cli
