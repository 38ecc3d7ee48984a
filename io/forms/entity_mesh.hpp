#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/forms/element_mesh.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The kind of a tile of tetrahedra in files; the kinds of the plane are those of file_word().
inline constexpr std::string_view kTetrahedraKind = "tetrahedra";

/// The entities of one dimension: points, curves, surfaces or volumes. Row k of each member is that
/// of entity k.
struct EntityList {
    /// Their numbers, which are above 0.
    std::vector<int> tags = {};
    /// The physical groups.
    Faces groups = {};
    /// The tags of the entities that bound it; negative where these run the other way.
    Faces boundary = {};
    /// The nodes inside, which lie on no entity of its boundary.
    Faces nodes = {};
    /// Indices of its elements.
    Faces elements = {};

    int size() const { return static_cast<int>(tags.size()); }
    void add(int tag, std::span<const int> of_groups, std::span<const int> of_boundary,
             std::span<const int> of_nodes, std::span<const int> of_elements);
};

/// A named set of entities of one dimension.
struct PhysicalGroup {
    int dimension;
    int number;
    std::string name;
};

/// One entity is the image of another one.
struct EntityLink {
    int dimension;
    int slave;
    int master;
    /// position(slave) = position(master) + translation, length units.
    std::array<double, 3> translation;
    /// Nodes of the slave and of the master, counted from 0.
    std::vector<std::array<int, 2>> nodes = {};
};

/// The elements of a tile by the entities on which they lie, with the names and the periodicity of
/// these.
///
/// Example usage:
///     const EntityMesh form = entity_mesh(tile);
///     for (const PhysicalGroup& group : form.groups) write(group.name);
struct EntityMesh {
    ElementMesh mesh;
    /// Elements of lower dimensions, which lie on curves and surfaces.
    std::array<ElementList, 3> sides = {};
    /// The entities of each dimension.
    std::array<EntityList, 4> entities = {};
    /// The dimensions whose elements files list, in this order. The elements that fill the tile
    /// have the first numbers.
    std::vector<int> listed = {};
    std::vector<PhysicalGroup> groups = {};
    /// No master is a slave of the same dimension, and slaves have the larger offsets.
    std::vector<EntityLink> links = {};
    /// For each element the orbit of the site of its cell under the symmetry of the run; may be
    /// empty.
    std::vector<int> element_orbit = {};
    /// A line of text that describes the file, and its kind.
    std::string title = {};
    std::string kind = {};
    /// Lines of text on its sites, each behind "pcvt ".
    std::string notes = {};

    const ElementList& elements(int dimension) const {
        return dimension == mesh.dimension ? mesh.elements : sides[std::size_t(dimension)];
    }
};

/// Triangles, and the lines on curves: those of cell_entities(). Groups are `cell_s` with the
/// number s + 1, the surface of site s; then `seam_I_J`, the curves that I a + J b takes to their
/// partners, by rising offset; then the curves on walls by the words of kWallSides, and on holes;
/// then `grain_boundary`, the curves between cells; then `phase_NAME`, the surfaces of the cells
/// with that phase, which are in two groups. Numbers of groups are distinct over the dimensions,
/// because GetDP has one list of groups for curves and surfaces. Links: each curve and point that
/// is not a master; a box between four walls has none.
///
/// @param materials    of the cells; null: no phases. Orientations are not stated.
/// @param site_orbits  of the sites of one period; empty: none.
/// @pre the tile consists of triangles.
EntityMesh entity_mesh(const plane::Tile& tile, const CellMaterials* materials = nullptr,
                       std::span<const int> site_orbits = {});

}  // namespace pcvt
