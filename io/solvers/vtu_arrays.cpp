#include "io/solvers/vtu_arrays.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/text.hpp"
#include "io/forms/site_notes.hpp"
#include "mesher/cells/phase_fractions.hpp"

namespace pcvt {
namespace {

using Event = XmlScanner::Event;

/// SECTION/NAME of the arrays. The array of points may have any name.
constexpr std::array<std::string_view, 16> kArrays{"FieldData/PeriodicLattice",
                                                   "FieldData/PhaseNames",
                                                   "FieldData/SitePhases",
                                                   "FieldData/HoleNames",
                                                   "FieldData/HoleEdges",
                                                   "PointData/GlobalIds",
                                                   "PointData/PeriodicPointIds",
                                                   "PointData/PeriodicOffset",
                                                   "PointData/CellId",
                                                   "CellData/CellId",
                                                   "CellData/Orbit",
                                                   "CellData/Phase",
                                                   "Points/Points",
                                                   "Cells/connectivity",
                                                   "Cells/offsets",
                                                   "Cells/types"};

/// The numbers of 32 and 64 bits with a sign, which hold all ids and offsets, count as one type.
std::string_view type_class(std::string_view type) {
    return type == "Int32" || type == "Int64" ? "integers" : type;
}

/// Appends the type, the form and the sizes of the array that begins here.
void append_attributes(const XmlScanner& scanner, std::vector<FileWord>& words) {
    words.push_back({type_class(scanner.attribute("type").value_or("")), scanner.line()});
    words.push_back({scanner.attribute("format").value_or("no format"), scanner.line()});
    words.push_back({scanner.attribute("NumberOfComponents").value_or("1"), scanner.line()});
    if (const auto tuples = scanner.attribute("NumberOfTuples")) {
        words.push_back({*tuples, scanner.line()});
    }
}

/// Whether SECTION/NAME holds names, in a String array in files of earlier versions.
bool holds_names(std::string_view key) {
    return key == "FieldData/PhaseNames" || key == "FieldData/HoleNames";
}

/// "polygons (7), all triangles (5) or all quadratic triangles (22)"
std::string in_words(std::initializer_list<ElementKind> kinds) {
    std::string text;
    for (const ElementKind& kind : kinds) {
        const bool last = &kind + 1 == kinds.end();
        const ElementType& type = element_type(kind);
        if (!text.empty()) text += last ? " or all " : ", all ";
        text += std::string(type.words) + " (" + std::to_string(type.vtk) + ")";
    }
    return text;
}

/// Requires that a cell has as many points as its type, and that these exist.
void require_points(const VtuArrays& arrays, const ElementType& type, std::span<const int> points,
                    int line) {
    const auto wanted = static_cast<std::size_t>(type.n_nodes);
    if (wanted == 0) return;
    if (points.size() != wanted) {
        arrays.scanner().throw_bad_file(
            line, "a " + std::string(type.word) + " here has " + std::to_string(wanted) +
                      " points, not " + std::to_string(points.size()) + "; correct the offsets");
    }
    for (const int v : points) {
        if (v >= 0 && v < arrays.n_points()) continue;
        arrays.scanner().throw_bad_file(
            line, "point " + std::to_string(v) + " does not exist; correct the index");
    }
}

/// Whether SECTION/NAME is an array that encode_vtu() writes.
bool is_vtu_array(std::string_view key) {
    constexpr std::string_view kFieldData = "FieldData/";
    for (const SiteNote& note : site_notes()) {
        if (key.starts_with(kFieldData) && key.substr(kFieldData.size()) == note.array) return true;
    }
    return std::find(kArrays.begin(), kArrays.end(), key) != kArrays.end();
}

}  // namespace

VtuArrays::VtuArrays(const std::string& name, std::string_view text,
                     std::span<const std::string_view> further)
    : scanner_(name, text) {
    if (scanner_.next() != Event::kBegin || scanner_.element() != "VTKFile" ||
        scanner_.attribute("type") != "UnstructuredGrid") {
        throw BadFile(name + ": is not a VTKFile with an UnstructuredGrid; give a VTU");
    }
    std::string section;
    for (Event event = scanner_.next(); event != Event::kNothing; event = scanner_.next()) {
        if (event == Event::kEnd) continue;
        if (scanner_.element() == "Piece") {
            read_piece();
        } else if (scanner_.element() == "DataArray") {
            read_array(section, further);
        } else {
            section = std::string(scanner_.element());
        }
    }
    if (n_points_ < 0) throw BadFile(name + ": holds no Piece; give a VTU with a grid");
}

const VtuArray* VtuArrays::find(const std::string& key) const {
    const auto found = arrays_.find(key);
    return found == arrays_.end() ? nullptr : &found->second;
}

const VtuArray& VtuArrays::get(const std::string& key, int n_tuples, int n_components,
                               bool of_integers) const {
    const VtuArray* array = find(key);
    if (array == nullptr) {
        throw BadFile(scanner_.name() + ": lacks the array " + key + "; export the file with it");
    }
    const auto wanted =
        static_cast<std::size_t>(std::max(n_tuples, 0)) * static_cast<std::size_t>(n_components);
    if (array->n_components != n_components || (n_tuples >= 0 && array->size() != wanted) ||
        (of_integers && array->is_real())) {
        scanner_.throw_bad_file(array->line, "the array " + key + " has not the size or type of " +
                                                 "its kind; write the file again");
    }
    return *array;
}

int VtuArrays::count(std::string_view key) const {
    const auto word = scanner_.attribute(key);
    if (!word)
        scanner_.throw_bad_file(scanner_.line(),
                                "the Piece lacks " + std::string(key) + "; add it");
    const int n = integer(*word, scanner_.line());
    if (n < 0) scanner_.throw_bad_file(scanner_.line(), "a count is negative; correct it");
    return n;
}

int VtuArrays::integer(std::string_view word, int line) const {
    try {
        return parse_integer(word);
    } catch (const InvalidInput& fault) {
        scanner_.throw_bad_file(line, fault.what());
    }
}

void VtuArrays::read_piece() {
    if (n_points_ >= 0)
        scanner_.throw_bad_file(scanner_.line(), "there is a second Piece; merge the pieces");
    n_points_ = count("NumberOfPoints");
    n_cells_ = count("NumberOfCells");
}

void VtuArrays::read_array(const std::string& section, std::span<const std::string_view> further) {
    // The array of points may have any name.
    const std::string name(scanner_.attribute("Name").value_or(""));
    const std::string key = section + "/" + (section == "Points" ? "Points" : name);
    const bool wanted = std::find(further.begin(), further.end(), key) != further.end();
    if (!wanted && !is_vtu_array(key)) return;
    if (scanner_.attribute("format").value_or("ascii") != "ascii") {
        scanner_.throw_bad_file(scanner_.line(),
                                "the array " + key + " is binary; export it as ASCII");
    }
    VtuArray array{.line = scanner_.line(),
                   .type = std::string(scanner_.attribute("type").value_or(""))};
    const auto components = scanner_.attribute("NumberOfComponents");
    if (components) array.n_components = integer(*components, scanner_.line());
    // VTK may nest elements with ranges in an array; its numbers are only its own text.
    scanner_.for_each_word([&](std::string_view word, int line) { add_value(word, line, array); });
    if (!arrays_.emplace(key, std::move(array)).second) {
        scanner_.throw_bad_file(scanner_.line(),
                                "the array " + key + " is there twice; remove one");
    }
}

void VtuArrays::add_value(std::string_view word, int line, VtuArray& array) const {
    try {
        array.values.push_back(array.is_real() ? parse_number(word) : parse_integer(word));
    } catch (const InvalidInput& fault) {
        scanner_.throw_bad_file(line, fault.what());
    }
    array.lines.push_back(line);
}

ElementList read_vtu_cells(const VtuArrays& arrays, std::initializer_list<ElementKind> kinds) {
    const XmlScanner& scanner = arrays.scanner();
    const VtuArray& corners = arrays.get("Cells/connectivity", -1, 1, true);
    const VtuArray& ends = arrays.get("Cells/offsets", arrays.n_cells(), 1, true);
    const VtuArray& types = arrays.get("Cells/types", arrays.n_cells(), 1, true);
    ElementList cells;
    // The offsets are the ends of the cells in the connectivity.
    std::size_t begin = 0;
    for (std::size_t c = 0; c < ends.size(); ++c) {
        const auto end = static_cast<std::size_t>(std::max(ends.integer(c), 0));
        if (end <= begin || end > corners.size()) {
            scanner.throw_bad_file(ends.lines[c],
                                   "the offsets do not rise within the connectivity; correct them");
        }
        const ElementType* const type = find_element_type(&ElementType::vtk, types.integer(c));
        const bool is_wanted = type != nullptr && (c == 0 || type->kind == cells.kind) &&
                               std::find(kinds.begin(), kinds.end(), type->kind) != kinds.end();
        if (!is_wanted) {
            const bool in_plane = element_type(*kinds.begin()).dimension == 2;
            scanner.throw_bad_file(types.lines[c],
                                   std::string(in_plane ? "the faces" : "the cells") +
                                       " are not all " + in_words(kinds) + "; give such a grid");
        }
        cells.kind = type->kind;
        const int line = corners.lines[begin];
        for (; begin < end; ++begin) cells.nodes.corners.push_back(corners.integer(begin));
        cells.nodes.close();
        require_points(arrays, *type, cells.nodes[static_cast<int>(c)], line);
    }
    if (begin != corners.size()) {
        scanner.throw_bad_file(corners.line,
                               "the connectivity has entries after its last face; "
                               "correct the offsets");
    }
    return cells;
}

std::vector<std::string> read_vtu_strings(const VtuArrays& arrays, const std::string& key) {
    const VtuArray& array = arrays.get(key, -1, 1, true);
    std::vector<std::string> strings(1);
    for (std::size_t k = 0; k < array.size(); ++k) {
        const int code = array.integer(k);
        if (code == 0) {
            strings.emplace_back();
        } else if (code > ' ' && code <= '~') {
            strings.back() += static_cast<char>(code);
        } else {
            arrays.scanner().throw_bad_file(
                array.lines[k], "a name holds a character that is none; write the file again");
        }
    }
    if (!strings.back().empty()) {
        arrays.scanner().throw_bad_file(array.line,
                                        "a name does not end with 0; write the file again");
    }
    strings.pop_back();
    return strings;
}

void read_vtu_phases(const VtuArrays& arrays, const std::string& key, int n,
                     CellMaterials& materials) {
    materials.phase_names = read_vtu_strings(arrays, "FieldData/PhaseNames");
    try {
        require_phase_names(materials.phase_names);
    } catch (const InvalidInput& fault) {
        arrays.scanner().throw_bad_file(arrays.find("FieldData/PhaseNames")->line, fault.what());
    }
    const VtuArray& phases = arrays.get(key, n, 1, true);
    const auto n_phases = static_cast<int>(materials.phase_names.size());
    for (std::size_t k = 0; k < phases.size(); ++k) {
        materials.site_phase.push_back(phases.integer(k));
        if (phases.integer(k) >= 0 && phases.integer(k) < n_phases) continue;
        arrays.scanner().throw_bad_file(phases.lines[k],
                                        "a site has a phase without a name; write the file again");
    }
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
            std::vector<FileWord>& words = fields.parts[key];
            if (!holds_names(key)) append_attributes(scanner, words);
            scanner.for_each_word([&](std::string_view word, int line) {
                if (!of_points) words.push_back({word, line});
            });
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
