#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plugin/pcvt.h"

namespace pcvt::browser {

/// Names of tables in the file system of the module, as users of the command write them; empty
/// without one.
struct TableTexts {
    /// [FILE[:X,Y]] of the sites.
    std::string input = {};
    /// A law of areas, or [area:|diameter:|radius:]FILE[:COLUMN].
    std::string areas = {};
    /// [weight:|radius:|diameter:]FILE[:COLUMN].
    std::string weights = {};
};

/// A run in preparation, with the memory of its options, and its result.
struct Run {
    Run() { pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION); }

    pcvt_options options;
    pcvt_write_options write{};
    /// Texts of the options, which must not move.
    std::vector<std::string> texts = {};
    std::vector<double> sites = {};
    std::vector<double> areas = {};
    std::vector<double> weights = {};
    std::vector<double> orientations = {};
    std::vector<double> fixed = {};
    std::vector<std::int32_t> site_phases = {};
    TableTexts tables = {};
    /// The names of the phases of a table, with commas between them.
    std::string phase_names = {};
    /// The file of the sites, and the line of each of them; empty without a file.
    std::string site_file = {};
    std::vector<int> site_lines = {};
    pcvt_result* result = nullptr;
};

}  // namespace pcvt::browser
