#include "plugin/job/job_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/bytes/nearest_word.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/inclusion_reader.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/cells/material_choices.hpp"
#include "mesher/plane/interfaces/inclusion_set.hpp"
#include "mesher/plane/interfaces/interface_nodes.hpp"
#include "mesher/plane/interfaces/listed_images.hpp"
#include "mesher/plane/symmetry/special_positions.hpp"
#include "mesher/space/cvt/minimum.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "plugin/job/contradictions.hpp"
#include "plugin/job/job_tessellation.hpp"

namespace pcvt {
namespace {

/// Offsets of a tile stay below this, so that their sums and differences fit an int.
constexpr double kLargestOffset = 1 << 28;

/// Coordinates of the origin are rounded by at most this many ulps on their way into a file.
constexpr double kUlps = 4;

/// The most squares of the size of a grain: three triangles for each of them fit an int.
constexpr double kMostGrainSquares = 1 << 27;
constexpr double kMostGrainCubes = 1 << 24;

plane::Reduction reduce_repeated(const Job& job) {
    reduce(job.in_plane().lattice);
    try {
        return reduce(
            job.in_plane().lattice.repeated(job.tile.repeat.columns, job.tile.repeat.rows));
    } catch (const InvalidInput& error) {
        throw InvalidInput("repeated " + std::to_string(job.tile.repeat.columns) + " x " +
                           std::to_string(job.tile.repeat.rows) + ": " + error.what());
    }
}

[[noreturn]] void refuse_origin() {
    throw InvalidInput(
        "the origin is so far away that the tile would lose its digits; give a nearer one");
}

/// Requires that the offsets fit their integers, and that different vertices stay different.
void check_origin(const Job& job, const plane::Reduction& repeated, double n_sites) {
    const plane::Vec2 periods = repeated.reduced.to_lattice(job.in_plane().origin);
    double largest = 1;
    for (const int entry : repeated.m) largest = std::max(largest, std::abs(double(entry)));
    const double rounding = kUlps * std::numeric_limits<double>::epsilon() *
                            job.in_plane().origin.cwiseAbs().maxCoeff();
    const double h = std::sqrt(job.in_plane().lattice.area() / n_sites);
    if (!(periods.cwiseAbs().maxCoeff() * largest < kLargestOffset) ||
        !(rounding <= plane::kSameVertex * h)) {
        refuse_origin();
    }
}

void check_origin(const SpaceDomain& domain, int n_sites) {
    const space::Vec3 periods = reduce(domain.lattice).reduced.to_lattice(domain.origin);
    const double rounding =
        kUlps * std::numeric_limits<double>::epsilon() * domain.origin.cwiseAbs().maxCoeff();
    if (!(periods.cwiseAbs().maxCoeff() < kLargestOffset) ||
        !(rounding <= plane::kSameVertex * domain.lattice.spacing(n_sites))) {
        refuse_origin();
    }
}

void check_grains(const Job& job) {
    const double copies = job.tile.repeat.n_copies();
    const double n = double(job.n_wanted());
    // A regular hexagon with edges cut into k parts has 2.6 k^2 squares over them.
    const double squares =
        job.tile.grain_size > 0
            ? job.in_plane().lattice.area() * copies / (job.tile.grain_size * job.tile.grain_size)
            : 2.6 * n * copies * job.tile.grain_per_edge * job.tile.grain_per_edge;
    if (squares > kMostGrainSquares) {
        throw LimitExceeded("grains of that size are more than pcvt holds; take larger ones");
    }
}

/// Cubes of the size of tetrahedra inside of cells have about a dozen of these.
void check_grains_in_space(const Job& job) {
    const double size = job.tile.grain_size;
    if (size <= 0 || !has_mesh(job, &plane::MeshKindRow::grain_size)) return;
    if (job.in_space().lattice.volume() / (size * size * size) > kMostGrainCubes) {
        throw LimitExceeded("grains of that size are more than pcvt holds; take larger ones");
    }
}

void check_repetition(const Job& job) {
    const auto [columns, rows, layers] = job.tile.repeat;
    if (std::min({columns, rows, layers}) < 1) {
        throw InvalidInput("a repetition is below 1; take 1 x 1");
    }
    if (std::max({columns, rows, layers}) > kMostPeriods) {
        throw LimitExceeded("repeated " + std::to_string(columns) + " x " + std::to_string(rows) +
                            (job.is_in_space() ? " x " + std::to_string(layers) : "") +
                            ": more than " + std::to_string(kMostPeriods) +
                            " periods in a row; repeat less often");
    }
    const int most = job.is_in_space() ? space::kMostSites : plane::kMostSites;
    if (double(job.n_wanted()) * job.tile.repeat.n_copies() <= most) return;
    throw LimitExceeded("more than " + std::to_string(most) +
                        " cells in one tile; take fewer sites or repeat less often");
}

void check_order_of_grains(const Job& job) {
    if (job.tile.order != 1 && job.tile.order != 2)
        throw InvalidInput("the order of grains is 1 or 2");
}

void check_meshes(const Job& job) {
    if (job.meshes.empty()) {
        throw InvalidInput("no mesh is given; take " +
                           listed_words(plane::kMeshKinds, ", ", " or "));
    }
    check_order_of_grains(job);
    if (has_mesh(job, &plane::MeshKindRow::grain_size)) check_grains(job);
}

void check_stability(const Job& job) {
    const int most =
        job.is_in_space() ? space::kMostSitesForMinimum : plane::kMostSitesForStability;
    if (!job.stability || job.n_wanted() <= most) return;
    throw InvalidInput("--stability supports at most " + std::to_string(most) + " sites" +
                       (job.is_in_space() ? " in space" : "") +
                       "; leave it out, or take fewer sites");
}

void check_short_edges(const Job& job) {
    if (job.tile.short_edges >= 0 && job.tile.short_edges <= longest_short_edge(job)) return;
    throw InvalidInput(
        std::string("the length under which edges are removed is not between 0 and ") +
        (job.is_in_space() ? "0.1" : "0.5") + " h");
}

void check_centroids(const Job& job) {
    if (!job.centroids || job.sizes->given.size() > 0) return;
    const std::string option = job.is_in_space() ? "--volumes" : "--areas";
    if (job.sizes->is_drawn()) {
        throw InvalidInput(option + " " + job.sizes->name +
                           ": a law does not give the sizes of measured grains; take a table");
    }
}

void check_aspect(const Job& job) {
    if (!job.aspect) return;
    try {
        std::visit(
            [&](const auto& domain) { metric_of(job, domain).require_reducible(domain.lattice); },
            job.domain);
    } catch (const InvalidInput& error) {
        throw InvalidInput(std::string("elongated by the aspect: ") + error.what());
    }
}

/// Requires that the lattice fits the plane group, in the metric as well.
void check_symmetry(const Job& job) {
    if (!job.symmetry) return;
    const plane::PlaneGroup group(*job.symmetry, job.in_plane().lattice);
    if (!job.aspect) return;
    try {
        const plane::PlaneGroup round(
            *job.symmetry, metric_of(job, job.in_plane()).to_round(job.in_plane().lattice));
    } catch (const InvalidInput& error) {
        throw InvalidInput(std::string("elongated by the aspect: ") + error.what());
    }
}

/// @param tags  of the inclusions.
void require_hole(const std::string& hole, const std::vector<std::string>& tags) {
    if (hole == kMatrixTag) {
        throw InvalidInput("the cells of the matrix are not a hole; name the tags of inclusions");
    }
    if (std::find(tags.begin(), tags.end(), hole) == tags.end()) {
        const std::string meant = nearest_word(hole, tags);
        throw InvalidInput(
            "no inclusion has the tag " + in_quotes(hole) + " of a hole; " +
            (meant.empty() ? "the first tag is " + tags.front() : "did you mean " + meant + "?"));
    }
}

void check_holes(const Job& job) {
    if (job.holes.empty()) return;
    const std::vector<std::string> tags = inclusion_tags(job);
    for (std::size_t k = 0; k < job.holes.size(); ++k) {
        require_hole(job.holes[k], tags);
        if (std::find(job.holes.begin(), job.holes.begin() + k, job.holes[k]) ==
            job.holes.begin() + k) {
            continue;
        }
        throw InvalidInput("the hole " + job.holes[k] + " is given twice; leave one out");
    }
}

void check_fixed_sites(const Job& job) {
    if (job.in_plane().fixed.cols() <= job.n_sites) return;
    throw InvalidInput("there are more fixed sites (" +
                       std::to_string(job.in_plane().fixed.cols()) + ") than sites (" +
                       std::to_string(job.n_sites) + "); take more sites");
}

/// Requires that there are sites and room for the inclusions, and orbits for the sites.
void check_constraints(const Job& job) {
    if (job.inclusions) {
        naming_inclusions(job, [&] {
            const std::vector<plane::Inclusion> shapes = plane::without_listed_images(
                job.in_plane().lattice, job.walls, job.inclusions->inclusions);
            double n_seeds = 0;
            for (const plane::Inclusion& shape : shapes) n_seeds += fewest_seeds(shape.shape);
            plane::require_enough_sites(job.n_sites, n_seeds);
            return plane::InclusionSet(job.in_plane().lattice, shapes, job.walls);
        });
    } else if (job.fibres) {
        const plane::Circle fibre{.centre = {0, 0}, .radius = 1};
        plane::require_enough_sites(job.n_sites, job.fibres->n * fewest_seeds(fibre));
    }
    if (job.symmetry) {
        const plane::PlaneGroup group(*job.symmetry, job.in_plane().lattice);
        distribute(group, special_positions(group), job.n_sites);
    }
}

/// Checks what follows from the options of a job in space.
void check_space(const Job& job) {
    check_repetition(job);
    check_stability(job);
    check_short_edges(job);
    check_origin(job.in_space(), job.n_wanted());
    check_order_of_grains(job);
    check_grains_in_space(job);
    check_aspect(job);
}

/// Checks what follows from the options of a job in the plane, but for materials and constraints.
void check_plane(const Job& job) {
    check_aspect(job);
    const double n = job.n_wanted();
    check_symmetry(job);
    check_fixed_sites(job);
    if (job.run.n_threads < 1) throw InvalidInput("the number of threads is below 1; take 1");
    check_short_edges(job);
    check_repetition(job);
    check_stability(job);
    check_meshes(job);
    check_origin(job, reduce_repeated(job), n);
    check_holes(job);
    if (job.inclusions) require_tag_names(*job.inclusions);
}

}  // namespace

bool has_mesh(const Job& job, bool plane::MeshKindRow::*property) {
    return std::any_of(job.meshes.begin(), job.meshes.end(),
                       [property](plane::MeshKind kind) { return mesh_kind_row(kind).*property; });
}

double longest_short_edge(const Job& job) {
    return job.is_in_space() ? space::kLongestShortEdge : kLongestShortEdge;
}

void check_retries(const Job& job, const std::vector<JobFile>& files) {
    if (job.retries == 0) return;
    const bool refusable = std::any_of(
        files.begin(), files.end(), [](const JobFile& file) { return file.format->needs_torus(); });
    if (!refusable) {
        throw InvalidInput(
            "--retry is for outputs that refuse some cells; add -o FILE.nc, or leave it out");
    }
}

void check_job(const Job& job) {
    require_compatible(job);
    check_centroids(job);
    if (job.n_wanted() < 1) throw InvalidInput("no sites; give at least one");
    if (job.is_in_space()) {
        check_space(job);
    } else {
        check_plane(job);
    }
    require_phase_names(job.materials);
    require_one_a_site(job.materials, job.n_wanted());
    if (!job.is_in_space()) check_constraints(job);
}

}  // namespace pcvt
