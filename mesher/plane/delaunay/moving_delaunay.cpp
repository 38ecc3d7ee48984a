#include "mesher/plane/delaunay/moving_delaunay.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/base/huge_pages.hpp"
#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/delaunay/site_insertion.hpp"
#include "mesher/plane/delaunay/untangling.hpp"

namespace pcvt::plane {
namespace {

/// Sites per task of a move.
constexpr int kSitesPerTask = 1 << 14;
/// A local repair that moves back more sites than this share, and more than this number, costs more
/// than a new build.
constexpr double kMostHeldShare = 0.02;
constexpr std::size_t kMostHeldAtLeast = 16;

/// Flips, and mirrors, beyond which the insertion of sites in random order takes less time. Sites
/// that are spread evenly need 1.1 flips each, or some sqrt(n) mirrors.
constexpr int kMostFlipsPerSite = 40;
constexpr int kMostMirrorsAtLeast = 8000;
constexpr int kSitesPerMirror = 2;

double unit_near(double length) {
    int exponent = 0;
    std::frexp(length, &exponent);
    return std::ldexp(1.0, exponent);
}

ReducedFrame frame_of(const Lattice& reduced, double unit) {
    const double ax = reduced.a().norm();
    return {ax / unit, reduced.a().dot(reduced.b()) / ax / unit, reduced.area() / ax / unit};
}

Points in_order(const Points& coordinates, const std::vector<SiteId>& order) {
    Points ordered(2, coordinates.cols());
    for (Eigen::Index s = 0; s < coordinates.cols(); ++s) {
        checkpoint_each(s);
        ordered.col(s) = coordinates.col(order[s]);
    }
    return ordered;
}

/// Appends the triangles of each flip to a log and forwards the calls to another observer.
class LoggedFlips final : public FlipObserver {
   public:
    LoggedFlips(const TorusTriangulation& triangulation, FlipObserver* observer,
                std::vector<int>& triangles)
        : triangulation_(triangulation), observer_(observer), triangles_(triangles) {}

    void fetch(SiteId site) const override {
        if (observer_ != nullptr) observer_->fetch(site);
    }
    void before_flip(int h) override {
        if (observer_ != nullptr) observer_->before_flip(h);
    }
    void after_flip(int h) override {
        triangles_.push_back(h / 3);
        triangles_.push_back(triangulation_.opposite(h) / 3);
        if (observer_ != nullptr) observer_->after_flip(h);
    }

   private:
    const TorusTriangulation& triangulation_;
    FlipObserver* observer_;
    std::vector<int>& triangles_;
};

}  // namespace

MovingDelaunay::MovingDelaunay(const Sites& sites, Numbering numbering)
    : lattice_(sites.lattice()),
      reduction_(sites.reduction()),
      gram_(gram_of(reduction_.reduced)),
      unit_(unit_near(sites.spacing())),
      spacing_(sites.spacing() / unit_),
      frame_(frame_of(reduction_.reduced, unit_)),
      triangulation_(0, {}) {
    SpatialSort columns = spatial_sort(sites.coordinates(), gram_);
    coordinates_ = in_order(sites.coordinates(), columns.order);
    if (numbering == Numbering::kAsGiven) order_ = columns.order;
    std::iota(columns.order.begin(), columns.order.end(), 0);
    if (numbering == Numbering::kByColumns) order_ = columns.order;
    build(columns);
}

void MovingDelaunay::build(const SpatialSort& columns) {
    prefers_huge_pages_ = false;
    if (auto strips = strip_triangulation(coordinates_, columns)) {
        triangulation_ = std::move(*strips);
        counts_.n_mirrors.reset();
        const auto most = static_cast<std::int64_t>(kMostFlipsPerSite) * n_sites();
        if (LawsonFlips(triangulation_, coordinates_, gram_).flip_all_within(most)) return;
    } else {
        const int most = std::max(kMostMirrorsAtLeast, n_sites() / kSitesPerMirror);
        if (const auto diagram = mirror_diagram_within(wrapped_sites(), most)) {
            triangulation_ = TorusTriangulation(n_sites(), diagram->triangles);
            counts_.n_mirrors = diagram->n_mirrors;
            return;
        }
    }
    // Sites on a line, on a circle, or otherwise spread unevenly.
    triangulation_ = TorusTriangulation(n_sites(), inserted_triangles(wrapped_sites()));
    counts_.n_mirrors.reset();
}

bool MovingDelaunay::rebuild() {
    if (wrapped_sites().duplicates().first >= 0) return false;
    coordinates_.array() -= coordinates_.array().floor();
    build(spatial_sort(coordinates_, gram_));
    ++counts_.n_rebuilds;
    return true;
}

/// Only a triangulation that moves is accessed often enough to profit.
void MovingDelaunay::prefer_huge_pages() {
    if (prefers_huge_pages_) return;
    pcvt::prefer_huge_pages(coordinates_);
    triangulation_.prefer_huge_pages();
    prefers_huge_pages_ = true;
}

void MovingDelaunay::tie_moves(std::vector<MoveTie> ties) {
    ties_ = std::make_shared<const std::vector<MoveTie>>(std::move(ties));
}

bool MovingDelaunay::step(const Eigen::VectorXf& direction, double t, Workers& workers) {
    prefer_huge_pages();
    // Move all sites in parallel.
    const SiteMoves moves(frame_, direction, t, ties_.get());
    const int n_tasks = (n_sites() + kSitesPerTask - 1) / kSitesPerTask;
    std::atomic<bool> finite = true;
    std::atomic<bool> in_range = true;
    workers.for_each(n_tasks, [&](int task) {
        const int begin = task * kSitesPerTask;
        const int end = std::min(begin + kSitesPerTask, n_sites());
        const SiteMoves::Outcome outcome = moves.apply(begin, end, coordinates_);
        if (!outcome.finite) finite = false;
        if (!outcome.in_range) in_range = false;
    });
    // Undo moves that are not finite.
    if (!finite) {
        moves.back().apply(0, n_sites(), coordinates_);
        return false;
    }
    // Record the moves for step_back and untangle.
    settled_ = false;
    moves_ = moves;
    if (!in_range) keep_in_range();
    return true;
}

void MovingDelaunay::step_back() {
    moves_ = moves_->back();
    settled_ = true;
    if (!moves_->apply(0, n_sites(), coordinates_).in_range) keep_in_range();
}

void MovingDelaunay::keep_in_range() {
    std::vector<Offset> change(static_cast<std::size_t>(n_sites()));
    bool changes = false;
    for (SiteId s = 0; s < n_sites(); ++s) {
        checkpoint_each(s);
        const Vec2 whole = coordinates_.col(s).array().floor();
        if (whole.minCoeff() >= -1 && whole.maxCoeff() <= 1) continue;
        coordinates_.col(s) -= whole;
        change[s] = {static_cast<int>(whole.x()), static_cast<int>(whole.y())};
        changes = true;
    }
    if (!changes) return;
    triangulation_.add_to_offsets(change);
    begin_flip_log();
}

void MovingDelaunay::adopt(std::span<const SiteId> sites, const Points& coordinates,
                           std::span<const int> flips) {
    for (std::size_t k = 0; k < sites.size(); ++k) {
        coordinates_.col(sites[k]) = coordinates.col(static_cast<Eigen::Index>(k));
    }
    for (const int h : flips) triangulation_.flip(h);
    counts_.n_flips += std::ssize(flips);
    if (!flips.empty()) begin_flip_log();
    moves_.reset();
}

std::vector<int> MovingDelaunay::inverted(const Suspects& suspects) const {
    std::vector<int> found;
    for (const int t : suspects.triangles) {
        const auto corner = [&](int k) {
            const Corner c = triangulation_.corner(3 * t + k);
            return image(coordinates_, c.site, c.offset);
        };
        if (orientation(corner(0), corner(1), corner(2)) <= 0) found.push_back(t);
    }
    return found;
}

void MovingDelaunay::begin_flip_log() {
    ++flip_log_.number;
    flip_log_.triangles.clear();
}

std::int64_t MovingDelaunay::flip(Suspects& suspects, FlipObserver* observer) {
    LawsonFlips flips(triangulation_, coordinates_, gram_);
    if (flip_log_.triangles.size() > static_cast<std::size_t>(n_sites())) begin_flip_log();
    LoggedFlips logged(triangulation_, observer, flip_log_.triangles);
    const std::int64_t n_flips = flips.flip(suspects.halfedges, &logged);
    counts_.n_flips += n_flips;
    return n_flips;
}

bool MovingDelaunay::untangle(const std::vector<int>& inverted, Suspects& suspects) {
    begin_flip_log();
    const auto share = static_cast<std::size_t>(kMostHeldShare * n_sites());
    const std::size_t most_held = std::max(share, kMostHeldAtLeast);
    if (!moves_ || inverted.size() > most_held) return rebuild();
    Untangling untangling(triangulation_, *moves_, coordinates_, gram_);
    const bool done = untangling.run(inverted, std::move(suspects.halfedges), most_held);
    counts_.n_flips += untangling.n_flips();
    if (done) return true;
    return rebuild();
}

Points MovingDelaunay::positions() const {
    const Sites sites = released_sites();
    Points points(2, n_sites());
    for (SiteId s = 0; s < n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

Sites MovingDelaunay::released_sites() const {
    Points coordinates(2, n_sites());
    for (SiteId s = 0; s < n_sites(); ++s) {
        checkpoint_each(s);
        const Vec2 whole = coordinates_.col(s).array().floor();
        coordinates.col(order_[s]) = coordinates_.col(s) - whole;
    }
    return {lattice_, reduction_, std::move(coordinates)};
}

std::pair<Sites, TorusTriangulation> MovingDelaunay::release() {
    std::vector<Offset> change(static_cast<std::size_t>(n_sites()));
    for (SiteId s = 0; s < n_sites(); ++s) {
        checkpoint_each(s);
        const Vec2 whole = coordinates_.col(s).array().floor();
        change[s] = {static_cast<int>(whole.x()), static_cast<int>(whole.y())};
    }
    Sites released = released_sites();
    coordinates_.resize(2, 0);
    triangulation_.add_to_offsets(change);
    triangulation_.renumber_sites(order_);
    return {std::move(released), std::move(triangulation_)};
}

void require_distinct(const MovingDelaunay& delaunay) {
    // Each site is joined to its nearest neighbour by a Delaunay edge.
    const TorusTriangulation& t = delaunay.triangulation();
    std::pair<SiteId, SiteId> found{-1, -1};
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        const Vec2 edge = delaunay.frame().to_position(
            difference(image(delaunay.coordinates(), from.site, from.offset),
                       image(delaunay.coordinates(), to.site, to.offset)));
        if (edge.norm() >= kSameVertex * delaunay.spacing()) continue;
        const std::pair<SiteId, SiteId> pair =
            std::minmax({delaunay.original_id(from.site), delaunay.original_id(to.site)});
        if (found.first < 0 || pair < found) found = pair;
    }
    if (found.first >= 0) throw DuplicateSites(found.first, found.second);
}

}  // namespace pcvt::plane
