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

InclusionSet inclusion_set(const Job& job) {
    try {
        return {job.lattice, job.inclusions->inclusions};
    } catch (const InvalidInput& error) {
        throw InvalidInput(job.inclusions->name + ": " + error.what());
    }
}

}  // namespace

void check_constraints(const Job& job) {
    if (job.fixed.cols() > 0 || job.inclusions) require_none(kExclusions, job);
    if (job.fixed.cols() > job.n_sites) {
        throw InvalidInput("there are " + std::to_string(job.fixed.cols()) +
                           " fixed sites, more than all sites; take more sites in all");
    }
    if (!job.inclusions) return;
    require_none(kInclusionExclusions, job);
    inclusion_set(job);
}

Tessellation compute_cells_with_inclusions(const Job& job, const CvtOptions& options) {
    InterfaceCvt result = [&] {
        try {
            return compute_interface_cvt(inclusion_set(job), job.n_sites, job.seed, options);
        } catch (const InvalidInput& error) {
            throw InvalidInput(job.inclusions->name + ": " + error.what());
        }
    }();
    const PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
    if (const auto wrong = interface_violation(cells, result.interfaces, result.inclusion)) {
        throw InternalError(*wrong);
    }
    const InterfaceFigures figures{.n_chords = static_cast<int>(result.interfaces.chords.size()),
                                   .n_fixed = result.interfaces.n_seeds(),
                                   .n_held = static_cast<int>(result.held.size())};
    return {.delaunay = std::move(result.cvt.delaunay),
            .run = result.cvt.run,
            .counts = result.cvt.counts,
            .density = result.cvt.density,
            .site_tags = std::move(result.tag),
            .interfaces = figures};
}

CellMaterials tag_materials(const InclusionFile& inclusions, const Tessellation& cells) {
    CellMaterials materials{.phase_names = {kMatrixTag}, .site_phase = cells.site_tags};
    materials.phase_names.insert(materials.phase_names.end(), inclusions.tags.begin(),
                                 inclusions.tags.end());
    return materials;
}

std::vector<PhaseFigures> tag_figures(const Job& job, const CellMaterials& materials,
                                      const CellTable& cells) {
    std::vector<double> wanted(materials.phase_names.size());
    wanted[0] = 1;
    for (const Inclusion& inclusion : job.inclusions->inclusions) {
        const double share = shape_area(inclusion.shape) / job.lattice.area();
        wanted[inclusion.tag] += share;
        wanted[0] -= share;
    }
    MaterialChoices tags;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        tags.phases.push_back({materials.phase_names[k], wanted[k]});
    }
    return phase_figures(tags, materials, cells);
}

}  // namespace pcvt
