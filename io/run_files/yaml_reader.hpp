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
///     const YamlValue file = parse_yaml("m.yaml", text);
///     if (const YamlValue* phase = file.find("phase")) read(*phase);
struct YamlValue {
    /// Of a scalar, without its quotes.
    std::string text = {};
    /// The line of the key of a member, else the line on which the value begins; from 1 on.
    int line = 0;
    bool is_mapping = false;
    bool is_list = false;
    /// Of a mapping, in the order of the file.
    std::vector<std::pair<std::string, YamlValue>> members = {};

    /// The member of a mapping with a key; null if there is none.
    const YamlValue* find(std::string_view key) const;
};

/// Reads a file of one YAML document by yaml-cpp. Aliases are replaced by what they name. Keys that
/// are there twice, keys that are not words, and more than 32 mappings inside of each other are
/// refused.
/// @throws BadFile with the line.
YamlValue parse_yaml(const std::string& name, std::string_view text);

}  // namespace pcvt
