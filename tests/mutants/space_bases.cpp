#include "tests/mutants/space_bases.hpp"

#include "io/formats/space_file_proof.hpp"
#include "io/gltf/space_gltf_proof.hpp"
#include "io/graphics/stl_proof.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/mesh/elongated_cells.hpp"
#include "tests/support/space_tiles.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt::testing {
namespace {

std::vector<SpaceCase> cases() {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    const space::Lattice left_handed({1, 0, 0}, {0, 0, 1.1}, {0.3, 0.8, 0});
    return {{"one", oblique, uniform_points(oblique, 1, 2)},
            {"octahedra", cube, lattice_points(2)},
            {"left-handed", left_handed, uniform_points(left_handed, 3, 1)},
            {"oblique", oblique, uniform_points(oblique, 5, 3)}};
}

/// Adds the files of a tile, in each form of its surfaces.
void add_space_tile(const SpaceFormat& format, const SpaceCase& c, const std::string& path,
                    std::vector<BaseFile>& bases) {
    const SpaceTile tile = tile_of(c);
    const bool closes = prove_polyhedra(tile.mesh).boundary_is_manifold;
    for (const SurfaceFormRow& row : kSurfaceForms) {
        if (format.shows_boundary(row.form) && !closes) continue;
        const bool has_forms = format.surfaces == FormatSurfaces::kChosen;
        bases.push_back({(has_forms ? std::string(row.word) + " " : "") + c.name,
                         plane::MeshKind::kVoronoi,
                         format.encode(tile, {.surfaces = row.form}, path)});
        if (!has_forms) break;
    }
}

void add_without_short_edges(const SpaceFormat& format, const SpaceCase& c, const std::string& path,
                             std::vector<BaseFile>& bases) {
    if (!format.takes_short_edges(plane::MeshKind::kVoronoi) || format.encode == nullptr ||
        format.is_picture())
        return;
    bases.push_back(
        {"short " + c.name, plane::MeshKind::kVoronoi, format.encode(tile_of(c, 0.05), {}, path)});
}

/// Adds cells of a metric.
void add_elongated(const SpaceFormat& format, const SpaceCase& c, const std::string& path,
                   std::vector<BaseFile>& bases) {
    const space::Metric metric(3, {1, 0.5, 0});
    const space::PeriodicDelaunay round = space::periodic_delaunay(
        space::Sites(metric.to_round(c.lattice), metric.to_round(c.points)));
    const space::Sites sites = metric.from_round(round.sites, c.lattice);
    const space::CellComplex complex =
        from_round(cell_complex(round.sites, round.tetrahedra), metric, sites);
    std::vector<space::Offset> images;
    SpaceTile tile{.mesh = polyhedral_mesh(sites, complex, {0, 0, 0}, &images)};
    tile.mesh.metric = metric;
    tile.sites = sites_of_cells(complex, images);
    bases.push_back(
        {"elongated " + c.name, plane::MeshKind::kVoronoi, format.encode(tile, {}, path)});
}

/// Adds cells with phases and orientations, and power cells with their weights.
void add_materials(const SpaceFormat& format, const SpaceCase& c, const std::string& path,
                   std::vector<BaseFile>& bases) {
    if (!format.states_materials || format.encode == nullptr) return;
    SpaceTile tile = tile_of(c);
    tile.materials = some_materials(5);
    bases.push_back(
        {"materials " + c.name, plane::MeshKind::kVoronoi, format.encode(tile, {}, path)});
    for (const ColouringRow& row : kColourings) {
        if (!format.takes.colouring || !row.in_space || row.colouring == Colouring::kFaces)
            continue;
        // Only the materials that the colours show.
        if (row.colouring != Colouring::kPhase) tile.materials.site_phase.clear();
        if (row.colouring != Colouring::kPhase) tile.materials.phase_names.clear();
        if (row.colouring != Colouring::kOrientation) tile.materials.site_orientation.clear();
        bases.push_back({std::string("by ") + row.word + " " + c.name, plane::MeshKind::kVoronoi,
                         format.encode(tile, {.colouring = row.colouring}, path)});
        tile.materials = some_materials(5);
    }
    if (!format.states_weights) return;
    if (format.states_metric) add_elongated(format, c, path, bases);
    const SpaceTile power = power_tile_of(c, 0.02);
    bases.push_back({"power " + c.name, plane::MeshKind::kVoronoi, format.encode(power, {}, path)});
}

void add_tetrahedra(const SpaceFormat& format, const SpaceCase& c, const std::string& path,
                    std::vector<BaseFile>& bases) {
    const space::PeriodicDelaunay delaunay =
        space::periodic_delaunay(space::Sites(c.lattice, c.points));
    const space::TetrahedralMesh mesh = tetrahedral_mesh(delaunay);
    // Some tetrahedra of exact lattices are flat.
    if (!flat_tetrahedra(mesh, delaunay.sites.n_sites()).empty()) return;
    bases.push_back({"tetrahedra " + c.name, plane::MeshKind::kDelaunay,
                     format.encode_tetrahedra(mesh, {}, path)});
}

/// Adds ten-node tetrahedra inside of cells with phases and orientations.
void add_grains(const SpaceFormat& format, const std::string& path, std::vector<BaseFile>& bases) {
    space::TetrahedralMesh mesh = grain_tetrahedra(2);
    mesh.order = 2;
    const CellMaterials materials = some_materials(2);
    bases.push_back({"materials of grains", plane::MeshKind::kGrains,
                     format.encode_tetrahedra(mesh, {.materials = &materials}, path)});
}

/// Voxels with and without materials and weights, for which the tetrahedra are still regular.
std::vector<BaseFile> space_voxel_files(const SpaceFormat& format, const std::string& path) {
    constexpr int kCells = 7;
    const space::Lattice box = space::Lattice::box(1.3, 0.7, 0.9);
    const auto delaunay =
        space::periodic_delaunay(space::Sites(box, uniform_points(box, kCells, 4)));
    const space::VoxelGrid grid = voxel_grid(box, {0.123, -7.3, 2}, {14, 8, 9});
    const space::VoxelImage image = voxel_image(delaunay, {}, grid, 1);
    space::VoxelCells cells{.lattice = box, .sites = delaunay.sites.positions()};
    std::vector<BaseFile> bases{
        {"voxels", plane::MeshKind::kVoronoi, format.encode_voxels(image, cells, {}, {}, path)}};
    CellMaterials materials{.phase_names = {"alpha", "beta"}};
    for (int s = 0; s < kCells; ++s) {
        materials.site_phase.push_back(s % 2);
        materials.site_orientation.push_back({10.0 * s, 20.0 + s, 30.0});
    }
    cells.weights = Eigen::VectorXd::LinSpaced(kCells, 0, 0.06);
    const space::VoxelImage weighted = voxel_image(delaunay, cells.weights, grid, 1);
    bases.push_back({"voxels with materials", plane::MeshKind::kVoronoi,
                     format.encode_voxels(weighted, cells, materials, {}, path)});
    return bases;
}

void prove(SpaceFileKind kind, const Files& files) {
    switch (kind) {
        case SpaceFileKind::kPolyhedra:
            prove_space_files(files);
            return;
        case SpaceFileKind::kTetrahedra:
            prove_tetrahedral_files(files);
            return;
        case SpaceFileKind::kBoundary:
            prove_boundary_files(files);
            return;
        case SpaceFileKind::kClosedSurfaces:
            prove_stl(files.front());
            return;
        case SpaceFileKind::kTriangles:
            prove_glb_surfaces(files.front(), decode_glb_surfaces(files.front()));
            return;
    }
}

}  // namespace

std::vector<BaseFile> space_base_files(std::string_view extension) {
    const std::string path = "tile" + std::string(extension);
    const SpaceFormat& format = *find_format(path)->space;
    if (format.encode_voxels != nullptr) return space_voxel_files(format, path);
    std::vector<BaseFile> bases;
    for (const SpaceCase& c : cases()) {
        if (format.encode != nullptr) add_space_tile(format, c, path, bases);
        if (c.name == "oblique") add_without_short_edges(format, c, path, bases);
        if (c.name == "oblique") add_materials(format, c, path, bases);
        if (format.shows_tetrahedra(plane::MeshKind::kDelaunay))
            add_tetrahedra(format, c, path, bases);
    }
    if (format.encode_tetrahedra != nullptr) add_grains(format, path, bases);
    return bases;
}

std::string space_refusal(std::string_view extension, const Files& files) {
    try {
        const std::optional<SpaceFileKind> kind = space_file_kind(files);
        // `pcvt check` takes such a file for one of the plane.
        if (!kind) return refusal(extension, files);
        prove(*kind, files);
        return "";
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
}

}  // namespace pcvt::testing
