#pragma once

#include <optional>
#include <string>

namespace pcvt {

/// The memory that this process may still take, in bytes: the least of the memory that the machine
/// has available (with its swap), of the address space that a limit leaves (`ulimit -v`), and of
/// the rest of each control group; `nullopt` where the system does not say.
///
/// Example usage:
///
///     const std::optional<double> available = available_memory();
///     if (available && needed > *available) throw LimitExceeded("...");
std::optional<double> available_memory();

/// The largest memory that this process has had resident so far, in bytes; `nullopt` where the
/// system does not say.
std::optional<double> peak_memory();

}  // namespace pcvt
