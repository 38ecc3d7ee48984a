#include "mesher/moving_delaunay.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "mesher/large_pages.hpp"
#include "mesher/mirror_diagram.hpp"
#include "mesher/untangling.hpp"
#include "mesher/vector_clones.hpp"

namespace pcvt {
namespace {

/// Sites a task moves.
constexpr int kSitesPerTask = 1 << 14;
/// A local repair that puts more sites back than this share, and this number, costs more than a
/// build.
constexpr double kMostHeldShare = 0.02;
constexpr std::size_t kMostHeldAtLeast = 16;

double unit_near(double length) {
    int exponent = 0;
    std::frexp(length, &exponent);
    return std::ldexp(1.0, exponent);
}

MovingDelaunay::Frame frame_of(const Lattice& reduced, double unit) {
    const double ax = reduced.a().norm();
    return {ax / unit, reduced.a().dot(reduced.b()) / ax / unit, reduced.area() / ax / unit};
}

/// The change of coordinates by a translation in the frame.
class ToLattice {
   public:
    explicit ToLattice(const MovingDelaunay::Frame& frame)
        : per_ax_(1 / frame.ax), per_by_(1 / frame.by), bx_(frame.bx) {}
    struct Change {
        double u;
        double v;
    };
    Change operator()(double x, double y) const {
        const double v = y * per_by_;
        return {(x - bx_ * v) * per_ax_, v};
    }

   private:
    double per_ax_;
    double per_by_;
    double bx_;
};

struct MovedSites {
    bool finite;
    bool in_range;
};

/// Moves n sites and adds the number of those that left [-1, 2).
/// @returns the number of sites that would move further than half a period: unless it is 0, all are
///          to be moved again.
PCVT_VECTOR_CLONES std::int64_t move_near(const float* direction, double t, ToLattice to_lattice,
                                          const double* from, double* to, Eigen::Index n,
                                          std::int64_t& n_outside) {
    std::int64_t n_far = 0;
    std::int64_t outside = 0;
    for (Eigen::Index k = 0; k < 2 * n; k += 2) {
        const auto [du, dv] = to_lattice(t * double(direction[k]), t * double(direction[k + 1]));
        n_far += int(!(std::abs(du) <= 0.5)) | int(!(std::abs(dv) <= 0.5));
        const double u = from[k] + snapped_displacement(du);
        const double v = from[k + 1] + snapped_displacement(dv);
        outside += int(!(std::min(u, v) >= -1)) | int(!(std::max(u, v) < 2));
        to[k] = u;
        to[k + 1] = v;
    }
    n_outside += outside;
    return n_far;
}

/// Moves sites begin to end; a whole number of periods is left out of a move.
MovedSites move_sites(int begin, int end, const Eigen::VectorXf& direction, double t,
                      const ToLattice& to_lattice, const Points& from, Points& to) {
    std::int64_t n_outside = 0;
    const std::int64_t n_far =
        move_near(direction.data() + 2 * begin, t, to_lattice, from.data() + 2 * begin,
                  to.data() + 2 * begin, end - begin, n_outside);
    if (n_far == 0) return {true, n_outside == 0};
    for (int s = begin; s < end; ++s) {
        const auto [du, dv] =
            to_lattice(t * double(direction[2 * s]), t * double(direction[2 * s + 1]));
        const Vec2 d(du, dv);
        if (!d.allFinite()) return {false, false};
        const Vec2 periods(std::nearbyint(du), std::nearbyint(dv));
        to.col(s) = from.col(s) + snapped_displacement(Vec2(d - periods));
    }
    return {true, false};
}

Points in_order(const Points& coordinates, const std::vector<SiteId>& order) {
    Points ordered(2, coordinates.cols());
    for (Eigen::Index s = 0; s < coordinates.cols(); ++s) {
        ordered.col(s) = coordinates.col(order[s]);
    }
    return ordered;
}

/// Writes flips down before it passes them on.
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

MovingDelaunay::MovingDelaunay(const Sites& sites)
    : lattice_(sites.lattice()),
      reduction_(sites.reduction()),
      gram_(gram_of(reduction_.reduced)),
      unit_(unit_near(sites.spacing())),
      spacing_(sites.spacing() / unit_),
      frame_(frame_of(reduction_.reduced, unit_)),
      triangulation_(0, {}) {
    Columns columns = sort_into_columns(sites.coordinates(), gram_);
    order_ = columns.order;
    coordinates_ = in_order(sites.coordinates(), order_);
    std::iota(columns.order.begin(), columns.order.end(), 0);
    build(columns);
}

void MovingDelaunay::build(const Columns& columns) {
    prefers_large_pages_ = false;
    if (auto strips = strip_triangulation(coordinates_, columns)) {
        triangulation_ = std::move(*strips);
        counts_.n_mirrors.reset();
        LawsonFlips(triangulation_, coordinates_, gram_).flip_all();
        return;
    }
    MirrorDiagram diagram = mirror_diagram(wrapped_sites());
    std::sort(diagram.triangles.begin(), diagram.triangles.end(),
              [](const Triangle& s, const Triangle& t) { return s[0].site < t[0].site; });
    triangulation_ = TorusTriangulation(n_sites(), diagram.triangles);
    counts_.n_mirrors = diagram.n_mirrors;
}

bool MovingDelaunay::rebuild() {
    if (wrapped_sites().duplicates().first >= 0) return false;
    for (SiteId s = 0; s < n_sites(); ++s) shift(s, coordinates_.col(s).array().floor());
    build(sort_into_columns(coordinates_, gram_));
    ++counts_.n_rebuilds;
    return true;
}

/// Only what moves is looked at often enough.
void MovingDelaunay::prefer_large_pages() {
    if (prefers_large_pages_) return;
    previous_.resize(2, n_sites());
    pcvt::prefer_large_pages(previous_);
    pcvt::prefer_large_pages(coordinates_);
    triangulation_.prefer_large_pages();
    prefers_large_pages_ = true;
}

bool MovingDelaunay::step(const Eigen::VectorXf& direction, double t, Workers& workers) {
    settled_ = false;
    prefer_large_pages();
    previous_.swap(coordinates_);
    coordinates_.resize(2, previous_.cols());
    const ToLattice to_lattice(frame_);
    const int n_tasks = (n_sites() + kSitesPerTask - 1) / kSitesPerTask;
    std::atomic<bool> finite = true;
    std::atomic<bool> in_range = true;
    workers.for_each(n_tasks, [&](int task) {
        const int begin = task * kSitesPerTask;
        const int end = std::min(begin + kSitesPerTask, n_sites());
        const MovedSites moved =
            move_sites(begin, end, direction, t, to_lattice, previous_, coordinates_);
        if (!moved.finite) finite = false;
        if (!moved.in_range) in_range = false;
    });
    if (!finite) {
        coordinates_.swap(previous_);
        settled_ = true;
        return false;
    }
    if (!in_range) keep_in_range();
    return true;
}

void MovingDelaunay::step_back() {
    coordinates_.swap(previous_);
    settled_ = true;
    keep_in_range();
}

void MovingDelaunay::shift(SiteId site, const Vec2& periods) {
    coordinates_.col(site) -= periods;
    previous_.col(site) -= periods;
}

void MovingDelaunay::keep_in_range() {
    std::vector<Offset> change(static_cast<std::size_t>(n_sites()));
    bool changes = false;
    for (SiteId s = 0; s < n_sites(); ++s) {
        const Vec2 whole = coordinates_.col(s).array().floor();
        if (whole.minCoeff() >= -1 && whole.maxCoeff() <= 1) continue;
        shift(s, whole);
        change[s] = {static_cast<int>(whole.x()), static_cast<int>(whole.y())};
        changes = true;
    }
    if (!changes) return;
    triangulation_.add_to_offsets(change);
    begin_flip_log();
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
    if (inverted.size() > most_held) return rebuild();
    Untangling untangling(triangulation_, previous_, coordinates_, gram_);
    const bool done = untangling.run(inverted, std::move(suspects.halfedges), most_held);
    counts_.n_flips += untangling.n_flips();
    if (done) return true;
    return rebuild();
}

std::pair<Sites, TorusTriangulation> MovingDelaunay::release() {
    previous_.resize(2, 0);
    std::vector<Offset> change(static_cast<std::size_t>(n_sites()));
    Points coordinates(2, n_sites());
    for (SiteId s = 0; s < n_sites(); ++s) {
        const Vec2 whole = coordinates_.col(s).array().floor();
        change[s] = {static_cast<int>(whole.x()), static_cast<int>(whole.y())};
        coordinates.col(order_[s]) = coordinates_.col(s) - whole;
    }
    coordinates_.resize(2, 0);
    triangulation_.add_to_offsets(change);
    triangulation_.renumber_sites(order_);
    return {Sites(lattice_, reduction_, std::move(coordinates)), std::move(triangulation_)};
}

}  // namespace pcvt
