#include "plugin/job/job_constraints.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "io/bytes/nearest_word.hpp"
#include "io/bytes/text.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/plane/cvt/interface_cvt.hpp"
#include "mesher/plane/mesh/interface_proof.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt {
namespace {

constexpr const char* kFibreTag = "fibre";

/// The inclusions of the user, or random fibres.
InclusionFile inclusions_of(const Job& job) {
    if (job.inclusions) return *job.inclusions;
    plane::RandomCircles wanted = *job.fibres;
    wanted.seed = job.seed;
    wanted.walls = job.walls;
    return {.name = "fibres",
            .inclusions = circular_inclusions(random_circles(job.in_plane().lattice, wanted), 1),
            .tags = {kFibreTag}};
}

std::vector<std::string> inclusion_tags(const Job& job) {
    return job.inclusions ? job.inclusions->tags : std::vector<std::string>{kFibreTag};
}

/// @param kind   what has the name, in words.
/// @param names  of all phases and tags.
void require_free_name(const std::string& kind, const std::string& name,
                       const std::vector<std::string>& names) {
    const std::optional<std::string> set = set_with_name(name, names);
    if (!set) return;
    throw InvalidInput(kind + " " + name + " has the name of a set in files (" + *set +
                       "); rename it");
}

/// Requires names that no set, group or patch has which files may contain beside those of the
/// names.
void check_names(const Job& job) {
    std::vector<std::string> names;
    for (const PhaseFraction& phase : job.materials.phases) names.push_back(phase.name);
    for (const std::string& phase : names) require_free_name("the phase", phase, names);
    if (!job.inclusions) return;
    names = job.inclusions->tags;
    names.emplace_back(kMatrixTag);
    for (const plane::Inclusion& inclusion : job.inclusions->inclusions) {
        const std::string where =
            job.inclusions->name + ":" + std::to_string(inclusion.line) + ": the tag";
        require_free_name(where, job.inclusions->tags[inclusion.tag - 1], names);
    }
}

/// @param tags  of the inclusions.
void require_hole(const std::string& hole, const std::vector<std::string>& tags) {
    if (hole == kMatrixTag) {
        throw InvalidInput("the cells of the matrix are no hole; name the tags of inclusions");
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

/// The sites of the holes of a job.
plane::HoleSites hole_sites(const Job& job, const Tessellation& cells) {
    plane::HoleSites holes{.names = job.holes};
    if (holes.empty()) return holes;
    for (const int tag : cells.site_tags) {
        const auto hole = std::find(job.holes.begin(), job.holes.end(), cells.tag_names[tag]);
        holes.of_site.push_back(hole == job.holes.end() ? -1 : int(hole - job.holes.begin()));
    }
    return holes;
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

/// Of fewer seeds, the placement itself is fast, and names a number of sites that suffices.
constexpr double kManySeeds = 10'000;

/// Refuses a number of sites that cannot suffice for the outlines of many shapes, before any work.
void require_sites(const Job& job, double fewest) {
    if (job.n_sites >= fewest || fewest < kManySeeds) return;
    throw InvalidInput(
        std::to_string(job.n_sites) + " sites are too few for the inclusions; take " +
        std::to_string(static_cast<long>(fewest)) + " or more, the least that their outlines need");
}

/// Sets the tags of the matrix and of the inclusions.
void set_tags(const InclusionFile& file, Tessellation& cells) {
    cells.tag_names = {kMatrixTag};
    cells.tag_names.insert(cells.tag_names.end(), file.tags.begin(), file.tags.end());
    cells.tag_areas.assign(cells.tag_names.size(), 0);
    cells.tag_areas[0] = cells.lattice().area();
    for (const plane::Inclusion& inclusion : file.inclusions) {
        const double area = shape_area(inclusion.shape);
        cells.tag_areas[inclusion.tag] += area;
        cells.tag_areas[0] -= area;
    }
}

}  // namespace

void check_constraints(const Job& job) {
    check_names(job);
    check_holes(job);
    if (job.in_plane().fixed.cols() > job.n_sites) {
        throw InvalidInput("there are more fixed sites (" +
                           std::to_string(job.in_plane().fixed.cols()) + ") than sites (" +
                           std::to_string(job.n_sites) + "); take more sites");
    }
    if (!job.has_inclusions()) return;
    if (job.fibres) {
        require_sites(job,
                      job.fibres->n * fewest_seeds(plane::Circle{.centre = {0, 0}, .radius = 1}));
        return;
    }
    named(*job.inclusions, [&] {
        double fewest = 0;
        for (const plane::Inclusion& shape : job.inclusions->inclusions)
            fewest += fewest_seeds(shape.shape);
        require_sites(job, fewest);
        return plane::InclusionSet(job.in_plane().lattice, job.inclusions->inclusions, job.walls);
    });
}

Tessellation compute_cells_with_inclusions(const Job& job, const plane::CvtOptions& options) {
    const InclusionFile file = inclusions_of(job);
    plane::InterfaceCvt result = named(file, [&] {
        plane::InclusionSet set(job.in_plane().lattice, file.inclusions, job.walls);
        if (job.tile.outline == plane::Outline::kBox && !job.tile.finds_origin)
            set.set_box(job.tile.origin);
        return compute_interface_cvt(set, job.n_sites, job.seed, options, job.wall_cells);
    });
    const plane::PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
    if (const auto wrong = interface_violation(cells, result.interfaces, result.inclusion)) {
        throw InternalError(*wrong);
    }
    const InterfaceFigures figures{.source = file.name,
                                   .shapes = file.inclusions,
                                   .are_drawn = job.fibres.has_value(),
                                   .n_chords = static_cast<int>(result.interfaces.chords.size()),
                                   .n_fixed = result.interfaces.n_seeds(),
                                   .n_held = static_cast<int>(result.held.size())};
    Tessellation tessellation{.delaunay = std::move(result.cvt.delaunay),
                              .walled = result.walled,
                              .run = result.cvt.run,
                              .counts = result.cvt.counts,
                              .density = result.cvt.density,
                              .site_tags = std::move(result.tag),
                              .interfaces = figures};
    set_tags(file, tessellation);
    tessellation.holes = hole_sites(job, tessellation);
    return tessellation;
}

CellMaterials tag_materials(const Tessellation& tessellation) {
    const plane::HoleSites& holes = tessellation.holes;
    if (holes.empty()) {
        return {.phase_names = tessellation.tag_names, .site_phase = tessellation.site_tags};
    }
    CellMaterials materials;
    std::vector<int> phase_of_tag;
    for (const std::string& name : tessellation.tag_names) {
        const bool is_hole =
            std::find(holes.names.begin(), holes.names.end(), name) != holes.names.end();
        phase_of_tag.push_back(is_hole ? -1 : static_cast<int>(materials.phase_names.size()));
        if (!is_hole) materials.phase_names.push_back(name);
    }
    for (const SiteId s : holes.kept()) {
        materials.site_phase.push_back(phase_of_tag[tessellation.site_tags[s]]);
    }
    return materials;
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

std::vector<PhaseFigures> tag_figures(const Tessellation& tessellation, const CellTable& cells) {
    MaterialChoices tags;
    for (std::size_t k = 0; k < tessellation.tag_names.size(); ++k) {
        const double share = tessellation.tag_areas[k] / tessellation.lattice().area();
        tags.phases.push_back({tessellation.tag_names[k], share});
    }
    const CellMaterials of_all{.phase_names = tessellation.tag_names,
                               .site_phase = tessellation.site_tags};
    return phase_figures(tags, of_all, cells);
}

}  // namespace pcvt
