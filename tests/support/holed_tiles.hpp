#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mesher/plane/cvt/interface_cvt.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/build_tile.hpp"

namespace pcvt::testing {

/// The holes of the inclusions with some tags, all of them with tags from 1 on, named "hole_<tag>".
inline plane::HoleSites holes_of(const std::vector<int>& site_tags, const std::vector<int>& tags) {
    plane::HoleSites holes;
    for (const int tag : tags) holes.names.push_back("hole_" + std::to_string(tag));
    for (const int tag : site_tags) {
        const auto found = std::find(tags.begin(), tags.end(), tag);
        holes.of_site.push_back(found == tags.end() ? -1 : static_cast<int>(found - tags.begin()));
    }
    return holes;
}

/// A tile of a square with two round holes of one name, one of them across a corner of the domain,
/// and a hole of another name with corners.
inline plane::Tile holed_tile(plane::TileOptions options, int n = 300) {
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 1);
    const std::vector<plane::Inclusion> shapes{
        {plane::Circle{{0.02, 0.97}, 0.15}, 1, 1},
        {plane::Circle{{0.5, 0.55}, 0.14}, 1, 2},
        {plane::Polygon{{0.3, 0.12}, {0.75, 0.15}, {0.7, 0.33}, {0.45, 0.3}}, 2, 3}};
    plane::CvtOptions few_steps;
    few_steps.run.max_iterations = 5;
    const plane::InterfaceCvt cvt =
        compute_interface_cvt(plane::InclusionSet(lattice, shapes), n, 3, few_steps);
    options.site_tags = cvt.tag;
    options.holes = holes_of(cvt.tag, {1, 2});
    return build_tile(cvt.cvt.delaunay, options).tile;
}

/// A tile of about 60 cells with one round hole across a corner of the domain.
inline plane::Tile tile_with_a_hole(plane::TileOptions options) {
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 1);
    plane::CvtOptions few_steps;
    few_steps.run.max_iterations = 5;
    const plane::InclusionSet set(lattice, {{plane::Circle{{0.02, 0.97}, 0.25}, 1, 1}});
    const plane::InterfaceCvt cvt = compute_interface_cvt(set, 80, 3, few_steps);
    options.site_tags = cvt.tag;
    options.holes = holes_of(cvt.tag, {1});
    return build_tile(cvt.cvt.delaunay, options).tile;
}

}  // namespace pcvt::testing
