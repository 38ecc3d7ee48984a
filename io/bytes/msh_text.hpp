#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

/// The dimensions of Gmsh's entities.
inline constexpr int kMshPoints = 0;
inline constexpr int kMshCurves = 1;
inline constexpr int kMshSurfaces = 2;

/// Gmsh's number of the element type of a tetrahedron of order 1.
inline constexpr int kMshTetrahedron = 4;

/// Appends numbers, each with a blank after it.
template <class Number>
void append_msh_words(std::string& text, std::initializer_list<Number> numbers) {
    for (const Number number : numbers) {
        append_number(text, number);
        text += ' ';
    }
}

/// Appends a row of numbers of an MSH file.
///
/// Example usage:
///     append_msh_line(text, {1, 4, 2});  // "1 4 2\n"
template <class Number>
void append_msh_line(std::string& text, std::initializer_list<Number> numbers) {
    append_msh_words(text, numbers);
    text.back() = '\n';
}

/// Appends a row of $PhysicalNames.
void append_msh_name(std::string& text, int dimension, int group, const std::string& name);

/// Appends the head of a link of $Periodic: slave = master + translation, as a 4 x 4 matrix row by
/// row, and the number of the pairs of nodes that follow.
void append_msh_link(std::string& text, int dimension, int slave, int master,
                     const std::array<double, 3>& translation, std::size_t n_nodes);

/// The value of an element or a node in a view.
struct MshValue {
    int number;
    int value;
};

/// Appends a view: a section with one row for each value.
/// @param section  "ElementData" or "NodeData".
/// @param values   in the order in which the file lists the elements or nodes: some programs,
/// meshio
///                 among them, skip the numbers in the rows.
void append_msh_data(std::string& text, const char* section, const char* view,
                     const std::vector<MshValue>& values);

}  // namespace pcvt
