#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/tessellation/tessellation.hpp"

namespace pcvt::plane {

/// The walls of a domain and the cells at them.
struct WallChoice {
    Walls walls = Walls::kNone;
    WallCells cells = WallCells::kWhole;
};

/// Inclusions, and the words of their tags.
struct TaggedInclusions {
    /// Images that are listed as well are left out (without_listed_images()).
    std::vector<Inclusion> shapes = {};
    /// The words of the tags 0, 1, ...; 0 is the matrix.
    std::vector<std::string> tag_names = {};
    /// The words whose cells are left out.
    std::vector<std::string> holes = {};
    /// The corner of a box along which the cells will be cut: InclusionSet::set_box().
    std::optional<Vec2> box_corner = {};
};

/// Moves sites to a periodic CVT, between walls to a walled one.
///
/// Example usage:
///     const Lattice channel = Lattice::rectangle(4, 1);
///     const Points points = uniform_points(channel, 1000, 1);
///     const Tessellation cells = tessellate(channel, {.walls = Walls::kY}, points, CvtOptions());
///
/// @param points  2 x n, length units; between walls, if there are some.
/// @throws as compute_cvt() and compute_walled_cvt() do.
Tessellation tessellate(const Lattice& lattice, const WallChoice& walls, Points points,
                        const CvtOptions& options);

/// The same of sites with a symmetry.
Tessellation tessellate(const SymmetricSites& start, const CvtOptions& options);

/// Gives the cells of sites prescribed areas: power cells.
/// @throws as compute_area_cvt() and compute_walled_area_cvt() do.
Tessellation tessellate(const Lattice& lattice, const WallChoice& walls, Points points,
                        const AreaCvtOptions& options);

/// Gives the cells prescribed areas and centroids.
/// @throws as fit_areas_and_centroids() does.
Tessellation tessellate(const Lattice& lattice, const Points& centroids,
                        const AreaCvtOptions& options);

/// Gives sites that stay where they are the power cells of weights, length^2.
/// @throws as weighted_cells() and walled_weighted_cells() do.
Tessellation tessellate(const Lattice& lattice, Walls walls, const Points& points,
                        const Eigen::VectorXd& weights, const RunOptions& run);

/// Computes n cells of which each lies inside of an inclusion or outside of all, and proves that.
/// @throws as compute_interface_cvt() does.
/// @throws InternalError  an outline does not follow edges of the cells: a fault of pcvt.
Tessellation tessellate(const Lattice& lattice, const WallChoice& walls,
                        const TaggedInclusions& inclusions, int n, std::uint64_t seed,
                        const CvtOptions& options);

}  // namespace pcvt::plane
