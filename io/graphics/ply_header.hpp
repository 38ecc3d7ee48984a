#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/text.hpp"
#include "io/forms/note_table.hpp"

namespace pcvt {

/// The integers that a declared type holds.
struct PlyRange {
    std::int64_t least = 0;
    std::int64_t most = 0;
};

/// One declared property: `is_real` holds for float and double, `is_single` only for float.
struct PlyProperty {
    std::string_view name;
    bool is_real;
    bool is_single;
    bool is_list;
    /// The ranges of integers, and of the lengths of lists.
    PlyRange values;
    PlyRange lengths;
    /// As declared: "uchar", "list uchar int".
    std::string type;
};

/// One declared element: `element NAME COUNT`, and the properties after it.
struct PlyElement {
    std::string_view name;
    int count;
    std::vector<PlyProperty> properties;

    /// Returns the property of this name; nullptr if there is none.
    const PlyProperty* find(std::string_view property) const;
};

/// Reads the header of an ASCII PLY up to `end_header`.
/// @param name  the file's name in messages.
/// @param take_comment  takes the words behind `comment pcvt`.
/// @returns the elements in the order of their declaration; names point into the scanner's text.
/// @throws BadFile with the line, also for a binary PLY.
std::vector<PlyElement> read_ply_header(LineScanner& scanner, const std::string& name,
                                        const NoteTaker& take_comment);

/// The values of the current line by property: a number has one value, a list its items.
class PlyValues {
   public:
    explicit PlyValues(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) of_.emplace_back(property.name, 0);
    }

    /// Reads the numbers of the current line as `element` declares them.
    /// @throws BadFile with the line.
    void read(const LineScanner& scanner, const PlyElement& element);

    const std::vector<double>& list(std::string_view name) const;
    /// Returns 0 where the element lacks the property.
    double number(std::string_view name) const {
        const std::vector<double>& values = list(name);
        return values.empty() ? 0 : values.front();
    }
    int integer(std::string_view name) const { return static_cast<int>(number(name)); }

   private:
    std::vector<std::pair<std::string_view, std::vector<double>>> of_;
};

/// Reads the lines of an element and calls take(values) for each.
/// @throws BadFile with the line, also if the file ends before.
void read_ply_rows(LineScanner& scanner, const PlyElement& element,
                   const std::function<void(const PlyValues&)>& take);

/// Requires that no data follow the last element.
void require_ply_end(LineScanner& scanner);

}  // namespace pcvt
