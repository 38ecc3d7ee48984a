#include "plugin/job/job_start.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "mesher/plane/cvt/coarse_start.hpp"
#include "mesher/plane/cvt/symmetric_coarse_start.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/search/global_search.hpp"
#include "mesher/plane/search/lattice_stability.hpp"
#include "mesher/plane/symmetry/folded_density.hpp"
#include "mesher/space/delaunay/orbit_insertion.hpp"
#include "plugin/job/job_tessellation.hpp"

namespace pcvt {
namespace {

/// The orbits of a job with a symmetry.
plane::OrbitPlan plan_of(const Job& job, const plane::PlaneGroup& group) {
    return distribute(group, special_positions(group), job.n_sites);
}

JobStart random_start(const Job& job, const ProgressCallback& /*callback*/) {
    JobStart start;
    if (job.symmetry) {
        const plane::PlaneGroup group(*job.symmetry, job.in_plane().lattice);
        std::optional<plane::Density> density;
        if (job.density) density = folded_density(*job.density, group);
        start.symmetric =
            numbered_by_columns(random_sites(group, plan_of(job, group), job.seed, density));
        return start;
    }
    start.points = job.density
                       ? graded_points(job.in_plane().lattice, *job.density, job.n_sites, job.seed)
                       : uniform_points(job.in_plane().lattice, job.n_sites, job.seed);
    return start;
}

/// The options of a run with the callback of a start.
RunOptions reporting_run(const Job& job, const ProgressCallback& callback) {
    RunOptions run = job.run;
    run.progress = callback;
    return run;
}

JobStart coarse_job_start(const Job& job, const ProgressCallback& callback) {
    const plane::CoarseStartOptions options{.run = reporting_run(job, callback),
                                            .density = job.density};
    JobStart start;
    start.precondition_below = plane::kPreconditionAfterCoarse;
    start.relaxes_active_sites = true;
    if (job.symmetry) {
        const plane::PlaneGroup group(*job.symmetry, job.in_plane().lattice);
        start.symmetric = symmetric_coarse_start(group, plan_of(job, group), job.seed, options);
        start.cancelled = !start.symmetric;
        return start;
    }
    start.points = coarse_start(job.in_plane().lattice, job.n_sites, job.seed, options, job.walls);
    start.cancelled = start.points.cols() == 0;
    return start;
}

PatternFigures pattern_figures(const plane::LatticePattern& pattern) {
    Eigen::Matrix2d basis;
    basis << pattern.basis.a(), pattern.basis.b();
    const auto& [a, b, d] = pattern.form;
    return {.basis = basis,
            .hermite = {a, b, d},
            .energy = pattern.energy,
            .stability = lattice_stability(pattern)};
}

JobStart lattice_start(const Job& job, const ProgressCallback& /*callback*/) {
    const plane::LatticePattern pattern = best_lattice(job.in_plane().lattice, job.n_sites);
    JobStart start;
    start.points = pattern_points(pattern);
    start.figures.pattern = pattern_figures(pattern);
    return start;
}

JobStart best_start(const Job& job, const ProgressCallback& callback) {
    const int budget = job.budget > 0 ? job.budget : plane::default_search_budget(job.n_sites);
    plane::SearchResult result =
        search_minimum(job.in_plane().lattice, job.n_sites, job.seed,
                       {.run = reporting_run(job, callback), .budget = budget});
    JobStart start;
    start.points = std::move(result.points);
    start.figures.pattern = pattern_figures(result.lattice);
    start.figures.found = std::move(result.found);
    start.evaluations = result.evaluations;
    start.cancelled = result.cancelled;
    return start;
}

/// In the order of the enumerators.
constexpr std::array kStarts{StartRow{.start = Start::kRandom,
                                      .word = "random",
                                      .abi_value = 1,
                                      .with_sizes = true,
                                      .in_space = true,
                                      .help = "",
                                      .make = random_start},
                             StartRow{.start = Start::kCoarse,
                                      .word = "coarse",
                                      .abi_value = 2,
                                      .with_sizes = true,
                                      .in_space = true,
                                      .help = "few sites first, then\nbetween them more",
                                      .make = coarse_job_start},
                             StartRow{.start = Start::kLattice,
                                      .word = "lattice",
                                      .abi_value = 3,
                                      .with_sizes = false,
                                      .in_space = true,
                                      .help = "at the exact lattice with the lowest\nenergy",
                                      .make = lattice_start},
                             StartRow{.start = Start::kBest,
                                      .word = "best",
                                      .abi_value = 4,
                                      .with_sizes = false,
                                      .in_space = false,
                                      .help = "after a global search",
                                      .make = best_start}};

/// For fewer sites the time of random starts does not matter, and the paper's statistics are of
/// random starts.
constexpr int kFewestForCoarse = 1000;

/// One for each site, length^2; empty unless the job has areas.
Eigen::VectorXd target_areas(const Job& job) {
    if (!job.sizes) return {};
    const auto& [law, given, name] = *job.sizes;
    const int n = job.n_wanted();
    return scaled_areas(given.size() > 0 ? given : draw_areas(law, n, job.seed), n,
                        job.in_plane().lattice.area());
}

/// The fixed sites, then those of a start.
JobStart start_after_fixed_sites(const Job& job, const StartRow& row,
                                 const ProgressCallback& callback) {
    Job others = job;
    others.n_sites -= static_cast<int>(job.in_plane().fixed.cols());
    JobStart start;
    if (others.n_sites > 0) start = row.make(others, callback);
    plane::Points points(2, job.n_sites);
    points.leftCols(job.in_plane().fixed.cols()) = job.in_plane().fixed;
    points.rightCols(others.n_sites) = start.points;
    start.points = std::move(points);
    start.numbering = plane::Numbering::kAsGiven;
    return start;
}

/// Sites in the domain, in which they may coincide.
template <class Points, class Periods>
struct CoincidenceDomain {
    /// In the basis of `periods`; no column if a point is not finite or too far away.
    Points coordinates;
    /// The reduced period vectors as columns, length units.
    Periods periods;
    /// The mean spacing of the sites, length units.
    double h;
};

/// The coordinates of points in the domain of a reduced lattice, as CoincidenceDomain holds them.
template <class Lattice>
typename Lattice::Points domain_coordinates(const Lattice& reduced,
                                            const typename Lattice::Points& points) {
    typename Lattice::Points coordinates(Lattice::kDimension, points.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        const typename Lattice::Point u = reduced.to_lattice(points.col(s));
        if (!(u.cwiseAbs().maxCoeff() < kFarthestPeriod)) {
            return typename Lattice::Points(Lattice::kDimension, 0);
        }
        coordinates.col(s) = Lattice::wrapped(u);
    }
    return coordinates;
}

/// In the metric and between the walls of the job.
CoincidenceDomain<plane::Points, Eigen::Matrix2d> coincidence_domain(const Job& job,
                                                                     const PlaneDomain& domain,
                                                                     const plane::Points& given,
                                                                     double n_sites) {
    const plane::Metric metric = metric_of(job, domain);
    // Sites on opposite walls do not coincide.
    const bool has_walls = job.walls != Walls::kNone && is_upright(domain.lattice);
    const plane::Lattice lattice =
        metric.to_round(has_walls ? mirrored_lattice(domain.lattice, job.walls) : domain.lattice);
    const plane::Lattice reduced = reduce(lattice).reduced;
    Eigen::Matrix2d periods;
    periods << reduced.a(), reduced.b();
    return {domain_coordinates(reduced, metric.to_round(given)), periods,
            std::sqrt(metric.to_round(domain.lattice).area() / n_sites)};
}

CoincidenceDomain<space::Points, Eigen::Matrix3d> coincidence_domain(const Job& job,
                                                                     const SpaceDomain& domain,
                                                                     const space::Points& given,
                                                                     double n_sites) {
    const space::Metric metric = metric_of(job, domain);
    const space::Lattice reduced = reduce(metric.to_round(domain.lattice)).reduced;
    Eigen::Matrix3d periods;
    periods << reduced.a(), reduced.b(), reduced.c();
    return {domain_coordinates(reduced, metric.to_round(given)), periods,
            domain.lattice.spacing(static_cast<int>(n_sites))};
}

/// Keeps entries of one a site.
template <class Entries>
void keep_entries(const std::vector<SiteId>& kept, std::size_t n, Entries& entries) {
    if (static_cast<std::size_t>(entries.size()) != n) return;
    Entries left(kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) left[k] = entries[kept[k]];
    entries = std::move(left);
}

/// Refuses or leaves out the sites of a job that coincide with earlier ones.
/// @returns whether the sites are distinct now.
template <class Domain>
bool settle(Job& job, Domain& domain) {
    auto& given = domain.points.cols() > 0 ? domain.points : domain.fixed;
    if (given.cols() < 2) return false;
    // check_constraints() refuses more fixed sites than sites, and its message comes first.
    if (job.duplicates == Duplicates::kRefuse && domain.fixed.cols() > job.n_sites) return false;
    const double n_sites = std::max(static_cast<double>(given.cols()), double(job.n_sites));
    const auto [coordinates, periods, h] = coincidence_domain(job, domain, given, n_sites);
    if (coordinates.cols() == 0) return false;
    std::vector<CoincidentSite> pairs =
        job.duplicates == Duplicates::kDrop
            ? sites_to_drop(coordinates, periods, h)
            : coincident_sites(coordinates, periods, kCoincident * h);
    if (pairs.empty()) return true;
    if (job.duplicates == Duplicates::kRefuse) throw DuplicateSites(std::move(pairs));
    const auto n = static_cast<std::size_t>(given.cols());
    const std::vector<SiteId> kept = kept_sites(static_cast<int>(n), pairs);
    job.dropped = dropped_sites(std::move(pairs), job.lines);
    keep_entries(kept, n, job.lines);
    given = std::decay_t<decltype(given)>(given(Eigen::all, kept));
    if (domain.points.cols() == 0) return true;
    if (job.n_sites > 0) job.n_sites = static_cast<int>(kept.size());
    if (job.sizes) keep_entries(kept, n, job.sizes->given);
    if (job.weights) keep_entries(kept, n, job.weights->values);
    keep_entries(kept, n, job.materials.site_phases);
    keep_entries(kept, n, job.materials.orientations);
    return true;
}

}  // namespace

void settle_duplicates(Job& job) {
    const bool are_distinct =
        std::visit([&](auto& domain) { return settle(job, domain); }, job.domain);
    if (!are_distinct || !job.is_in_space()) return;
    const space::Metric metric = metric_of(job, job.in_space());
    job.n_tetrahedra = space::expected_tetrahedra(space::Sites(
        metric.to_round(job.in_space().lattice), metric.to_round(job.in_space().points)));
}

std::span<const StartRow> start_rows() { return kStarts; }

const StartRow& start_row(Start start) { return kStarts[static_cast<std::size_t>(start)]; }

JobStart job_start(const Job& job, const ProgressCallback& callback) {
    const StartRow& row = start_row(chosen_start(job));
    Eigen::VectorXd areas = target_areas(job);
    JobStart start;
    if (job.has_inclusions()) {
        start.numbering = plane::Numbering::kAsGiven;
    } else if (job.in_plane().fixed.cols() > 0) {
        start = start_after_fixed_sites(job, row, callback);
    } else if (job.n_given() > 0) {
        start.points = job.in_plane().points;
    } else {
        start = row.make(job, callback);
    }
    // Given areas and phases belong to random places: numbers by columns would arrange sorted ones.
    const bool given =
        (job.sizes && job.sizes->given.size() > 0) || !job.materials.site_phases.empty();
    if (job.n_given() > 0 || given) start.numbering = plane::Numbering::kAsGiven;
    start.areas = std::move(areas);
    start.figures.chosen = row.start;
    return start;
}

Start chosen_start(const Job& job) {
    if (job.start) return *job.start;
    const bool is_free = !job.has_inclusions() && job.n_fixed() == 0;
    if (!is_free) return Start::kRandom;
    // Where mirrors and centres bound an asymmetric unit with few sites, a coarse start may end
    // higher.
    const int order =
        job.symmetry ? plane::PlaneGroup(*job.symmetry, job.in_plane().lattice).order() : 1;
    const bool many = job.n_sites / order >= kFewestForCoarse;
    // Coarse cells know nothing of prescribed areas.
    if (!many || job.run.max_iterations == 0 || job.sizes) return Start::kRandom;
    // Where a density jumps, the coarse cells miss detail, and the minima become higher.
    const bool is_resolved =
        !job.density || plane::is_resolved_by_coarse_cells(job.in_plane().lattice, *job.density,
                                                           job.n_sites / order);
    return is_resolved ? Start::kCoarse : Start::kRandom;
}

}  // namespace pcvt
