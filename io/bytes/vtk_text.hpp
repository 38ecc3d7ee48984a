#pragma once

#include <string>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

/// VTK's numbers of the cell types.
inline constexpr int kVtkTriangle = 5;
inline constexpr int kVtkPolygon = 7;
inline constexpr int kVtkTetra = 10;
inline constexpr int kVtkQuadraticTriangle = 22;
inline constexpr int kVtkPolyhedron = 42;

// Arrays of VTK's XML files in ASCII:
//
//     open_vtk_array(text, "Int32", "PeriodicOffset", " NumberOfComponents=\"2\"");
//     for (const Offset& offset : offsets) {
//         append_vtk_word(text, offset.i);
//         append_vtk_word(text, offset.j);
//         end_vtk_line(text);
//     }
//     close_vtk_array(text);

/// Appends a number and a blank.
template <class Number>
void append_vtk_word(std::string& text, Number number) {
    append_number(text, number);
    text += ' ';
}

/// Replaces the blank behind the last number by a line end.
inline void end_vtk_line(std::string& text) { text.back() = '\n'; }

/// Opens an array; `attributes` holds further attributes, each with a blank before it.
void open_vtk_array(std::string& text, const char* type, const char* name,
                    const std::string& attributes = "");

void close_vtk_array(std::string& text);

/// Appends an array with one number a line.
void append_vtk_integers(std::string& text, const char* type, const char* name,
                         const std::vector<int>& values);

}  // namespace pcvt
