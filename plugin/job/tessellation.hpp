#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesher/plane/areas/area_newton.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/energy/stability.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/interfaces/inclusion.hpp"
#include "mesher/plane/mesh/elongated_mesh.hpp"
#include "mesher/plane/tile/tile_holes.hpp"

namespace pcvt {

struct Job;
struct JobStart;
class JobMonitor;

/// The numbers of a run with inclusions.
struct InterfaceFigures {
    /// The file of the shapes, or their law.
    std::string source;
    /// As given or drawn.
    std::vector<plane::Inclusion> shapes = {};
    bool are_drawn = false;
    int n_chords = 0;
    /// Sites in pairs beside the chords, which do not move.
    int n_fixed = 0;
    /// Sites that ended at a circle round the end of a chord, where they would have moved on.
    int n_held = 0;
};

/// The tessellation of a run: Voronoi cells, or power cells of prescribed areas, in the plane or in
/// a metric. Meshes and positions that follow from it lie in the plane of the user.
///
/// Example usage:
///     const PeriodicMesh cells = plane_mesh(tessellation, MeshKind::kVoronoi);
///     const Points sites = wrapped_sites(tessellation, job.tile.origin);
struct Tessellation {
    /// In the round space of `elongation`, if there is one. With weights in a run with areas.
    plane::PeriodicDelaunay delaunay;
    /// Of elongated cells.
    std::optional<plane::Elongation> elongation = {};
    /// Of a run with walls: `delaunay` is that of the domain and its mirror images.
    std::optional<plane::WalledDomain> walled = {};
    /// Energy and residuals are those of the round space; with walls, of the domain.
    RunStatistics run;
    plane::DelaunayCounts counts;
    /// Of a run with a density.
    std::optional<plane::DensityFigures> density = {};
    /// Of a run with areas.
    std::optional<SizeFigures> areas = {};

    /// Of a run with a symmetry: the orbit of each site. Orbits are counted from 0 in the order of
    /// their first sites.
    std::vector<int> site_orbits = {};
    /// Of a run with inclusions: the tag of each site, 0 for the matrix, and for each tag its word
    /// and the area of its shapes, length^2.
    std::vector<int> site_tags = {};
    std::vector<std::string> tag_names = {};
    std::vector<double> tag_areas = {};
    std::optional<InterfaceFigures> interfaces = {};
    /// The sites of a run with holes.
    plane::HoleSites holes = {};

    /// That of the user.
    const plane::Lattice& lattice() const {
        if (walled) return walled->lattice;
        return elongation ? elongation->lattice : delaunay.sites().lattice();
    }
    int n_sites() const { return walled ? walled->n_sites : delaunay.sites().n_sites(); }
    /// Of sites; 0 without a symmetry.
    int n_orbits() const {
        return site_orbits.empty() ? 0
                                   : *std::max_element(site_orbits.begin(), site_orbits.end()) + 1;
    }
};

/// Computes the tessellation of a job that has no aspect, from its start, whose points and areas
/// are moved from.
/// @param built  called once the first triangulation is built and evaluated.
Tessellation tessellate(const Job& job, JobStart& start, JobMonitor& monitor,
                        const std::function<void()>& built);

/// The metric of the job's aspect.
plane::Metric metric_of(const Job& job);
/// The job with its lattice, sites and density mapped to the round space of a metric.
Job in_round_space(const Job& job, const plane::Metric& metric);

/// periodic_mesh() in the plane, or with walls the mesh between them.
plane::PeriodicMesh plane_mesh(const Tessellation& tessellation, plane::MeshKind kind);

/// plane_mesh() without the faces in holes.
plane::PeriodicMesh mesh_outside_holes(const Tessellation& tessellation, plane::MeshKind kind);

/// The number of sides of each site's cell, of those longer than kShortEdge h in the plane.
std::vector<int> cell_sides(const Tessellation& tessellation);

/// The figures of a run with prescribed areas.
struct AreaSummary {
    SizeFigures newton;
    /// The factor that took given areas to the area of the domain; `nullopt` for those of a law.
    std::optional<double> scale = {};
    /// Standard deviation over mean of the equivalent diameters.
    double std_over_mean = 0;
    /// Of the cells (cell_table.hpp).
    double circularity_mean = 0;
    double circularity_std = 0;
};

AreaSummary area_summary(const Tessellation& tessellation);

/// The weights of the sites, length^2; empty without areas.
Eigen::VectorXd site_weights(const Tessellation& tessellation);

/// The sites outside of holes, 2 x n, wrapped into the Domain at `origin`, as in `.txt` files.
plane::Points wrapped_sites(const Tessellation& tessellation, const plane::Vec2& origin);

/// The sites of a run at the iteration that `progress` reports, 2 x n, as wrapped_sites() gives
/// them once the run has ended; sites inside holes are among them. Empty where they are not known.
plane::Points progress_sites(const Job& job, const Progress& progress);

/// The energy of as many regular hexagons (hexagonal_bound()) in the area of the domain. The cells
/// of sites on walls count as what lies between the walls.
double energy_bound(const Tessellation& tessellation);

/// Whether the sites are at a minimum of the energy, according to its Hessian; `nullopt` if the run
/// did not converge, has a density or areas, or has more than kMostSitesForStability sites. Cost:
/// of order n^1.5.
std::optional<Minimum> minimum_of(const Tessellation& tessellation);

}  // namespace pcvt
