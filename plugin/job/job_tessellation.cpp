#include "plugin/job/job_tessellation.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesher/plane/tessellation/tessellate.hpp"

namespace pcvt {
namespace {

/// The inclusions of the user, or random fibres.
plane::TaggedInclusions inclusions_of(const Job& job) {
    plane::TaggedInclusions inclusions{.tag_names = inclusion_tags(job), .holes = job.holes};
    inclusions.tag_names.insert(inclusions.tag_names.begin(), kMatrixTag);
    if (job.tile.outline == plane::Outline::kBox && !job.tile.finds_origin) {
        inclusions.box_corner = job.in_plane().origin;
    }
    if (job.inclusions) {
        inclusions.shapes = job.inclusions->inclusions;
        return inclusions;
    }
    inclusions.shapes = circular_inclusions(
        random_circles(job.in_plane().lattice, *job.fibres, job.seed, job.walls), 1);
    return inclusions;
}

}  // namespace

plane::Tessellation tessellate(const Job& job, JobStart& start, JobMonitor& monitor,
                               const std::function<void()>& built) {
    const plane::Lattice& lattice = job.in_plane().lattice;
    const plane::WallChoice walls{job.walls, job.wall_cells};
    RunOptions run = job.run;
    bool first = true;
    const auto begin = [&built, &first] {
        if (std::exchange(first, false)) built();
    };
    if (job.sizes) {
        run.progress = [&](const Progress& progress) { return monitor.iteration(progress); };
        const auto newton_progress = [&](const SizeFigures& areas) {
            begin();
            monitor.newton_step(areas.newton_steps, areas.largest_relative_error);
        };
        const plane::AreaCvtOptions options{.areas = std::move(start.areas),
                                            .numbering = start.numbering,
                                            .run = run,
                                            .newton_progress = newton_progress};
        if (job.centroids) return tessellate(lattice, start.points, options);
        return tessellate(lattice, walls, std::move(start.points), options);
    }
    run.progress = [&](const Progress& progress) {
        begin();
        return monitor.iteration(progress);
    };
    if (job.weights) {
        return tessellate(lattice, job.walls, start.points, job.weights->values, run);
    }
    plane::CvtOptions options{.run = run,
                              .precondition_below = start.precondition_below,
                              .relaxes_active_sites = start.relaxes_active_sites,
                              .numbering = start.numbering,
                              .density = job.density};
    options.fixed.resize(static_cast<std::size_t>(job.in_plane().fixed.cols()));
    std::iota(options.fixed.begin(), options.fixed.end(), 0);
    if (start.symmetric) return tessellate(*start.symmetric, options);
    if (!job.has_inclusions()) {
        return tessellate(lattice, walls, std::move(start.points), options);
    }
    const plane::TaggedInclusions inclusions = inclusions_of(job);
    return naming_inclusions(job, [&] {
        return tessellate(lattice, walls, inclusions, job.n_sites, job.seed, options);
    });
}

plane::Metric metric_of(const Job& job, const PlaneDomain& /*domain*/) {
    return job.aspect ? plane::Metric(job.aspect->ratio, job.aspect->degrees) : plane::Metric();
}

space::Metric metric_of(const Job& job, const SpaceDomain& /*domain*/) {
    return job.aspect ? space::Metric(job.aspect->ratio, job.aspect->axis) : space::Metric();
}

Job in_round_space(const Job& job, const plane::Metric& metric) {
    Job round = job;
    round.in_plane().lattice = metric.to_round(job.in_plane().lattice);
    round.in_plane().points = metric.to_round(job.in_plane().points);
    round.in_plane().fixed = metric.to_round(job.in_plane().fixed);
    if (job.density) round.density = fixed_to_lattice(*job.density, job.in_plane().lattice);
    return round;
}

Job in_round_space(const Job& job, const space::Metric& metric) {
    Job round = job;
    round.in_space().lattice = metric.to_round(job.in_space().lattice);
    round.in_space().points = metric.to_round(job.in_space().points);
    return round;
}

std::string inclusion_source(const Job& job) {
    return job.inclusions ? job.inclusions->name : "fibres";
}

std::vector<std::string> inclusion_tags(const Job& job) {
    return job.inclusions ? job.inclusions->tags : std::vector<std::string>{"fibre"};
}

std::vector<std::string> file_phases(const Job& job) {
    std::vector<std::string> names;
    for (const PhaseFraction& phase : job.materials.phases) names.push_back(phase.name);
    if (!job.has_inclusions()) return names;
    names = {kMatrixTag};
    for (const std::string& tag : inclusion_tags(job)) {
        const auto& holes = job.holes;
        if (std::find(holes.begin(), holes.end(), tag) == holes.end()) names.push_back(tag);
    }
    return names;
}

plane::Points progress_sites(const Job& job, const Progress& progress) {
    if (progress.positions == nullptr) return {};
    const plane::Metric metric = metric_of(job, job.in_plane());
    plane::Points points = (*progress.positions)();
    for (auto p : points.colwise()) p = metric.from_round(p);
    return wrapped_points(std::move(points), job.in_plane().lattice, job.in_plane().origin,
                          job.walls);
}

}  // namespace pcvt
