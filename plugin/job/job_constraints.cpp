#include "plugin/job/job_constraints.hpp"

#include <array>
#include <span>

#include "mesher/cvt/interface_cvt.hpp"
#include "mesher/mesh/interface_proof.hpp"
#include "mesher/mesh/voronoi.hpp"

namespace pcvt {
namespace {

/// A choice that fixed sites and inclusions exclude, and the remedy.
struct Exclusion {
    bool (*is_made)(const Job& job);
    const char* message;
};

constexpr std::array kExclusions{
    Exclusion{[](const Job& job) { return job.points.cols() > 0; },
              "sites beside fixed ones and inclusions are drawn; give a number of sites instead of "
              "their positions"},
    Exclusion{[](const Job& job) { return job.walls != Walls::kNone; },
              "fixed sites and inclusions need a plane that is periodic along both directions; "
              "leave the walls out"},
    Exclusion{[](const Job& job) { return job.symmetry.has_value(); },
              "fixed sites and inclusions have no symmetry; leave one of the two out"},
    Exclusion{[](const Job& job) { return job.areas.has_value(); },
              "cells of prescribed areas have neither fixed sites nor inclusions; leave the areas "
              "out"},
    Exclusion{[](const Job& job) { return job.start && *job.start != Start::kRandom; },
              "sites beside fixed ones and inclusions start at random; leave the start out"},
    Exclusion{[](const Job& job) { return job.stability; },
              "the stability with fixed sites or inclusions is not known; leave one out"},
};

constexpr std::array kInclusionExclusions{
    Exclusion{[](const Job& job) { return job.inclusions && job.fibres; },
              "fibres are inclusions in random places; leave one of the two out"},
    Exclusion{[](const Job& job) { return job.fixed.cols() > 0; },
              "inclusions have fixed sites of their own; leave one of the two out"},
    Exclusion{[](const Job& job) { return job.aspect.has_value(); },
              "cells beside inclusions are not elongated; leave the aspect out"},
    Exclusion{[](const Job& job) { return !job.materials.phases.empty(); },
              "the tags of inclusions are the phases of their cells; leave the phases out"},
};

void require_none(std::span<const Exclusion> exclusions, const Job& job) {
    for (const Exclusion& exclusion : exclusions) {
        if (exclusion.is_made(job)) throw InvalidInput(exclusion.message);
    }
}

/// The inclusions of the user, or random fibres.
InclusionFile inclusions_of(const Job& job) {
    if (job.inclusions) return *job.inclusions;
    RandomCircles wanted = *job.fibres;
    wanted.seed = job.seed;
    return {.name = "fibres",
            .inclusions = circular_inclusions(random_circles(job.lattice, wanted), 1),
            .tags = {"fibre"}};
}

/// Calls `work`, whose refusals get the name of the file.
template <class Work>
auto named(const InclusionFile& file, const Work& work) {
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw InvalidInput(file.name + ": " + error.what());
    }
}

/// Sets the tags of the matrix and of the inclusions.
void set_tags(const InclusionFile& file, Tessellation& cells) {
    cells.tag_names = {kMatrixTag};
    cells.tag_names.insert(cells.tag_names.end(), file.tags.begin(), file.tags.end());
    cells.tag_areas.assign(cells.tag_names.size(), 0);
    cells.tag_areas[0] = cells.lattice().area();
    for (const Inclusion& inclusion : file.inclusions) {
        const double area = shape_area(inclusion.shape);
        cells.tag_areas[inclusion.tag] += area;
        cells.tag_areas[0] -= area;
    }
}

}  // namespace

void check_constraints(const Job& job) {
    if (job.fixed.cols() > 0 || job.has_inclusions()) require_none(kExclusions, job);
    if (job.fixed.cols() > job.n_sites) {
        throw InvalidInput("there are " + std::to_string(job.fixed.cols()) +
                           " fixed sites, more than all sites; take more sites in all");
    }
    if (!job.has_inclusions()) return;
    require_none(kInclusionExclusions, job);
    if (job.inclusions) {
        named(*job.inclusions,
              [&] { return InclusionSet(job.lattice, job.inclusions->inclusions); });
    }
}

Tessellation compute_cells_with_inclusions(const Job& job, const CvtOptions& options) {
    const InclusionFile file = inclusions_of(job);
    InterfaceCvt result = named(file, [&] {
        const InclusionSet set(job.lattice, file.inclusions);
        return compute_interface_cvt(set, job.n_sites, job.seed, options);
    });
    const PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
    if (const auto wrong = interface_violation(cells, result.interfaces, result.inclusion)) {
        throw InternalError(*wrong);
    }
    std::vector<Circle> fibres;
    if (job.fibres) {
        for (const Inclusion& fibre : file.inclusions) {
            fibres.push_back(std::get<Circle>(fibre.shape));
        }
    }
    const InterfaceFigures figures{.source = file.name,
                                   .n_shapes = static_cast<int>(file.inclusions.size()),
                                   .fibres = std::move(fibres),
                                   .n_chords = static_cast<int>(result.interfaces.chords.size()),
                                   .n_fixed = result.interfaces.n_seeds(),
                                   .n_held = static_cast<int>(result.held.size())};
    Tessellation tessellation{.delaunay = std::move(result.cvt.delaunay),
                              .run = result.cvt.run,
                              .counts = result.cvt.counts,
                              .density = result.cvt.density,
                              .site_tags = std::move(result.tag),
                              .interfaces = figures};
    set_tags(file, tessellation);
    return tessellation;
}

CellMaterials tag_materials(const Tessellation& tessellation) {
    return {.phase_names = tessellation.tag_names, .site_phase = tessellation.site_tags};
}

std::vector<PhaseFigures> tag_figures(const Tessellation& tessellation, const CellTable& cells) {
    MaterialChoices tags;
    for (std::size_t k = 0; k < tessellation.tag_names.size(); ++k) {
        const double share = tessellation.tag_areas[k] / tessellation.lattice().area();
        tags.phases.push_back({tessellation.tag_names[k], share});
    }
    return phase_figures(tags, tag_materials(tessellation), cells);
}

}  // namespace pcvt
