#include "io/forms/seam_segments.hpp"

#include <algorithm>
#include <utility>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// A boundary edge with the tile on its left.
struct Step {
    int from;
    int to;
    plane::Offset offset = {};
    int middle = -1;
    std::optional<plane::WallId> wall = {};
    /// The partner's step.
    int partner = -1;

    bool continues(const Step& step) const { return offset == step.offset && wall == step.wall; }
};

/// The steps along the boundary; each pair of the seam is followed by its partner.
std::vector<Step> boundary_steps(const plane::Tile& tile, const plane::MidsideNodes& middles) {
    std::vector<Step> steps;
    for (std::size_t k = 0; k < tile.edge_pairs.size(); ++k) {
        const plane::EdgePair& pair = tile.edge_pairs[k];
        const int here = static_cast<int>(steps.size());
        steps.push_back({.from = pair.v0, .to = pair.v1, .offset = pair.offset});
        steps.push_back({.from = pair.w1, .to = pair.w0, .offset = -pair.offset});
        steps[here].partner = here + 1;
        steps[here + 1].partner = here;
        if (middles.of_edge_pair.empty()) continue;
        steps[here].middle = middles.of_edge_pair[k][0];
        steps[here + 1].middle = middles.of_edge_pair[k][1];
    }
    for (std::size_t k = 0; k < tile.wall_edges.size(); ++k) {
        const plane::WallEdge& edge = tile.wall_edges[k];
        steps.push_back({.from = edge.v0, .to = edge.v1, .wall = edge.wall});
        if (!middles.of_wall_edge.empty()) steps.back().middle = middles.of_wall_edge[k];
    }
    return steps;
}

/// Walks along the steps of a boundary.
class BoundaryWalk {
   public:
    BoundaryWalk(const plane::Tile& tile, std::vector<Step> steps)
        : tile_(tile), steps_(std::move(steps)), leaving_(tile.points.size()) {
        for (std::size_t s = 0; s < steps_.size(); ++s) {
            leaving_[steps_[s].from].push_back(static_cast<int>(s));
        }
    }

    std::vector<SeamSegment> runs() {
        if (steps_.empty()) throw InternalError("the tile has no boundary");
        find_ends();
        run_of_.assign(steps_.size(), -1);
        for (std::size_t v = 0; v < leaving_.size(); ++v) {
            if (!is_end_[v]) continue;
            for (const int s : leaving_[v]) walk(s);
        }
        // Loops of one run.
        for (std::size_t v = 0; v < leaving_.size(); ++v) {
            for (const int s : leaving_[v]) {
                if (run_of_[s] >= 0) continue;
                is_end_[v] = true;
                walk(s);
            }
        }
        find_partners();
        return std::move(runs_);
    }

   private:
    /// Runs end where the offset or the wall changes, and where two parts of a tile meet.
    void find_ends() {
        is_end_.assign(leaving_.size(), false);
        for (const Step& step : steps_) {
            const std::vector<int>& next = leaving_[step.to];
            if (next.empty()) throw InternalError("the boundary of the tile is not closed");
            if (next.size() > 1 || !steps_[next[0]].continues(step)) is_end_[step.to] = true;
        }
        for (const plane::VertexPair& pair : tile_.vertex_pairs) {
            if (is_end_[pair.w]) is_end_[pair.v] = true;
        }
        for (const plane::VertexPair& pair : tile_.vertex_pairs) {
            if (is_end_[pair.v] && !leaving_[pair.w].empty()) is_end_[pair.w] = true;
        }
    }

    /// Adds the runs of the loop that begins with step s.
    void walk(int s) {
        while (run_of_[s] < 0) {
            const Step& step = steps_[s];
            if (is_end_[step.from]) runs_.push_back({step.offset, {step.from}, {}, -1, step.wall});
            run_of_[s] = static_cast<int>(runs_.size()) - 1;
            runs_.back().vertices.push_back(step.to);
            if (step.middle >= 0) runs_.back().middles.push_back(step.middle);
            s = leaving_[step.to].front();
            // Where parts meet, the other runs begin there.
            if (leaving_[step.to].size() > 1) return;
        }
    }

    void find_partners() {
        for (std::size_t s = 0; s < steps_.size(); ++s) {
            if (steps_[s].partner >= 0) runs_[run_of_[s]].partner = run_of_[steps_[s].partner];
        }
    }

    const plane::Tile& tile_;
    std::vector<Step> steps_;
    /// The steps that leave each vertex: more than one where two parts of a tile meet.
    std::vector<std::vector<int>> leaving_;
    std::vector<bool> is_end_;
    std::vector<int> run_of_;
    std::vector<SeamSegment> runs_;
};

}  // namespace

std::vector<SeamSegment> seam_segments(const plane::Tile& tile,
                                       const plane::MidsideNodes& middles) {
    return BoundaryWalk(tile, boundary_steps(tile, middles)).runs();
}

}  // namespace pcvt
