#include "plugin/job/space_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "mesher/space/tessellation/repeated_cells.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/job_tiles.hpp"
#include "plugin/job/space_box.hpp"
#include "plugin/job/space_grains.hpp"

namespace pcvt {
namespace {

/// The cells of all periods of a tile; nothing where it has one.
std::optional<space::Tessellation> all_periods(const Job& job, const space::Tessellation& cells) {
    if (job.tile.repeat.n_copies() == 1) return std::nullopt;
    return repeated_cells(cells, job.tile.repeat);
}

/// The numbers of cells by their number of faces.
std::map<int, int> face_counts(const space::CellComplex& complex) {
    std::vector<int> n_faces(static_cast<std::size_t>(complex.n_cells), 0);
    for (const space::CellFace& face : complex.faces) {
        ++n_faces[face.cell];
        ++n_faces[face.neighbour];
    }
    std::map<int, int> counts;
    for (const int n : n_faces) ++counts[n];
    return counts;
}

space::TetrahedralMesh grain_tetrahedra(const Job& job, const space::Tessellation& cells,
                                        JobMonitor& monitor, RunSummary& summary) {
    SpaceGrains grains = build_space_grains(job, cells, monitor);
    summary.space_grains = grains.figures;
    return std::move(grains.tetrahedra);
}

/// @throws InvalidInput  a tetrahedron is flat.
space::TetrahedralMesh delaunay_tetrahedra(const Job& job, const space::Tessellation& cells,
                                           const std::string& path) {
    const space::PeriodicDelaunay& delaunay = cells.delaunay;
    const space::Vec3& origin = job.in_space().origin;
    space::TetrahedralMesh mesh =
        cells.elongation ? space::tetrahedral_mesh({cells.sites(), delaunay.tetrahedra}, origin)
                         : tetrahedral_mesh(delaunay, origin);
    const std::vector<int> flat = flat_tetrahedra(mesh, delaunay.sites.n_sites());
    if (flat.empty()) return mesh;
    throw InvalidInput("-o " + path + ": " + flat_in_words(mesh, flat) +
                       "; move the sites a little, or leave " + path + " out");
}

}  // namespace

ProvedSpaceTile build_space_tile(const Job& job, const space::Tessellation& one_period,
                                 const CellMaterials& materials, JobMonitor& monitor) {
    monitor.begin(Phase::kBuilding, "building the cells");
    const std::optional<space::Tessellation> all = all_periods(job, one_period);
    const space::Tessellation& written = all ? *all : one_period;
    const space::PeriodicDelaunay& delaunay = written.delaunay;
    const space::Sites& sites = written.sites();
    space::CellComplex complex = written.complex();
    const std::size_t n_vertices = complex.vertices.size();
    complex = without_short_edges(std::move(complex), job.tile.short_edges);
    const PolyhedraFigures figures{.n_removed_edges =
                                       static_cast<int>(n_vertices - complex.vertices.size())};
    std::map<int, int> counts = face_counts(complex);
    complex = outlined_cells(job, written, std::move(complex));
    const space::Vec3 origin = tile_origin(job, written);
    std::vector<space::Offset> images;
    ProvedSpaceTile built{.tile = {.mesh = polyhedral_mesh(sites, complex, origin, &images)},
                          .figures = figures,
                          .face_counts = std::move(counts)};
    SpaceTile& tile = built.tile;
    tile.mesh.metric = one_period.metric();
    tile.weights = delaunay.weights;
    tile.materials = space::repeated_materials(materials, job.tile.repeat);
    const bool is_box = !complex.piece_cell.empty();
    if (is_box) {
        built.figures.box_origin = origin;
        make_box(origin, tile);
    }
    const bool are_plain = delaunay.weights.size() == 0 && !one_period.elongation;
    tile.sites =
        are_plain && !is_box ? sites_in_cells(sites, tile.mesh) : sites_of_cells(complex, images);
    monitor.begin(Phase::kProving, "proving the cells");
    try {
        built.figures.proof = prove_polyhedra(tile.mesh);
        prove_cell_sites(tile.mesh, tile.sites, tile.weights);
        if (is_box) require_box(tile.mesh, built.figures.proof.tolerance);
    } catch (const NotATile& error) {
        if (job.centroids) throw InvalidInput(unheld_grains(error.what()));
        throw InternalError(std::string("a tile breaks its laws: ") + error.what());
    }
    // The cells of one period.
    for (auto& [n_faces, count] : built.face_counts) {
        count = static_cast<int>(std::lround(count / job.tile.repeat.n_copies()));
    }
    return built;
}

std::optional<space::TetrahedralMesh> build_tetrahedra(const Job& job,
                                                       const space::Tessellation& one_period,
                                                       const std::vector<JobFile>& files,
                                                       JobMonitor& monitor, RunSummary& summary) {
    const bool are_grains = job.meshes.front() == plane::MeshKind::kGrains;
    const auto file = std::find_if(files.begin(), files.end(), [&](const JobFile& f) {
        return f.format->space->shows_tetrahedra(job.meshes.front());
    });
    if (file == files.end() && !are_grains) return {};
    monitor.begin(Phase::kBuilding, "building the tetrahedra");
    const std::optional<space::Tessellation> all = all_periods(job, one_period);
    const space::Tessellation& cells = all ? *all : one_period;
    return space::of_order(job.tile.order, are_grains
                                               ? grain_tetrahedra(job, cells, monitor, summary)
                                               : delaunay_tetrahedra(job, cells, file->path()));
}

}  // namespace pcvt
