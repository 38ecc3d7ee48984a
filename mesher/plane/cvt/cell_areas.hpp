#pragma once

#include <Eigen/Core>

#include "mesher/plane/geometry/metric.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt::plane {

/// The areas of power cells, and how much rounding of their sites and weights changes them.
struct CellAreas {
    /// length^2
    Eigen::VectorXd area;
    /// The sum of l / 2 d over the edges of each cell, with l the length of an edge and d the
    /// distance of its two sites: an area changes by at most twice this when the power distances
    /// change by 1. Edges between images of one site do not move.
    Eigen::VectorXd sensitivity;
};

/// Power cells as a file states them.
struct StatedCells {
    Lattice lattice;
    /// The metric of elongated cells.
    Metric metric;
    /// The sides of the lattice's rectangle at which the cells end.
    Walls walls = Walls::kNone;
    /// 2 x n, length units.
    Points points;
    /// n, length^2.
    Eigen::VectorXd weights;
    /// The rounding of a position, length units, and of a weight, as a share of the largest one.
    double rounding;
    double weight_rounding;
};

/// The cell whose area differs most from its target, in units of the tolerance.
struct AreaComparison {
    SiteId site;
    /// length^2
    double area;
    /// |area - target| / target
    double error;
    /// file_area_tolerance(n), n with the mirror images between walls, or more where the rounding
    /// of the file changes the area by more.
    double tolerance;
};

/// The largest relative error of the areas that a file of n power cells may state.
double file_area_tolerance(int n_sites);

/// Builds the regular triangulation of sites with weights from scratch and measures their cells:
/// the proof of areas, independent of the run that computed the weights.
///
/// Example usage:
///
///     const CellAreas cells = power_cell_areas(Sites(lattice, points), weights);
///     const double error = (cells.area - wanted).cwiseQuotient(wanted).cwiseAbs().maxCoeff();
///
/// Laws, tested by number:
///   (1) The areas are those of the cells that the half-planes of all images cut out.
///   (2) They are the areas that were prescribed to compute_area_cvt().
///
/// @param weights  n, length^2.
/// @throws InvalidInput naming a site without a cell.
CellAreas power_cell_areas(const Sites& sites, const Eigen::VectorXd& weights);

/// The same for the parts of cells between walls, from sites and their mirror images. Edges on
/// walls do not move.
/// @param domain  upright.
/// @param points  2 x n, between the walls.
CellAreas power_cell_areas(const Lattice& domain, Walls walls, const Points& points,
                           const Eigen::VectorXd& weights);

/// Compares the areas of power_cell_areas() with target areas.
/// @param wanted  n, positive, length^2.
/// @throws InvalidInput as power_cell_areas() and Sites do.
AreaComparison compare_areas(const StatedCells& cells, const Eigen::VectorXd& wanted);

}  // namespace pcvt::plane
