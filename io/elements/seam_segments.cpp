#include "io/elements/seam_segments.hpp"

#include <utility>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The boundary edge that leaves a vertex with the tile on its left; to < 0 inside of the tile.
struct Step {
    int to = -1;
    /// Where the edge's partner begins.
    int partner = -1;
    Offset offset;
    int middle = -1;
    std::optional<WallSide> wall = {};

    bool continues(const Step& step) const { return offset == step.offset && wall == step.wall; }
};

std::vector<Step> boundary_steps(const Tile& tile, const MidsideNodes& middles) {
    std::vector<Step> steps(tile.points.size());
    for (std::size_t k = 0; k < tile.edge_pairs.size(); ++k) {
        const EdgePair& pair = tile.edge_pairs[k];
        steps[pair.v0] = {pair.v1, pair.w1, pair.offset};
        steps[pair.w1] = {pair.w0, pair.v0, -pair.offset};
        if (middles.of_edge_pair.empty()) continue;
        steps[pair.v0].middle = middles.of_edge_pair[k][0];
        steps[pair.w1].middle = middles.of_edge_pair[k][1];
    }
    for (std::size_t k = 0; k < tile.wall_edges.size(); ++k) {
        const WallEdge& edge = tile.wall_edges[k];
        steps[edge.v0] = {.to = edge.v1, .partner = -1, .offset = {}, .wall = edge.side};
        if (!middles.of_wall_edge.empty()) steps[edge.v0].middle = middles.of_wall_edge[k];
    }
    return steps;
}

/// The smallest vertex at which the offset or the wall changes.
int first_end(const std::vector<Step>& steps) {
    std::vector<bool> is_end(steps.size(), false);
    for (const Step& step : steps) {
        if (step.to < 0) continue;
        is_end[step.to] = steps[step.to].to >= 0 && !steps[step.to].continues(step);
    }
    for (std::size_t v = 0; v < steps.size(); ++v) {
        if (is_end[v]) return static_cast<int>(v);
    }
    throw InternalError("the boundary of the tile has no end of a run");
}

std::vector<SeamSegment> walk(const std::vector<Step>& steps, std::size_t n_edges) {
    std::vector<SeamSegment> runs;
    const int first = first_end(steps);
    int v = first;
    int before = -1;
    for (std::size_t walked = 0; walked == 0 || v != first; ++walked) {
        const Step& step = steps[v];
        if (step.to < 0 || walked == n_edges) {
            throw InternalError("the boundary of the tile is not one loop");
        }
        if (before < 0 || !step.continues(steps[before]))
            runs.push_back({step.offset, {v}, {}, -1, step.wall});
        runs.back().vertices.push_back(step.to);
        if (step.middle >= 0) runs.back().middles.push_back(step.middle);
        before = std::exchange(v, step.to);
    }
    return runs;
}

void find_partners(const std::vector<Step>& steps, std::vector<SeamSegment>& runs) {
    std::vector<int> run_of(steps.size(), -1);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        for (std::size_t k = 0; k + 1 < runs[r].vertices.size(); ++k) {
            run_of[runs[r].vertices[k]] = static_cast<int>(r);
        }
    }
    for (SeamSegment& run : runs) {
        if (!run.wall) run.partner = run_of[steps[run.vertices.front()].partner];
    }
}

}  // namespace

std::vector<SeamSegment> seam_segments(const Tile& tile, const MidsideNodes& middles) {
    const std::vector<Step> steps = boundary_steps(tile, middles);
    std::vector<SeamSegment> runs =
        walk(steps, 2 * tile.edge_pairs.size() + tile.wall_edges.size());
    find_partners(steps, runs);
    return runs;
}

}  // namespace pcvt
