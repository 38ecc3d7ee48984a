#include "tests/mutants/base_files.hpp"

#include "io/formats/file_proof.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"
#include "mesher/plane/voxels/voxel_image.hpp"
#include "tests/support/holed_tiles.hpp"
#include "tests/support/power_tiles.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt::testing {
namespace {

constexpr int kSites = 7;

struct Shape {
    const char* name;
    plane::TileOptions options;
};

std::vector<Shape> shapes() {
    return {{"voronoi whole", {.kind = plane::MeshKind::kVoronoi}},
            {"voronoi box", {.kind = plane::MeshKind::kVoronoi, .outline = plane::Outline::kBox}},
            {"voronoi whole 2x1", {.kind = plane::MeshKind::kVoronoi, .repeat = {2, 1}}},
            {"voronoi short-edges", {.kind = plane::MeshKind::kVoronoi, .short_edges = 0.2}},
            {"delaunay", {.kind = plane::MeshKind::kDelaunay}},
            {"delaunay 1x2", {.kind = plane::MeshKind::kDelaunay, .repeat = {1, 2}}},
            {"grains whole", {.kind = plane::MeshKind::kGrains, .grain_per_edge = 1}},
            {"grains box", {.kind = plane::MeshKind::kGrains, .outline = plane::Outline::kBox}}};
}

std::vector<Shape> power_shapes() {
    return {
        {"voronoi power", {.kind = plane::MeshKind::kVoronoi}},
        {"voronoi power box", {.kind = plane::MeshKind::kVoronoi, .outline = plane::Outline::kBox}},
        {"voronoi power 2x1", {.kind = plane::MeshKind::kVoronoi, .repeat = {2, 1}}},
        {"delaunay power", {.kind = plane::MeshKind::kDelaunay}},
        {"grains power", {.kind = plane::MeshKind::kGrains, .grain_per_edge = 1}}};
}

std::vector<Shape> symmetric_shapes() {
    return {{"voronoi symmetric", {.kind = plane::MeshKind::kVoronoi}},
            {"voronoi symmetric box",
             {.kind = plane::MeshKind::kVoronoi, .outline = plane::Outline::kBox}},
            {"delaunay symmetric", {.kind = plane::MeshKind::kDelaunay}},
            {"grains symmetric", {.kind = plane::MeshKind::kGrains, .grain_per_edge = 1}}};
}

/// A tile between walls.
struct WalledShape {
    Shape shape;
    Walls walls;
    WallCells cells;
    int n_sites;
};

std::vector<WalledShape> walled_shapes() {
    const plane::TileOptions cells{.kind = plane::MeshKind::kVoronoi};
    const plane::TileOptions box{.kind = plane::MeshKind::kVoronoi,
                                 .outline = plane::Outline::kBox};
    const plane::TileOptions triangles{.kind = plane::MeshKind::kDelaunay};
    const plane::TileOptions grains{.kind = plane::MeshKind::kGrains, .grain_per_edge = 1};
    return {{{"voronoi walled", cells}, Walls::kXY, WallCells::kWhole, kSites},
            {{"voronoi walled box", box}, Walls::kX, WallCells::kWhole, kSites},
            {{"delaunay walled half", triangles}, Walls::kY, WallCells::kHalf, 2 * kSites},
            {{"grains walled", grains}, Walls::kY, WallCells::kWhole, kSites}};
}

/// Cells and grains with holes.
std::vector<Shape> holed_shapes() {
    return {
        {"voronoi holes", {}},
        {"grains holes box",
         {.kind = plane::MeshKind::kGrains, .outline = plane::Outline::kBox, .grain_per_edge = 1}}};
}

/// A symmetric start of kSites sites: three pairs and a centre of rotation.
plane::SymmetricSites symmetric_sites(const plane::Lattice& lattice) {
    const plane::PlaneGroup group(plane::PlaneGroupName::kP2, lattice);
    return random_sites(
        group, {.n_general = 3, .on_mirrors = {}, .at_centres = {true, false, false, false}}, 5);
}

const CellMaterials& materials() {
    static const CellMaterials all{.phase_names = {"a", "b"},
                                   .site_phase = {0, 1, 1, 0, 1, 1, 0},
                                   .site_orientation = random_orientations(kSites, 1)};
    return all;
}

/// The forms in which a format writes one tile of kSites sites.
std::vector<std::pair<const char*, FileOptions>> forms(const Format& format, plane::MeshKind kind) {
    std::vector<std::pair<const char*, FileOptions>> forms{{"", {}}};
    if (format.takes.gltf_nodes) forms.push_back({" one-node", {.gltf_nodes = GltfNodes::kOne}});
    if (format.takes.single_precision) forms.push_back({" float32", {.single_precision = true}});
    if (format.takes.colouring) forms.push_back({" by-size", {.colouring = Colouring::kSize}});
    if ((format.takes.phases || format.takes.orientations) && faces_have_sites(kind)) {
        forms.push_back({" materials", {.materials = &materials()}});
    }
    return forms;
}

bool holds(const Format& format, const plane::Tile& tile, plane::Outline outline) {
    if (!format.holds_polygons && tile.kind == plane::MeshKind::kVoronoi) return false;
    if (format.check == nullptr) return true;
    try {
        format.check({.lattice = tile.lattice,
                      .tile = {.kind = tile.kind, .outline = outline},
                      .n_sites = 0});
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

void add_tile(const Format& format, const plane::Tile& tile, const Shape& shape,
              const FileOptions& options, std::vector<BaseFile>& bases) {
    if (!holds(format, tile, shape.options.outline)) return;
    const std::string path = "tile" + std::string(format.extension);
    bases.push_back({shape.name, tile.kind, encode_tile(format, tile, path, options)});
}

void add_tiles(const Format& format, plane::Tile tile, const Shape& shape,
               std::vector<BaseFile>& bases) {
    if (!holds(format, tile, shape.options.outline)) return;
    const std::string path = "tile" + std::string(format.extension);
    for (const auto& [form, options] : forms(format, tile.kind)) {
        bases.push_back(
            {std::string(shape.name) + form, tile.kind, encode_tile(format, tile, path, options)});
    }
    if (format.highest_order < 2 || tile.kind != plane::MeshKind::kGrains) return;
    tile.order = 2;
    bases.push_back(
        {std::string(shape.name) + " order 2", tile.kind, encode_tile(format, tile, path, {})});
}

std::vector<BaseFile> grid_files(const Format& format) {
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 0.8);
    const plane::CvtResult result = compute_cvt(lattice, uniform_points(lattice, 12, 1), {});
    const plane::PeriodicMesh cells = cell_mesh(result.delaunay);
    const Torus torus{.cells = cells,
                      .origin = plane::Vec2::Zero(),
                      .site_densities = {},
                      .history = "pcvt 0.0.0: mesh; seed 0"};
    return {{"grid", plane::MeshKind::kVoronoi,
             std::get<TorusWriter*>(format.write)(torus, {.coriolis = {{1e-4, 0.3}}}, "tile.nc")}};
}

/// Voxels of plain, power and elongated cells; the last lattice is a rectangle of two domains.
std::vector<BaseFile> voxel_files(const Format& format) {
    const plane::Lattice skew({1.1, 0}, {0.55, 0.9});
    std::vector<BaseFile> bases;
    const auto add = [&](const char* name, const CellShape& shape, const plane::Lattice& lattice,
                         const plane::Lattice& whole, plane::VoxelCounts counts,
                         const CellMaterials& of_cells) {
        const plane::PeriodicDelaunay delaunay = power_cells(lattice, kSites, 5, shape).delaunay;
        plane::VoxelCells cells{.lattice = lattice,
                                .sites = plane::Points(2, kSites),
                                .weights = delaunay.weights(),
                                .metric = shape.metric};
        for (SiteId s = 0; s < kSites; ++s) {
            cells.sites.col(s) = shape.metric.from_round(delaunay.sites().position(s));
        }
        const plane::VoxelGrid grid = voxel_grid(whole, {0.123, -7.3}, counts);
        const plane::VoxelImage image = voxel_image(delaunay, shape.metric, grid, 1);
        bases.push_back(
            {name, plane::MeshKind::kVoronoi,
             std::get<VoxelWriter*>(format.write)(image, cells, of_cells, {}, "tile.vti")});
    };
    const plane::Lattice box = plane::Lattice::rectangle(2.3, 0.7);
    const std::vector<CellShape> shapes = cell_shapes();
    add("plain", {"plain", "equal"}, box, box, {60, 20}, {});
    add("power", shapes[0], box, box, {60, 20}, materials());
    add("elongated", shapes[2], box, box, {60, 20}, materials());
    add("two domains", shapes[0], skew, skew.repeated(1, 2), {24, 36}, materials());
    return bases;
}

}  // namespace

std::vector<BaseFile> base_files(std::string_view extension) {
    const Format& format = *find_format("tile" + std::string(extension));
    if (format.needs_torus()) return grid_files(format);
    if (format.reads_voxels()) return voxel_files(format);
    const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    const plane::CvtResult result = compute_cvt(lattice, uniform_points(lattice, kSites, 5), {});
    std::vector<BaseFile> bases;
    for (const Shape& shape : shapes()) {
        add_tiles(format, build_tile(result.delaunay, shape.options).tile, shape, bases);
    }
    // The last of the shapes of cells has weights and a metric.
    for (const Shape& shape : power_shapes()) {
        const CellShape cells = cell_shapes().back();
        add_tiles(format, power_tile(lattice, kSites, 5, cells, shape.options), shape, bases);
    }
    // The formats of solvers name the walls.
    for (const auto& [shape, walls, cells, n] :
         format.fields == nullptr ? std::vector<WalledShape>{} : walled_shapes()) {
        add_tile(format, walled_tile(walls, cells, n, shape.options), shape, {}, bases);
    }
    for (const Shape& shape : holed_shapes()) {
        add_tile(format, tile_with_a_hole(shape.options), shape, {}, bases);
    }
    if (!format.states_orbits) return bases;
    const plane::SymmetricSites start = symmetric_sites(lattice);
    // At a minimum, cells of different orbits may have one area.
    plane::CvtOptions few_steps;
    few_steps.run.max_iterations = 2;
    const plane::PeriodicDelaunay symmetric = compute_cvt(start, few_steps).delaunay;
    for (const Shape& shape : symmetric_shapes()) {
        const plane::Tile tile = build_tile(symmetric, shape.options).tile;
        add_tile(format, tile, shape, {.site_orbits = start.orbit}, bases);
    }
    return bases;
}

std::string refusal(std::string_view extension, const Files& files) {
    const Format& format = *find_format("tile" + std::string(extension));
    try {
        if (const auto* read = std::get_if<GridReader*>(&format.read)) {
            prove_grid(files, (*read)(files));
        } else if (const auto* voxels = std::get_if<VoxelReader*>(&format.read)) {
            prove_voxel_file(files, (*voxels)(files));
        } else {
            prove_file(format, files, decode_tile(format, files, std::nullopt));
        }
        return "";
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
}

}  // namespace pcvt::testing
