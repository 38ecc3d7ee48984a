#include "plugin/job_report.hpp"

#include <algorithm>

#include "io/report.hpp"
#include "plugin/version.hpp"

namespace pcvt {
namespace {

/// Over all tiles of the run.
std::optional<double> shortest_box_edge(const JobOutcome& outcome) {
    std::optional<double> shortest;
    for (const TileFigures& tile : outcome.tiles) {
        if (!tile.box_shortest_edge) continue;
        shortest = std::min(shortest.value_or(*tile.box_shortest_edge), *tile.box_shortest_edge);
    }
    return shortest;
}

std::optional<Report::Grains> report_grains(const JobOutcome& outcome) {
    for (const TileFigures& tile : outcome.tiles) {
        if (!tile.grains) continue;
        Report::Grains grains{tile.grains->n_triangles, tile.grains->smallest_angle, {}};
        for (const SharpGrainCorner& corner : tile.grains->sharp_corners) {
            grains.sharp_corners.push_back({corner.site, corner.point, corner.angle});
        }
        return grains;
    }
    return std::nullopt;
}

}  // namespace

std::string encode_job_report(const Job& job, const JobOutcome& outcome) {
    const JobSeconds& seconds = outcome.seconds;
    return encode_report({
        .version = version(),
        .sites = outcome.n_sites,
        .lattice = job.lattice,
        .seed = job.seed,
        .solver = job.solver == Solver::kLloyd ? "lloyd" : "lbfgs",
        .start = job.points.cols() > 0 ? "file" : "random",
        .stop = stop_name(outcome.stop),
        .iterations = outcome.iterations,
        .evaluations = outcome.evaluations,
        .energy = outcome.energy,
        .energy_bound = outcome.energy_bound,
        .residual = outcome.residual,
        .hexagons = outcome.n_hexagons,
        .valences = outcome.valences,
        .mirrors = outcome.n_mirrors,
        .threads = job.n_threads,
        .seconds = {seconds.build, seconds.optimize, seconds.write, seconds.total},
        .files = outcome.files,
        .box_shortest_edge = shortest_box_edge(outcome),
        .grains = report_grains(outcome),
    });
}

}  // namespace pcvt
