#pragma once

namespace pcvt::cli {

/// Ends of the command for lack of memory: the message and the exit code (ExitCode::kLimit).
inline constexpr const char* kOutOfMemory =
    "pcvt: out of memory; take fewer sites or a larger machine";
inline constexpr int kOutOfMemoryCode = 4;

// The start of the command runs code of libraries that cannot report a lack of memory: initialisers
// before main(), whose exceptions nothing catches, and functions of CLI11 that are noexcept. A
// guard that exists from the first instruction turns their ends into kOutOfMemory and
// kOutOfMemoryCode. Nothing is written before it ends.
//
//   int main() {
//       begin_main();
//       const Job job = make_job(app, options);
//       end_start_guard();
//       return run_mesh(job);
//   }

/// Ends the part of the guard for initialisers: abort() and exit() regain their usual effect.
void begin_main();

/// Ends the rest of it: std::terminate() regains its usual effect.
void end_start_guard();

}  // namespace pcvt::cli
