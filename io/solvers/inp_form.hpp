#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/forms/element_mesh.hpp"

namespace pcvt {

/// A named set of nodes or of elements, counted from 0.
struct InpSet {
    std::string name;
    std::vector<int> members = {};
    /// Whether solvers must keep the order of the members.
    bool is_ordered = false;
    /// Whether the set is for boundary conditions, and so has no tied node.
    bool is_free = false;
};

/// A named surface: elements, counted from 0, each with one of its sides, counted from 1 as Abaqus
/// numbers them.
struct InpSurface {
    std::string name;
    std::vector<std::array<int, 2>> sides = {};
};

/// A node that moves with its representative and the mean strain.
struct InpTie {
    int node;
    int representative;
    /// position(node) = position(representative) + translation, length units.
    std::array<double, 3> translation;
};

/// The content of an Abaqus or CalculiX input, in the plane or in space.
///
/// Example usage:
///     text += inp_text(inp_form(mesh, options), path);
struct InpForm {
    ElementMesh mesh;
    /// The name of the type of the elements: "CPE3".
    std::string element = {};
    /// Lines of text for people, the kind of the tile, and lines of notes with their marks.
    std::string explanation = {};
    std::string kind = {};
    std::string notes = {};
    /// Whether the mean strain moves the tile: it then has control nodes, and FIXED holds node 1.
    bool is_strained = true;
    /// By rising nodes; a representative is the node of no tie.
    std::vector<InpTie> ties = {};
    /// The sets of the elements of cells, by rising sites.
    std::vector<InpSet> cells = {};
    /// Cards that unite sets of cells.
    std::string orbits = {};
    std::vector<InpSet> node_sets = {};
    std::vector<InpSurface> surfaces = {};
    /// Sections, materials and steps.
    std::string job = {};
};

}  // namespace pcvt
