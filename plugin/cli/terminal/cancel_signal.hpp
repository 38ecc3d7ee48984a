#pragma once

namespace pcvt::cli {

/// From now on SIGINT and SIGTERM are only noted, for the run to end in good order.
void catch_cancel_signals();

/// The signal noted last, 0 if there was none.
int cancel_signal();

/// A file that meets the size limit then fails to be written (EFBIG) instead of ending the process.
void ignore_file_size_signal();

}  // namespace pcvt::cli
