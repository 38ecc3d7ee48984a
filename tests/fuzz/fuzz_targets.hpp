#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt::testing {

/// One kind of input that pcvt reads from users: a row of fuzz_targets().
///
/// Example usage:
///   const FuzzTarget* target = find_fuzz_target("obj");
///   for (const std::string& seed : target->seeds()) run_fuzz_input(*target, seed);
struct FuzzTarget {
    std::string_view name;
    /// Reads the bytes and proves their content.
    std::function<void(const std::string& bytes)> read;
    /// Valid inputs, made by the writers where there are any. The same on every run.
    std::function<std::vector<std::string>()> seeds;
};

/// All targets: each format that `pcvt check` reads, under its extension, and the other inputs.
const std::vector<FuzzTarget>& fuzz_targets();

/// The target of this name, nullptr if there is none.
const FuzzTarget* find_fuzz_target(std::string_view name);

/// Reads the bytes, which the target may accept, or refuse by InvalidInput or LimitExceeded with a
/// message of one printable line.
/// @returns  the violation of this rule; empty if there is none.
std::string run_fuzz_input(const FuzzTarget& target, const std::string& bytes);

/// The files of a format with companions as one input, and back. The input of a format without
/// companions is the file itself.
std::string join_files(const std::vector<std::string>& files);
std::vector<std::string> split_files(std::string_view bytes);

}  // namespace pcvt::testing
