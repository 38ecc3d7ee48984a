#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// The periodic power diagram from a Euclidean one: the paper's mirrors (section III,
/// mirror_diagram.hpp) for sites with weights.
///
///   paper | code
///   D_0   | the half-open parallelogram [0, 1)^2 of the reduced basis
///   x_i,j | the image (i, offset)
///
/// Example usage:
///
///     const PowerMirrors diagram = power_mirrors(sites, weights);
///     const TorusTriangulation regular(sites.n_sites(), diagram.triangles);
///
/// The paper's rule needs a start inside of the domain: the Voronoi cell of a site in D_0 meets
/// D_0, because it contains the site. A power cell may lie beside its site. It never leaves the
/// Voronoi cell of its site among only the images of that site, because these have equal weights,
/// and therefore meets D_0 in one of the nine domains around it. So a site without a piece in D_0
/// takes the images that its own cell, cut off at these nine domains, requires; from there on the
/// rule is the paper's.
struct PowerMirrors {
    /// The 2 n triangles with orthocentres in D_0, one of each orbit; fewer if a site has no cell.
    std::vector<Triangle> triangles;
    /// Number of images inserted in addition to the n sites.
    int n_mirrors = 0;
};

/// @param weights  of each site, units of the Gram matrix of the reduced basis.
PowerMirrors power_mirrors(const Sites& sites, const Eigen::VectorXd& weights);

/// The slow reference method: triangulates all 3 x 3 copies of the sites.
PowerMirrors power_copies(const Sites& sites, const Eigen::VectorXd& weights);

}  // namespace pcvt::plane
