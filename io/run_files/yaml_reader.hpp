#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

/// A value of a YAML file: a mapping, a list, whose items are left out, or else a scalar.
///
/// Example usage:
///     const YamlValue file = parse_yaml("m.yaml", text, "phase");
///     if (const YamlValue* phase = file.find("phase")) read(*phase);
struct YamlValue {
    /// Of a scalar; of quoted ones without the quotes.
    std::string text = {};
    /// The line on which it begins.
    int line = 0;
    bool is_mapping = false;
    bool is_list = false;
    /// Of a mapping, in the order of the file.
    std::vector<std::pair<std::string, YamlValue>> members = {};

    /// The member of a mapping with a key; null if there is none.
    const YamlValue* find(std::string_view key) const;
};

/// Reads one section, a member of the mapping that a YAML file is, and leaves all others out:
/// mappings in blocks and in braces, plain and quoted scalars, comments. Lists and texts in several
/// lines (| and >) are skipped. Anchors, aliases, tags, and keys that are there twice are refused.
/// @returns a mapping with this member, or an empty one.
/// @throws BadFile with the line.
YamlValue parse_yaml(const std::string& name, std::string_view text, std::string_view section);

}  // namespace pcvt
