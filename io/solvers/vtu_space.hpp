#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/solvers/vtu_arrays.hpp"
#include "mesher/space/geometry/lattice.hpp"

namespace pcvt {

// Parts of VTU files in space, of polyhedra and of tetrahedra.

inline constexpr std::string_view kOrientationArray = "CellData/Orientation";

/// Returns the points.
/// @throws BadFile  unless they are doubles.
std::vector<space::Vec3> read_vtu_points(const VtuArrays& arrays);

/// Reads the phases and orientations of cells.
/// @param cell_of  the cell of each element: cell by cell, without a gap.
/// @throws BadFile  with the line.
CellMaterials read_vtu_materials(const VtuArrays& arrays, const std::vector<SiteId>& cell_of);

/// The images that a file states for its points.
///
/// Example usage:
///     StatedImages(arrays).compare(mesh.point_orbit, mesh.point_offset);
class StatedImages {
   public:
    /// @throws BadFile  the images are not one for each point.
    explicit StatedImages(const VtuArrays& arrays);

    /// Returns the largest distance of a point from its image, in one coordinate, length units; 0
    /// if the file states none.
    double mismatch(const space::Lattice& lattice, const std::vector<space::Vec3>& points) const;

    /// Compares the images, if the file states any, with those of its points.
    /// @throws BadFile  naming the point.
    void compare(const std::vector<int>& orbits, const std::vector<space::Offset>& offsets) const;

   private:
    space::Offset offset(std::size_t v) const {
        return {offsets_->integer(3 * v), offsets_->integer(3 * v + 1),
                offsets_->integer(3 * v + 2)};
    }

    const XmlScanner& scanner_;
    const VtuArray* orbits_ = nullptr;
    const VtuArray* offsets_ = nullptr;
};

}  // namespace pcvt
