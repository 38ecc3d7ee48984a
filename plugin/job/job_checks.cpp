#include "plugin/job/job_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/mesh/voronoi.hpp"

namespace pcvt {
namespace {

/// Offsets of a tile stay below this, so that their sums and differences fit an int.
constexpr double kLargestOffset = 1 << 28;

/// Coordinates of the origin are rounded by this many ulps at most on their way into a file.
constexpr double kUlps = 4;

/// So many squares of the size of grains: three triangles each stay below the end of int.
constexpr double kMostGrainSquares = 1 << 27;

Reduction reduce_repeated(const Job& job) {
    reduce(job.lattice);
    try {
        return reduce(job.lattice.repeated(job.columns, job.rows));
    } catch (const InvalidInput& error) {
        throw InvalidInput("repeated " + std::to_string(job.columns) + " x " +
                           std::to_string(job.rows) + ": " + error.what());
    }
}

/// The origin must leave the offsets in their integers, and vertices that differ must stay apart.
void check_origin(const Job& job, const Reduction& repeated, double n_sites) {
    const Vec2 periods = repeated.reduced.to_lattice(job.origin);
    double largest = 1;
    for (const int entry : repeated.m) largest = std::max(largest, std::abs(double(entry)));
    const double rounding =
        kUlps * std::numeric_limits<double>::epsilon() * job.origin.cwiseAbs().maxCoeff();
    const double h = std::sqrt(job.lattice.area() / n_sites);
    if (!(periods.cwiseAbs().maxCoeff() * largest < kLargestOffset) ||
        !(rounding <= kSameVertex * h)) {
        throw InvalidInput(
            "the origin is so far away that the tile would lose its digits; give a nearer one");
    }
}

bool asks_for(const Job& job, MeshKind kind) {
    return std::find(job.meshes.begin(), job.meshes.end(), kind) != job.meshes.end();
}

void check_grains(const Job& job) {
    if (job.grain_size > 0 && job.grain_per_edge > 0) {
        throw InvalidInput("grains have a size and parts of an edge; take one of the two");
    }
    const double copies = double(job.columns) * job.rows;
    const double n = std::max<double>(static_cast<double>(job.points.cols()), job.n_sites);
    // A regular hexagon with edges cut into k parts has 2.6 k^2 squares over them.
    const double squares = job.grain_size > 0
                               ? job.lattice.area() * copies / (job.grain_size * job.grain_size)
                               : 2.6 * n * copies * job.grain_per_edge * job.grain_per_edge;
    if (squares > kMostGrainSquares) {
        throw LimitExceeded("grains of that size are more than pcvt holds; take larger ones");
    }
}

void check_meshes(const Job& job) {
    if (job.meshes.empty()) {
        throw InvalidInput("no mesh is asked for; take voronoi, delaunay or grains");
    }
    if (job.outline == Outline::kBox && asks_for(job, MeshKind::kDelaunay)) {
        throw InvalidInput(
            "the box outline would cut Delaunay triangles, and cut ones are none; "
            "take the mesh grains with the box outline, or the whole outline");
    }
    if (job.order != 1 && job.order != 2) throw InvalidInput("the order of grains is 1 or 2");
    if (asks_for(job, MeshKind::kGrains)) check_grains(job);
}

/// Starts and solvers that know no density.
void check_density(const Job& job) {
    if (!job.density) return;
    const Start start = job.start.value_or(Start::kRandom);
    if (start == Start::kLattice || start == Start::kBest) {
        throw InvalidInput(
            "a lattice knows no density; leave the start out, or take coarse or random");
    }
}

}  // namespace

void check_order(const Job& job, const std::vector<JobFile>& files) {
    if (job.order == 1 || files.empty()) return;
    const bool held = std::any_of(files.begin(), files.end(), [](const JobFile& file) {
        return file.format->highest_order > 1;
    });
    if (held) return;
    throw InvalidInput(
        "none of the files asked for holds the mid-side nodes of order 2; add one of " +
        second_order_extensions() + ", or take order 1");
}

void check_job(const Job& job) {
    check_density(job);
    const double n = job.points.cols() > 0 ? static_cast<double>(job.points.cols()) : job.n_sites;
    if (n < 1) throw InvalidInput("no sites; give at least one");
    if (job.n_threads < 1) throw InvalidInput("the number of threads is below 1; take 1");
    if (!(job.short_edges >= 0 && job.short_edges <= kLongestShortEdge)) {
        throw InvalidInput("the length under which edges are removed is not between 0 and 0.5 h");
    }
    if (job.columns < 1 || job.rows < 1) throw InvalidInput("a repetition is below 1; take 1 x 1");
    check_meshes(job);
    if (n * job.columns * job.rows > kMostSites) {
        throw LimitExceeded("more than " + std::to_string(kMostSites) +
                            " cells in one tile; take fewer sites or repeat less often");
    }
    check_origin(job, reduce_repeated(job), n);
}

}  // namespace pcvt
