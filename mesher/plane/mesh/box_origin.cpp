#include "mesher/plane/mesh/box_origin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// The number of initial positions of each family of lines.
constexpr int kPositions = 256;
/// Keeps the initial positions away from simple fractions, where the cells of exact grids have
/// edges.
constexpr double kFirstPosition = 0.382;
/// At least kPaired positions of each family are paired with positions of the other. If a line
/// crosses few edges, the families depend more on each other; then about as many are paired as
/// together have kPairedCrossings crossings.
constexpr std::size_t kPaired = 12;
constexpr std::size_t kPairedCrossings = 1500;
/// The rounds of refinement, the steps to either side in a round, and the factor between their
/// sizes.
constexpr int kRounds = 5;
constexpr int kSteps = 2;
constexpr double kShrink = 0.4;

/// One edge orbit in lattice coordinates.
struct Edge {
    Vec2 from;
    Vec2 to;
    double length;
};

std::vector<Edge> edges_of(const PeriodicMesh& cells) {
    std::vector<Edge> edges;
    for (int c = 0; c < cells.n_corners(); ++c) {
        checkpoint_each(c);
        if (cells.opposite[c] < c) continue;
        const Vec2 p = cells.point(c);
        const Vec2 q = cells.point(cells.next(c));
        edges.push_back({cells.lattice.to_lattice(p), cells.lattice.to_lattice(q), (q - p).norm()});
    }
    return edges;
}

/// The crossing of a line and an edge: the fraction t of the edge, and the coordinate along the
/// line, in [0, 1).
struct Crossing {
    int edge;
    double t;
    double along;
    friend bool operator<(const Crossing& x, const Crossing& y) {
        return std::tie(x.edge, x.t) < std::tie(y.edge, y.t);
    }
};

/// The lines u = position + k (axis 0) or v = position + k (axis 1) for all integers k, and their
/// crossings.
struct CutLine {
    double position;
    std::vector<Crossing> crossings;
    double shortest = 0;
};

double fraction(double u) { return u - std::floor(u); }

/// Adds the crossings of the lines of one family. The lines are sorted by position in [0, 1).
void cross_edges(const std::vector<Edge>& edges, int axis, std::vector<CutLine>& lines) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
        checkpoint_each(e);
        const Edge& edge = edges[e];
        const auto [low, high] = std::minmax(edge.from[axis], edge.to[axis]);
        for (double k = std::floor(low); k < high; ++k) {
            auto line = std::lower_bound(
                lines.begin(), lines.end(), low - k,
                [](const CutLine& l, double position) { return l.position < position; });
            for (; line != lines.end() && line->position + k < high; ++line) {
                const double t =
                    (line->position + k - edge.from[axis]) / (edge.to[axis] - edge.from[axis]);
                const int other = 1 - axis;
                const double along =
                    fraction(edge.from[other] + t * (edge.to[other] - edge.from[other]));
                line->crossings.push_back({static_cast<int>(e), t, along});
            }
        }
    }
}

/// Returns the length of the shortest part into which the crossings divide an edge.
double shortest_part(const std::vector<Edge>& edges, std::vector<Crossing> crossings) {
    std::sort(crossings.begin(), crossings.end());
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < crossings.size(); ++k) {
        checkpoint_each(k);
        const Crossing& here = crossings[k];
        const double length = edges[here.edge].length;
        const bool first = k == 0 || crossings[k - 1].edge != here.edge;
        const bool last = k + 1 == crossings.size() || crossings[k + 1].edge != here.edge;
        const double before = first ? here.t : here.t - crossings[k - 1].t;
        shortest = std::min({shortest, before * length, last ? (1 - here.t) * length : shortest});
    }
    return shortest;
}

/// Returns the shortest part of a line between crossings, in periods. `corner` is the position of
/// the box corner on the line, or null.
double shortest_gap(const CutLine& line, const double* corner) {
    std::vector<double> along;
    for (const Crossing& crossing : line.crossings) along.push_back(crossing.along);
    if (corner != nullptr) along.push_back(*corner);
    std::sort(along.begin(), along.end());
    double shortest = along.empty() ? 1 : 1 + along.front() - along.back();
    for (std::size_t k = 1; k < along.size(); ++k) {
        shortest = std::min(shortest, along[k] - along[k - 1]);
    }
    return shortest;
}

class OriginSearch {
   public:
    explicit OriginSearch(const PeriodicMesh& cells)
        : edges_(edges_of(cells)), period_{cells.lattice.b().norm(), cells.lattice.a().norm()} {}

    /// Returns the lattice coordinates of the best origin found.
    Vec2 find() {
        std::vector<double> positions;
        for (int k = 0; k < kPositions; ++k) positions.push_back((k + kFirstPosition) / kPositions);
        try_pairs(best_lines(0, positions), best_lines(1, positions));
        double step = 0.5 / kPositions;
        for (int round = 0; round < kRounds; ++round, step *= kShrink) {
            const std::vector<CutLine> u_lines = best_lines(0, positions_near(best_.x(), step));
            try_pairs(u_lines, best_lines(1, positions_near(best_.y(), step)));
        }
        return best_;
    }

   private:
    static std::vector<double> positions_near(double position, double step) {
        std::vector<double> positions;
        for (int k = -kSteps; k <= kSteps; ++k) positions.push_back(fraction(position + k * step));
        std::sort(positions.begin(), positions.end());
        return positions;
    }

    /// Returns the lines of a family with the longest shortest edge, each without the other family,
    /// the best first.
    std::vector<CutLine> best_lines(int axis, const std::vector<double>& positions) const {
        std::vector<CutLine> lines;
        for (const double position : positions) lines.push_back({position, {}});
        cross_edges(edges_, axis, lines);
        for (CutLine& line : lines) {
            line.shortest = std::min(shortest_part(edges_, line.crossings),
                                     period_[axis] * shortest_gap(line, nullptr));
        }
        std::stable_sort(lines.begin(), lines.end(), [](const CutLine& l, const CutLine& m) {
            return l.shortest > m.shortest;
        });
        const std::size_t paired =
            std::max(kPaired, kPairedCrossings / (1 + lines.front().crossings.size()));
        lines.resize(std::min(lines.size(), paired));
        return lines;
    }

    /// Returns the shortest edge that both lines and their common corner make.
    double shortest_edge(const CutLine& u_line, const CutLine& v_line) const {
        std::vector<Crossing> crossings = u_line.crossings;
        crossings.insert(crossings.end(), v_line.crossings.begin(), v_line.crossings.end());
        return std::min({shortest_part(edges_, std::move(crossings)),
                         period_[0] * shortest_gap(u_line, &v_line.position),
                         period_[1] * shortest_gap(v_line, &u_line.position)});
    }

    void try_pairs(const std::vector<CutLine>& u_lines, const std::vector<CutLine>& v_lines) {
        for (const CutLine& u_line : u_lines) {
            checkpoint();
            for (const CutLine& v_line : v_lines) {
                // A pair cannot be better than either of its lines.
                if (std::min(u_line.shortest, v_line.shortest) <= shortest_) continue;
                const double shortest = shortest_edge(u_line, v_line);
                if (shortest <= shortest_) continue;
                shortest_ = shortest;
                best_ = {u_line.position, v_line.position};
            }
        }
    }

    std::vector<Edge> edges_;
    /// The period of the lines of each family, length units.
    std::array<double, 2> period_;
    double shortest_ = -1;
    Vec2 best_ = Vec2::Zero();
};

}  // namespace

Vec2 find_box_origin(const PeriodicMesh& cells) {
    return cells.lattice.to_position(OriginSearch(cells).find());
}

}  // namespace pcvt::plane
