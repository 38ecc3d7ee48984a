#include "io/solvers/vtu_writer.hpp"

#include <utility>

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Appends a number and a blank.
template <class Number>
void append_vtk_word(std::string& text, Number number) {
    append_number(text, number);
    text += ' ';
}

/// Replaces the blank behind the last number by a line end.
void end_vtk_line(std::string& text) { text.back() = '\n'; }

/// Opens an array; `attributes` holds further attributes, each with a blank before it.
void open_vtk_array(std::string& text, std::string_view type, std::string_view name,
                    const std::string& attributes = "") {
    text.append("<DataArray type=\"").append(type).append("\" Name=\"").append(name);
    text.append("\"").append(attributes).append(" format=\"ascii\">\n");
}

void close_vtk_array(std::string& text) { text += "</DataArray>\n"; }

/// Appends numbers, `in_line` of them a line.
template <class Number>
void append_numbers(std::string& text, const std::vector<Number>& numbers, int in_line) {
    int left = in_line;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        append_vtk_word(text, numbers[k]);
        if (--left > 0) continue;
        end_vtk_line(text);
        left = in_line;
    }
}

void append_numbers(std::string& text, const std::vector<std::string>& strings, int) {
    for (const std::string& string : strings) {
        for (const char c : string) append_vtk_word(text, int{c});
        append_vtk_word(text, 0);
        end_vtk_line(text);
    }
}

std::size_t n_numbers(const std::vector<std::string>& strings) {
    std::size_t n = strings.size();
    for (const std::string& string : strings) n += string.size();
    return n;
}
std::size_t n_numbers(const auto& numbers) { return numbers.size(); }

void append_data(std::string& text, const VtuData& data, bool of_grid) {
    const auto width = static_cast<std::size_t>(data.n_components);
    std::string attributes;
    if (of_grid) {
        const std::size_t n = std::visit([](const auto& v) { return n_numbers(v); }, data.values);
        attributes = " NumberOfTuples=\"" + std::to_string(n / width) + '"';
    }
    if (width > 1) attributes += " NumberOfComponents=\"" + std::to_string(width) + '"';
    open_vtk_array(text, data.type, data.name, attributes);
    std::visit([&](const auto& values) { append_numbers(text, values, data.in_line); },
               data.values);
    close_vtk_array(text);
}

/// Appends the arrays of points or cells; nothing where there is none.
void append_section(std::string& text, const std::string& section,
                    const std::vector<VtuData>& arrays) {
    if (arrays.empty()) return;
    const bool has_ids = arrays.front().name == "GlobalIds";
    text += '<' + section + (has_ids ? " GlobalIds=\"GlobalIds\">\n" : ">\n");
    for (const VtuData& data : arrays) append_data(text, data, false);
    text += "</" + section + ">\n";
}

void append_points(std::string& text, const std::vector<std::array<double, 3>>& points) {
    text += "<Points>\n";
    open_vtk_array(text, "Float64", "Points", " NumberOfComponents=\"3\"");
    for (std::size_t v = 0; v < points.size(); ++v) {
        checkpoint_each(static_cast<long>(v));
        for (const double x : points[v]) append_vtk_word(text, x);
        end_vtk_line(text);
    }
    close_vtk_array(text);
    text += "</Points>\n";
}

/// Appends the numbers of each cell in a line.
void append_rows(std::string& text, std::string_view name, const Faces& rows) {
    open_vtk_array(text, "Int64", name);
    for (int c = 0; c < rows.n_faces(); ++c) {
        checkpoint_each(c);
        for (const int number : rows[c]) append_vtk_word(text, number);
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

/// Appends the end of each cell in an array of append_rows().
void append_ends(std::string& text, std::string_view name, const Faces& rows) {
    append_data(text, {"Int64", name, std::vector(rows.begin.begin() + 1, rows.begin.end())},
                false);
}

void append_cells(std::string& text, const VtuGrid& grid) {
    text += "<Cells>\n";
    append_rows(text, "connectivity", grid.cells.nodes);
    append_ends(text, "offsets", grid.cells.nodes);
    std::vector types(static_cast<std::size_t>(grid.cells.size()), grid.cells.type().vtk);
    append_data(text, {"UInt8", "types", std::move(types)}, false);
    if (grid.polyhedra.n_faces() > 0) {
        append_rows(text, "faces", grid.polyhedra);
        append_ends(text, "faceoffsets", grid.polyhedra);
    }
    text += "</Cells>\n";
}

}  // namespace

std::vector<EncodedFile> encode_vtu(const VtuGrid& grid, const std::string& path) {
    std::string text =
        "<?xml version=\"1.0\"?>\n" + std::string(grid.mark) +
        "\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n<FieldData>\n";
    for (const VtuData& data : grid.field_data) append_data(text, data, true);
    text += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(grid.points.size()) +
            "\" NumberOfCells=\"" + std::to_string(grid.cells.size()) + "\">\n";
    append_section(text, "PointData", grid.point_data);
    append_section(text, "CellData", grid.cell_data);
    append_points(text, grid.points);
    append_cells(text, grid);
    text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return only_file(path, std::move(text));
}

}  // namespace pcvt
