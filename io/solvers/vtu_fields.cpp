#include "io/solvers/vtu_fields.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/xml_scanner.hpp"
#include "io/tiles/site_notes.hpp"

namespace pcvt {
namespace {

using Event = XmlScanner::Event;

/// SECTION/NAME of the arrays. The array of points may have any name.
constexpr std::array<std::string_view, 11> kArrays{"FieldData/PeriodicLattice",
                                                   "PointData/GlobalIds",
                                                   "PointData/PeriodicPointIds",
                                                   "PointData/PeriodicOffset",
                                                   "PointData/CellId",
                                                   "CellData/CellId",
                                                   "CellData/Orbit",
                                                   "Points/Points",
                                                   "Cells/connectivity",
                                                   "Cells/offsets",
                                                   "Cells/types"};

/// The numbers of 32 and 64 bits with a sign, which hold all ids and offsets, count as one type.
std::string_view type_class(std::string_view type) {
    return type == "Int32" || type == "Int64" ? "integers" : type;
}

/// Appends the fields of the array that begins here, and advances to its end.
void append_array(XmlScanner& scanner, bool with_values, std::vector<FileWord>& words) {
    words.push_back({type_class(scanner.attribute("type").value_or("")), scanner.line()});
    words.push_back({scanner.attribute("format").value_or("no format"), scanner.line()});
    words.push_back({scanner.attribute("NumberOfComponents").value_or("1"), scanner.line()});
    if (const auto tuples = scanner.attribute("NumberOfTuples")) {
        words.push_back({*tuples, scanner.line()});
    }
    scanner.for_each_word([&](std::string_view word, int line) {
        if (with_values) words.push_back({word, line});
    });
}

}  // namespace

bool is_vtu_array(std::string_view key) {
    constexpr std::string_view kFieldData = "FieldData/";
    for (const SiteNote& note : site_notes()) {
        if (key.starts_with(kFieldData) && key.substr(kFieldData.size()) == note.array) return true;
    }
    return std::find(kArrays.begin(), kArrays.end(), key) != kArrays.end();
}

std::optional<FileFields> vtu_fields(const std::string& name, std::string_view text) {
    FileFields fields{.name = name};
    XmlScanner scanner(name, text);
    std::string section;
    for (Event event = scanner.next(); event != Event::kNothing; event = scanner.next()) {
        if (event == Event::kEnd) continue;
        if (scanner.element() == "Piece") {
            for (const char* key : {"NumberOfPoints", "NumberOfCells"}) {
                fields.parts["the Piece"].push_back(
                    {scanner.attribute(key).value_or(""), scanner.line()});
            }
        } else if (scanner.element() == "DataArray") {
            const bool of_points = section == "Points";
            const std::string array(scanner.attribute("Name").value_or(""));
            const std::string key = section + "/" + (of_points ? "Points" : array);
            if (!is_vtu_array(key)) continue;
            append_array(scanner, !of_points, fields.parts[key]);
        } else {
            section = std::string(scanner.element());
            if (const auto ids = scanner.attribute("GlobalIds")) {
                fields.parts["the ids of " + section].push_back({*ids, scanner.line()});
            }
        }
    }
    return fields;
}

}  // namespace pcvt
