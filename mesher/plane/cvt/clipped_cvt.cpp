#include "mesher/plane/cvt/clipped_cvt.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/cvt/residuals.hpp"
#include "mesher/optimize/lbfgs.hpp"

namespace pcvt::plane {
namespace {

/// The longest move of a site in one step, in units of h, as for the periodic energy.
constexpr double kLargestClippedMove = 0.5;

/// A convex polygon around the origin. For each side (from corner k to k + 1) it stores whether the
/// side lies on the border of the domain.
struct Loop {
    Polygon corners;
    std::vector<char> on_border;

    void clear() {
        corners.clear();
        on_border.clear();
    }
    void add(const Vec2& corner, char border) {
        corners.push_back(corner);
        on_border.push_back(border);
    }
    double squared_radius() const {
        double most = 0;
        for (const Vec2& corner : corners) most = std::max(most, corner.squaredNorm());
        return most;
    }
};

/// Keeps the part of the polygon that is nearer to the origin than to d (Sutherland and Hodgman's
/// clipping by one half-plane).
void clip_by_bisector(const Loop& loop, const Vec2& d, Loop& kept) {
    kept.clear();
    const double level = d.squaredNorm() / 2;
    const std::size_t n = loop.corners.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2& p = loop.corners[k];
        const Vec2& q = loop.corners[(k + 1) % n];
        const double fp = d.dot(p) - level;
        const double fq = d.dot(q) - level;
        if (fp <= 0) kept.add(p, loop.on_border[k]);
        if (fp < 0 && fq > 0) kept.add(p + fp / (fp - fq) * (q - p), 0);
        if (fp > 0 && fq < 0) kept.add(p + fp / (fp - fq) * (q - p), loop.on_border[k]);
        if (fp == 0 && fq > 0) kept.on_border.back() = 0;
    }
}

/// Points sorted into square boxes, about one point per box.
class PointGrid {
   public:
    PointGrid(const Points& points, const Polygon& domain) : low_(domain[0]) {
        Vec2 high = low_;
        for (const Vec2& corner : domain) {
            low_ = low_.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        const Vec2 extent = high - low_;
        // A thin domain has at most n boxes along it.
        const auto n = static_cast<double>(points.cols());
        side_ = std::max(std::sqrt(extent.prod() / n), extent.maxCoeff() / n);
        columns_ = static_cast<int>(extent.x() / side_) + 1;
        rows_ = static_cast<int>(extent.y() / side_) + 1;
        boxes_.resize(static_cast<std::size_t>(columns_) * rows_);
        for (int s = 0; s < points.cols(); ++s) {
            boxes_[index(column(points.col(s)), row(points.col(s)))].push_back(s);
        }
    }

    /// Calls visit(id) for each point in the boxes that lie `ring` boxes away from the box of p.
    template <class Visit>
    void visit_ring(const Vec2& p, int ring, Visit visit) const {
        const int i0 = column(p);
        const int j0 = row(p);
        for (int j = std::max(j0 - ring, 0); j <= std::min(j0 + ring, rows_ - 1); ++j) {
            const bool whole_row = std::abs(j - j0) == ring;
            const int step = whole_row || ring == 0 ? 1 : 2 * ring;
            for (int i = i0 - ring; i <= i0 + ring; i += step) {
                if (i < 0 || i >= columns_) continue;
                for (const int s : boxes_[index(i, j)]) visit(s);
            }
        }
    }
    /// A lower bound on the distance from p to the points of this ring and of all later ones.
    double nearest_of_ring(int ring) const { return (ring - 1) * side_; }
    int n_rings() const { return std::max(columns_, rows_); }

   private:
    int column(const Vec2& p) const { return box((p.x() - low_.x()) / side_, columns_); }
    int row(const Vec2& p) const { return box((p.y() - low_.y()) / side_, rows_); }
    static int box(double position, int count) {
        return static_cast<int>(std::clamp(position, 0.0, count - 1.0));
    }
    std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }

    Vec2 low_;
    double side_;
    int columns_;
    int rows_;
    std::vector<std::vector<int>> boxes_;
};

Polygon domain_of(const Lattice& lattice, double unit) {
    const Vec2 a = lattice.a() / unit;
    const Vec2 b = lattice.b() / unit;
    Polygon domain{Vec2::Zero(), a, a + b, b};
    if (!lattice.right_handed()) std::swap(domain[1], domain[3]);
    return domain;
}

/// Cuts the cells of points in a convex domain, one at a time. Each cell is relative to its point.
class CellCutter {
   public:
    CellCutter(const Polygon& domain, const Points& points)
        : domain_(domain), points_(points), grid_(points, domain) {}

    bool in_domain(int s) const {
        for (std::size_t k = 0; k < domain_.size(); ++k) {
            const Vec2 side = domain_[(k + 1) % domain_.size()] - domain_[k];
            const double outside = -cross(side, points_.col(s) - domain_[k]);
            if (!(outside <= kRounding * side.squaredNorm())) return false;
        }
        return true;
    }

    /// Returns the cell of point s, valid until the next call. The cell is empty if another point
    /// coincides with s; `twin()` is that point.
    const Loop& cut(int s) {
        const Vec2 p = points_.col(s);
        twin_ = -1;
        cell_.clear();
        for (const Vec2& corner : domain_) cell_.add(corner - p, 1);
        double reach = 4 * cell_.squared_radius();
        for (int ring = 0; ring < grid_.n_rings(); ++ring) {
            if (ring > 1 && grid_.nearest_of_ring(ring) * grid_.nearest_of_ring(ring) > reach)
                break;
            grid_.visit_ring(p, ring, [&](int t) {
                const Vec2 d = points_.col(t) - p;
                if (t == s || d.squaredNorm() > reach) return;
                if (d.squaredNorm() == 0) twin_ = t;
                clip_by_bisector(cell_, d, clipped_);
                std::swap(cell_, clipped_);
                reach = 4 * cell_.squared_radius();
            });
        }
        if (twin_ >= 0) cell_.clear();
        return cell_;
    }
    int twin() const { return twin_; }

   private:
    /// Relative to the size of the domain: a point outside by no more than this lies on the border.
    static constexpr double kRounding = 1e-14;

    const Polygon& domain_;
    const Points& points_;
    PointGrid grid_;
    Loop cell_;
    Loop clipped_;
    int twin_ = -1;
};

/// The area of a polygon and its first and second moments about the origin.
struct PolygonMoments {
    double area = 0;
    Vec2 first = Vec2::Zero();
    double second = 0;
};

PolygonMoments moments(const Polygon& polygon) {
    PolygonMoments sum;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& p = polygon[k];
        const Vec2& q = polygon[(k + 1) % polygon.size()];
        const double twice = cross(p, q);
        sum.area += twice / 2;
        sum.first += twice / 6 * (p + q);
        sum.second += twice / 12 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    }
    return sum;
}

/// @returns false if a point lies outside the domain or coincides with another.
bool measure(const Polygon& domain, const Points& points, ClippedEnergy& energy) {
    CellCutter cutter(domain, points);
    energy.value = 0;
    energy.gradient.resize(2, points.cols());
    energy.mass.resize(points.cols());
    for (int s = 0; s < points.cols(); ++s) {
        if (!cutter.in_domain(s)) return false;
        const PolygonMoments cell = moments(cutter.cut(s).corners);
        if (!(cell.area > 0)) return false;
        energy.value += cell.second;
        energy.gradient.col(s) = -2 * cell.first;
        energy.mass[s] = cell.area;
    }
    return true;
}

/// The clipped energy as a function of moving points, in a unit near h.
class ClippedObjective final : public Objective {
   public:
    ClippedObjective(Polygon domain, Points points, double spacing)
        : domain_(std::move(domain)), point_(std::move(points)), spacing_(spacing) {}

    const Points& point() const { return point_; }

    Eigen::Index n_variables() const override { return point_.size(); }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        trial_ = point_;
        if (t != 0) trial_.reshaped() += t * direction.cast<double>();
        if (!measure(domain_, trial_, energy_)) return false;
        const auto moves =
            energy_.gradient.array().rowwise() / (2 * energy_.mass.array().transpose());
        const Eigen::ArrayXd squares = moves.square().colwise().sum().transpose();
        evaluation.value = energy_.value;
        evaluation.gradient = energy_.gradient.reshaped();
        evaluation.residual = std::sqrt(squares.maxCoeff()) / spacing_;
        evaluation.rms_residual = std::sqrt(squares.mean()) / spacing_;
        return true;
    }

    void accept() override { point_ = trial_; }

    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        steps_to_centroids(evaluation.gradient, energy_.mass, direction);
    }

   private:
    Polygon domain_;
    Points point_;
    double spacing_;
    Points trial_;
    ClippedEnergy energy_;
};

/// A power of two near h.
double unit_of(const Lattice& lattice, const Points& points) {
    if (points.cols() == 0) throw InvalidInput("no sites are given; give at least one");
    return std::exp2(std::round(std::log2(lattice.area() / double(points.cols())) / 2));
}

/// Throws the error of the first point that has no cell; lengths are scaled by `unit`.
void require_cells(const Lattice& lattice, const Points& points, double unit) {
    const Polygon domain = domain_of(lattice, unit);
    const Points scaled = points / unit;
    if (!scaled.allFinite()) throw InvalidInput("a site is not finite; give finite coordinates");
    CellCutter cutter(domain, scaled);
    for (int s = 0; s < points.cols(); ++s) {
        if (!cutter.in_domain(s)) {
            throw InvalidInput("site " + std::to_string(s) +
                               " lies outside of the domain; wrap it into the domain");
        }
        const bool empty = cutter.cut(s).corners.size() < 3;
        if (cutter.twin() >= 0)
            throw DuplicateSites(std::min(s, cutter.twin()), std::max(s, cutter.twin()));
        if (empty) throw InvalidInput("the cell of site " + std::to_string(s) + " is empty");
    }
}

}  // namespace

std::vector<ClippedCell> clipped_cells(const Lattice& lattice, const Points& points) {
    const double unit = unit_of(lattice, points);
    require_cells(lattice, points, unit);
    const Polygon domain = domain_of(lattice, unit);
    const Points scaled = points / unit;
    CellCutter cutter(domain, scaled);
    std::vector<ClippedCell> cells(static_cast<std::size_t>(points.cols()));
    for (int s = 0; s < points.cols(); ++s) {
        const Loop& loop = cutter.cut(s);
        for (const Vec2& corner : loop.corners) {
            cells[s].polygon.push_back(unit * (corner + scaled.col(s)));
        }
        cells[s].meets_border =
            std::find(loop.on_border.begin(), loop.on_border.end(), 1) != loop.on_border.end();
    }
    return cells;
}

ClippedEnergy clipped_energy(const Lattice& lattice, const Points& points) {
    const double unit = unit_of(lattice, points);
    require_cells(lattice, points, unit);
    ClippedEnergy energy;
    measure(domain_of(lattice, unit), points / unit, energy);
    energy.value *= std::pow(unit, 4);
    energy.gradient *= std::pow(unit, 3);
    energy.mass *= unit * unit;
    return energy;
}

ClippedCvt compute_clipped_cvt(const Lattice& lattice, const Points& points,
                               const ClippedCvtOptions& options) {
    const double unit = unit_of(lattice, points);
    require_cells(lattice, points, unit);
    const double spacing = std::sqrt(lattice.area() / double(points.cols())) / unit;
    const double value_unit = std::pow(unit, 4);
    ClippedObjective objective(domain_of(lattice, unit), points / unit, spacing);
    OptimizerOptions optimizer{.tolerance = options.tolerance,
                               .max_iterations = options.max_iterations,
                               .max_move = kLargestClippedMove * spacing};
    if (options.progress) {
        optimizer.progress = [&](Progress progress) {
            progress.value *= value_unit;
            return options.progress(progress);
        };
    }
    Workers workers(1);
    RunStatistics run = minimize_lbfgs(objective, optimizer, workers).run;
    run.energy *= value_unit;
    return {unit * objective.point(), run};
}

}  // namespace pcvt::plane
