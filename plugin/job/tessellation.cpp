#include "plugin/job/tessellation.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/areas/area_cvt.hpp"
#include "mesher/plane/cvt/walled_area_cvt.hpp"
#include "mesher/plane/cvt/walled_cvt.hpp"
#include "mesher/plane/geometry/domain.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_constraints.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt {
namespace {

/// Numbers orbits in the order of their first sites.
std::vector<int> counted_by_sites(std::vector<int> site_orbits) {
    std::vector<int> number(site_orbits.size(), -1);
    int n_orbits = 0;
    for (int& orbit : site_orbits) {
        if (number[orbit] < 0) number[orbit] = n_orbits++;
        orbit = number[orbit];
    }
    return site_orbits;
}

Tessellation compute_cells(const Job& job, JobStart& start, JobMonitor& monitor,
                           const std::function<void()>& built) {
    plane::CvtOptions options;
    options.run = job.run;
    options.precondition_below = start.precondition_below;
    options.numbering = start.numbering;
    options.density = job.density;
    options.fixed.resize(static_cast<std::size_t>(job.in_plane().fixed.cols()));
    std::iota(options.fixed.begin(), options.fixed.end(), 0);
    options.run.progress = [&, first = true](const Progress& progress) mutable {
        // The first call comes once the first triangulation is built and evaluated.
        if (std::exchange(first, false)) built();
        return monitor.iteration(progress);
    };
    if (job.has_inclusions()) return compute_cells_with_inclusions(job, options);
    if (job.walls != Walls::kNone) {
        plane::WalledCvt walled = compute_walled_cvt(
            job.in_plane().lattice, job.walls, job.wall_cells, std::move(start.points), options);
        return {.delaunay = std::move(walled.torus.delaunay),
                .walled = walled.domain,
                .run = walled.torus.run,
                .counts = walled.torus.counts,
                .density = walled.torus.density};
    }
    plane::CvtResult cvt =
        start.symmetric ? compute_cvt(*start.symmetric, options)
                        : compute_cvt(job.in_plane().lattice, std::move(start.points), options);
    return {.delaunay = std::move(cvt.delaunay),
            .run = cvt.run,
            .counts = cvt.counts,
            .density = cvt.density,
            .site_orbits =
                start.symmetric ? counted_by_sites(start.symmetric->orbit) : std::vector<int>()};
}

/// Of prescribed areas.
Tessellation compute_power_cells(const Job& job, JobStart& start, JobMonitor& monitor,
                                 const std::function<void()>& built) {
    plane::AreaCvtOptions options;
    options.areas = std::move(start.areas);
    options.numbering = start.numbering;
    options.centroidal_steps = job.run.max_iterations;
    options.tolerance = job.run.tolerance;
    options.n_threads = job.run.n_threads;
    options.progress = [&](const Progress& progress) { return monitor.iteration(progress); };
    options.newton_progress = [&, first = true](const SizeFigures& areas) mutable {
        // The first call comes once the first triangulation is built and measured.
        if (std::exchange(first, false)) built();
        monitor.newton_step(areas.newton_steps, areas.largest_relative_error);
    };
    if (job.walls != Walls::kNone) {
        plane::WalledAreaCvt walled = compute_walled_area_cvt(
            job.in_plane().lattice, job.walls, job.wall_cells, std::move(start.points), options);
        return {.delaunay = std::move(walled.torus.delaunay),
                .walled = walled.domain,
                .run = walled.torus.run,
                .counts = walled.torus.counts,
                .areas = walled.torus.areas};
    }
    plane::AreaCvtResult result = compute_area_cvt(job.in_plane().lattice, start.points, options);
    return {.delaunay = std::move(result.delaunay),
            .run = result.run,
            .counts = result.counts,
            .areas = result.areas};
}

/// Moves points into the Domain at `origin`, but not across walls.
plane::Points wrapped(plane::Points points, const plane::Lattice& lattice,
                      const plane::Vec2& origin, Walls walls) {
    const plane::Domain domain(lattice, origin);
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        plane::Offset into = domain.offset_into(points.col(s));
        if (has_walls_across(walls, 0)) into.i = 0;
        if (has_walls_across(walls, 1)) into.j = 0;
        points.col(s) += lattice.translation(into);
    }
    return points;
}

/// The positions of all sites, those inside holes among them.
plane::Points plane_sites(const Tessellation& tessellation) {
    if (const auto& walled = tessellation.walled) {
        return points_between_walls(tessellation.delaunay, *walled);
    }
    const plane::Sites& sites = tessellation.delaunay.sites();
    const plane::Metric metric =
        tessellation.elongation ? tessellation.elongation->metric : plane::Metric();
    plane::Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        checkpoint_each(s);
        points.col(s) = metric.from_round(sites.position(s));
    }
    return points;
}

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace

Tessellation tessellate(const Job& job, JobStart& start, JobMonitor& monitor,
                        const std::function<void()>& built) {
    return job.areas ? compute_power_cells(job, start, monitor, built)
                     : compute_cells(job, start, monitor, built);
}

plane::Metric metric_of(const Job& job) {
    return job.aspect ? plane::Metric(job.aspect->ratio, job.aspect->degrees) : plane::Metric();
}

Job in_round_space(const Job& job, const plane::Metric& metric) {
    Job round = job;
    round.in_plane().lattice = metric.to_round(job.in_plane().lattice);
    round.in_plane().points = metric.to_round(job.in_plane().points);
    round.in_plane().fixed = metric.to_round(job.in_plane().fixed);
    if (job.density) round.density = fixed_to_lattice(*job.density, job.in_plane().lattice);
    return round;
}

plane::PeriodicMesh plane_mesh(const Tessellation& tessellation, plane::MeshKind kind) {
    plane::PeriodicMesh mesh = periodic_mesh(tessellation.delaunay, kind);
    if (tessellation.walled) return part_between_walls(std::move(mesh), *tessellation.walled);
    const auto& elongation = tessellation.elongation;
    if (!elongation) return mesh;
    return from_round(std::move(mesh), elongation->metric, elongation->lattice);
}

plane::PeriodicMesh mesh_outside_holes(const Tessellation& tessellation, plane::MeshKind kind) {
    return with_holes(plane_mesh(tessellation, kind), tessellation.holes);
}

std::vector<int> cell_sides(const Tessellation& tessellation) {
    if (!tessellation.elongation && !tessellation.walled) {
        return cell_sides(tessellation.delaunay);
    }
    return cell_sides(plane_mesh(tessellation, plane::MeshKind::kVoronoi));
}

AreaSummary area_summary(const Tessellation& tessellation) {
    const CellTable cells = cell_table(plane_mesh(tessellation, plane::MeshKind::kVoronoi));
    std::vector<double> circularities;
    for (SiteId s = 0; s < cells.n_cells(); ++s) circularities.push_back(cells.circularity(s));
    AreaSummary summary{.newton = *tessellation.areas};
    summary.std_over_mean = diameter_spread(Eigen::Map<const Eigen::VectorXd>(
        cells.measure.data(), static_cast<Eigen::Index>(cells.measure.size())));
    summary.circularity_mean = mean(circularities);
    for (double& c : circularities)
        c = (c - summary.circularity_mean) * (c - summary.circularity_mean);
    summary.circularity_std = std::sqrt(mean(circularities));
    return summary;
}

Eigen::VectorXd site_weights(const Tessellation& tessellation) {
    const Eigen::VectorXd& weights = tessellation.delaunay.weights();
    if (weights.size() == 0) return weights;
    return weights.head(tessellation.n_sites());
}

plane::Points wrapped_sites(const Tessellation& tessellation, const plane::Vec2& origin) {
    const Walls walls = tessellation.walled ? tessellation.walled->walls : Walls::kNone;
    plane::Points points =
        wrapped(plane_sites(tessellation), tessellation.lattice(), origin, walls);
    if (tessellation.holes.empty()) return points;
    const std::vector<SiteId> kept = tessellation.holes.kept();
    return points(Eigen::all, kept);
}

plane::Points progress_sites(const Job& job, const Progress& progress) {
    if (progress.positions == nullptr) return {};
    const plane::Metric metric = metric_of(job);
    plane::Points points = (*progress.positions)();
    for (auto p : points.colwise()) p = metric.from_round(p);
    return wrapped(std::move(points), job.in_plane().lattice, job.tile.origin, job.walls);
}

double energy_bound(const Tessellation& tessellation) {
    const plane::Sites& sites = tessellation.delaunay.sites();
    if (!tessellation.walled) {
        return plane::hexagonal_bound(tessellation.lattice().area(), sites.n_sites());
    }
    return plane::hexagonal_bound(sites.lattice().area(), sites.n_sites()) /
           tessellation.walled->n_images();
}

std::optional<Minimum> minimum_of(const Tessellation& tessellation) {
    const plane::Sites& sites = tessellation.delaunay.sites();
    const bool few = sites.n_sites() <= plane::kMostSitesForStability;
    const bool uniform = !tessellation.density && !tessellation.areas && !tessellation.walled;
    if (tessellation.run.stop != Stop::kConverged || !uniform || !few) return {};
    return stability(sites);
}

}  // namespace pcvt
