#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "io/forms/file_options.hpp"

namespace pcvt {

struct Job;

/// The values of a field of pcvt.h that leave an option at its default.
enum class UnsetField { kZero, kNegative, kNone };

/// An option whose value is one number, as the command, its help, pcvt.h and Python know it. All of
/// them read such options from this table, in the plane and in space; an option that only one
/// dimension has, or that contradicts others, has a row of features.hpp besides.
///
/// Example usage:
///   for (const NumberRow& row : number_options()) set_number(row, job, 0.25);
struct NumberRow {
    /// "--tolerance".
    std::string option;
    /// Its field of pcvt.h.
    std::string field;
    /// The heading of the help that it belongs to, its form there, and its description.
    const char* group;
    const char* form;
    std::string help;
    /// Where a run, or a file, keeps it.
    std::variant<double& (*)(Job&), int& (*)(Job&), double FileOptions::*, int FileOptions::*> of;
    /// The limits of a whole number on the command line; real numbers are positive there.
    int lowest = 0;
    int highest = 0;
    UnsetField unset = UnsetField::kZero;

    bool is_whole() const { return of.index() % 2 == 1; }
    bool is_of_files() const { return of.index() >= 2; }
};

/// In the order of the help.
std::span<const NumberRow> number_options();

/// The row of an option of the command, nullptr for another kind of option.
const NumberRow* find_number_option(std::string_view option);

/// Sets a number of a job, or of the form of its files.
/// @pre a whole number where the option takes one.
void set_number(const NumberRow& row, Job& job, double value);
/// @pre row.is_of_files().
void set_number(const NumberRow& row, FileOptions& options, double value);

}  // namespace pcvt
