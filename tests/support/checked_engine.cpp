#include "tests/support/checked_engine.hpp"

#include <cmath>
#include <numeric>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "tests/support/engine_twin.hpp"

namespace pcvt::testing {
namespace {

constexpr int kMostBuildsPerMove = 2;
/// The largest number of sites for which the pieces of the mirror diagram are integrated.
constexpr int kFewSites = 12;

/// The largest distance between corresponding coordinates, in lattice coordinates and modulo
/// periods.
double distance_modulo_periods(const plane::Points& p, const plane::Points& q) {
    const Eigen::ArrayXXd d = (p - q).array();
    return (d - d.round()).abs().maxCoeff();
}

}  // namespace

EngineTally& EngineTally::operator+=(const EngineTally& other) {
    moves += other.moves;
    undefined += other.undefined;
    flips += other.flips;
    rebuilds += other.rebuilds;
    local_repairs += other.local_repairs;
    predicates += other.predicates;
    exact += other.exact;
    return *this;
}

CheckedEngine::CheckedEngine(const plane::Sites& sites)
    : original_(sites), delaunay_(sites), pass_(delaunay_, workers_) {
    if (!evaluate()) require("the first evaluation failed");
    compare();
}

void CheckedEngine::require(const std::string& fault) {
    if (fault_.empty()) fault_ = fault;
}

bool CheckedEngine::evaluate() {
    plane::Suspects all;
    all.triangles.resize(static_cast<std::size_t>(delaunay_.triangulation().n_triangles()));
    std::iota(all.triangles.begin(), all.triangles.end(), 0);
    const bool has_inverted = !delaunay_.inverted(all).empty();

    const plane::PredicateCounts predicates = plane::predicate_counts();
    const plane::DelaunayCounts counts = delaunay_.counts();
    const bool defined = pass_.evaluate(energy_);
    const int n_builds = delaunay_.counts().n_rebuilds - counts.n_rebuilds;
    tally_.flips += delaunay_.counts().n_flips - counts.n_flips;
    tally_.rebuilds += n_builds;
    tally_.local_repairs += defined && has_inverted && n_builds == 0;
    tally_.predicates += plane::predicate_counts().calls - predicates.calls;
    tally_.exact += plane::predicate_counts().exact - predicates.exact;
    if (n_builds > kMostBuildsPerMove) require(std::to_string(n_builds) + " builds for one move");
    return defined;
}

void CheckedEngine::compare() {
    if (!fault_.empty()) return;
    const plane::Sites sites = sites_of(delaunay_, original_);
    require(broken_law(delaunay_, sites));
    if (!fault_.empty()) return;
    require(difference_from_mirrors(delaunay_, sites));
    require(difference_from_new_build(delaunay_, energy_, sites));
    if (sites.n_sites() <= kFewSites) require(difference_from_pieces(delaunay_, energy_, sites));
}

void CheckedEngine::require_arrived(const plane::Points& from, const Eigen::VectorXf& direction,
                                    double t) {
    const plane::ReducedFrame& frame = delaunay_.frame();
    plane::Points expected = from;
    double longest = 1;
    for (SiteId s = 0; s < delaunay_.n_sites(); ++s) {
        const plane::Vec2 way = t * direction.segment<2>(2 * s).cast<double>();
        const double v = way.y() / frame.by;
        const plane::Vec2 d((way.x() - frame.bx * v) / frame.ax, v);
        expected.col(s) += d;
        longest = std::max(longest, d.cwiseAbs().maxCoeff());
    }
    // Beyond 2^51 periods the position is unknown.
    const double distance = distance_modulo_periods(delaunay_.coordinates(), expected);
    if (!(distance <= 4e-15 * longest)) require("a site is not at its target");
    const plane::Points& u = delaunay_.coordinates();
    if (!(u.minCoeff() >= -1.5 && u.maxCoeff() < 2.5)) require("a coordinate is out of range");
}

bool CheckedEngine::move(const Eigen::VectorXf& direction, double t) {
    if (!delaunay_.settled()) require("a move from positions that were not settled");
    home_ = delaunay_.coordinates();
    direction_ = direction;
    ++tally_.moves;
    if (!delaunay_.step(direction_, t, workers_)) {
        if ((t * direction.cast<double>()).allFinite()) require("a finite step was rejected");
        if (delaunay_.coordinates() != home_) require("a rejected step moved a site");
        compare();
        return false;
    }
    require_arrived(home_, direction, t);
    if (evaluate()) {
        compare();
        return true;
    }
    ++tally_.undefined;
    if (sites_of(delaunay_, original_).duplicates().first < 0) require("distinct sites coincide");
    step_back();
    return false;
}

void CheckedEngine::step_back() {
    delaunay_.step_back();
    if (distance_modulo_periods(delaunay_.coordinates(), home_) != 0)
        require("the sites are not at their old positions");
    if (!evaluate()) require("the energy is not defined at the old positions");
    compare();
}

void CheckedEngine::release() {
    const plane::Sites before = sites_of(delaunay_, original_);
    auto [sites, triangulation] = delaunay_.release();
    if (sites.coordinates() != before.coordinates())
        require("released sites differ from the moved");
    const plane::PeriodicDelaunay certified(std::move(sites), std::move(triangulation));
}

}  // namespace pcvt::testing
