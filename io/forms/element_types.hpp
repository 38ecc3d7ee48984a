#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace pcvt {

/// The elements of meshes in files. Elements of two nodes and more have straight sides.
enum class ElementKind {
    kPoint,
    kLine2,
    kLine3,
    kPolygon,
    kTriangle3,
    kTriangle6,
    kTetrahedron4,
    kTetrahedron10,
    kWedge6,
    kWedge15,
    kPolyhedron
};

/// One row of the table of elements. The corners come first among the nodes of an element; then
/// follow the nodes in the middle of its edges, in the order of VTK, Abaqus and CalculiX. Gmsh has
/// the same order, but for exchanges_last.
struct ElementType {
    ElementKind kind;
    int dimension;
    /// 0: any number.
    int n_corners;
    int n_nodes;
    /// The numbers of the type in Gmsh's and in VTK's files; 0: the format has no such type.
    int msh;
    int vtk;
    std::string_view word;
    std::string_view words;
    /// Gmsh's files exchange the last two nodes.
    bool exchanges_last = false;

    /// The node at place k in Gmsh's files, and the place there of node k.
    constexpr std::size_t place_in_msh(std::size_t k) const {
        const auto n = static_cast<std::size_t>(n_nodes);
        return exchanges_last && k + 2 >= n ? 2 * n - 3 - k : k;
    }
};

inline constexpr std::array kElementTypes{
    ElementType{ElementKind::kPoint, 0, 1, 1, 15, 1, "point", "points"},
    ElementType{ElementKind::kLine2, 1, 2, 2, 1, 3, "line", "lines"},
    ElementType{ElementKind::kLine3, 1, 2, 3, 8, 21, "line", "quadratic lines"},
    ElementType{ElementKind::kPolygon, 2, 0, 0, 0, 7, "polygon", "polygons"},
    ElementType{ElementKind::kTriangle3, 2, 3, 3, 2, 5, "triangle", "triangles"},
    ElementType{ElementKind::kTriangle6, 2, 3, 6, 9, 22, "triangle", "quadratic triangles"},
    ElementType{ElementKind::kTetrahedron4, 3, 4, 4, 4, 10, "tetrahedron", "tetrahedra"},
    ElementType{ElementKind::kTetrahedron10, 3, 4, 10, 11, 24, "tetrahedron",
                "quadratic tetrahedra", true},
    // The bottom triangle, the top one, and the middles of the edges of both and between them.
    ElementType{ElementKind::kWedge6, 3, 6, 6, 0, 0, "wedge", "wedges"},
    ElementType{ElementKind::kWedge15, 3, 6, 15, 0, 0, "wedge", "quadratic wedges"},
    ElementType{ElementKind::kPolyhedron, 3, 0, 0, 0, 42, "polyhedron", "polyhedra"},
};

/// Example usage:
///     append_number(text, element_type(ElementKind::kTriangle6).msh);  // 9
constexpr const ElementType& element_type(ElementKind kind) {
    return kElementTypes[static_cast<std::size_t>(kind)];
}

static_assert(std::all_of(kElementTypes.begin(), kElementTypes.end(), [](const ElementType& type) {
    return &element_type(type.kind) == &type;
}));

/// The type with a number in a format; null if there is none.
///
/// Example usage:
///     const ElementType* const type = find_element_type(&ElementType::vtk, 10);
constexpr const ElementType* find_element_type(int ElementType::*format, int number) {
    const auto* const found =
        std::find_if(kElementTypes.begin(), kElementTypes.end(),
                     [&](const ElementType& type) { return type.*format == number; });
    return number == 0 || found == kElementTypes.end() ? nullptr : found;
}

}  // namespace pcvt
