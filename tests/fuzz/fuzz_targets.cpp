#include "tests/fuzz/fuzz_targets.hpp"

#include <algorithm>
#include <exception>
#include <new>

#include "io/formats/file_proof.hpp"
#include "io/formats/formats.hpp"
#include "io/gltf/space_gltf_proof.hpp"
#include "io/graphics/seam_json.hpp"
#include "io/graphics/stl_proof.hpp"
#include "io/run_files/area_reader.hpp"
#include "io/run_files/density_expression.hpp"
#include "io/run_files/density_image.hpp"
#include "io/run_files/inclusion_reader.hpp"
#include "io/run_files/orientation_reader.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/run_files/site_writer.hpp"
#include "io/voxels/vti_writer.hpp"
#include "mesher/base/error.hpp"
#include "mesher/finite_volume/mpas_grid_proof.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/interfaces/inclusion_set.hpp"
#include "mesher/plane/interfaces/listed_images.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "plugin/study/study.hpp"
#include "tests/support/hexagons.hpp"
#include "tests/support/png_bytes.hpp"
#include "tests/support/power_tiles.hpp"
#include "tests/support/space_tiles.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt::testing {
namespace {

/// Separates the files of one input; text formats hold no such byte.
constexpr char kNextFile = '\x1c';
/// Files of sites up to this size are meshed as well.
constexpr Eigen::Index kMostMeshedSites = 24;
/// Images up to this size are integrated as well.
constexpr int kMostSampledPixels = 1 << 12;

const plane::Lattice& oblique() {
    static const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    return lattice;
}

plane::PeriodicDelaunay few_sites(int n) {
    return plane::PeriodicDelaunay(plane::Sites(oblique(), uniform_points(oblique(), n, 5)));
}

/// Small tiles of every kind, outline and order.
std::vector<plane::Tile> example_tiles() {
    std::vector<plane::Tile> tiles;
    for (const plane::TileOptions& options :
         {plane::TileOptions{.kind = plane::MeshKind::kVoronoi},
          plane::TileOptions{.kind = plane::MeshKind::kVoronoi, .outline = plane::Outline::kBox},
          plane::TileOptions{.kind = plane::MeshKind::kDelaunay, .repeat = {2, 1}},
          plane::TileOptions{.kind = plane::MeshKind::kGrains, .grain_per_edge = 1},
          plane::TileOptions{.kind = plane::MeshKind::kGrains, .grain_per_edge = 1, .order = 2}}) {
        tiles.push_back(build_tile(few_sites(3), options).tile);
    }
    // The last of the shapes of cells has weights and a metric.
    const testing::CellShape shape = testing::cell_shapes().back();
    for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kGrains}) {
        tiles.push_back(testing::power_tile(oblique(), 3, 1, shape, {.kind = kind}));
    }
    return tiles;
}

/// The forms of files that change more than colours.
std::vector<FileOptions> file_forms(const Format& format) {
    std::vector<FileOptions> forms(1);
    if (format.takes.gltf_nodes) {
        forms[0].gltf_nodes = GltfNodes::kCells;
        forms.push_back({.gltf_nodes = GltfNodes::kOne});
    }
    if (format.takes.single_precision) forms.push_back({.single_precision = true});
    return forms;
}

std::vector<std::string> tile_seeds(const Format& format) {
    std::vector<std::string> seeds;
    const std::string path = "t" + std::string(format.extension);
    for (const plane::Tile& tile : example_tiles()) {
        if (!format.holds_polygons && tile.kind == plane::MeshKind::kVoronoi) continue;
        if (tile.order > format.highest_order) continue;
        for (const FileOptions& form : file_forms(format)) {
            std::vector<std::string> files;
            for (const EncodedFile& file : encode_tile(format, tile, path, form)) {
                files.push_back(file.bytes);
            }
            seeds.push_back(join_files(files));
        }
    }
    return seeds;
}

void read_tile(const Format& format, const std::string& bytes) {
    const std::string path = "t" + std::string(format.extension);
    const std::vector<std::string> paths = format.paths(path);
    std::vector<EncodedFile> files;
    if (paths.size() == 1) {
        files.push_back({path, bytes});
    } else {
        const std::vector<std::string> parts = split_files(bytes);
        for (std::size_t k = 0; k < std::min(parts.size(), paths.size()); ++k) {
            files.push_back({paths[k], parts[k]});
        }
    }
    const TileFile file = decode_tile(format, files, oblique());
    const plane::TileProof proof = prove_file(format, files, file);
    if (file.tile.kind != plane::MeshKind::kGrains) prove_voronoi(file.tile, proof, 1e-6);
}

/// The files of a tile in space with three cells in each form, of one without its short edges, and
/// of tetrahedra, as far as the format holds them.
std::vector<std::vector<EncodedFile>> space_files(const char* path) {
    const SpaceFormat& format = *find_format(path)->space;
    std::vector<std::vector<EncodedFile>> sets;
    if (format.encode != nullptr) {
        for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
            sets.push_back(format.encode(random_space_tile(3), {.surfaces = form}, path));
            if (format.surfaces != FormatSurfaces::kChosen) break;
        }
        sets.push_back(format.encode(random_space_tile(5, space::kLongestShortEdge), {}, path));
    }
    if (format.encode_tetrahedra != nullptr && format.holds_only_grains) {
        sets.push_back(format.encode_tetrahedra(grain_tetrahedra(2), {}, path));
    } else if (format.encode_tetrahedra != nullptr) {
        const space::Lattice cube = space::Lattice::box(1, 1, 1);
        const space::Sites sites(cube, uniform_points(cube, 3, 1));
        sets.push_back(
            format.encode_tetrahedra(tetrahedral_mesh(space::periodic_delaunay(sites)), {}, path));
    }
    return sets;
}

void read_space_tile(const char* path, const std::string& bytes) {
    const std::vector<std::string> paths = find_format(path)->space->paths(path);
    const std::vector<std::string> parts =
        paths.size() == 1 ? std::vector{bytes} : split_files(bytes);
    std::vector<EncodedFile> files;
    for (std::size_t k = 0; k < std::min(parts.size(), paths.size()); ++k) {
        files.push_back({paths[k], parts[k]});
    }
    const std::optional<SpaceFileKind> kind = space_file_kind(files);
    if (kind == SpaceFileKind::kTetrahedra) prove_tetrahedral_files(files);
    if (kind == SpaceFileKind::kPolyhedra) prove_space_files(files);
    if (kind == SpaceFileKind::kBoundary) prove_boundary_files(files);
    if (kind == SpaceFileKind::kClosedSurfaces) prove_stl(files.front());
    if (kind != SpaceFileKind::kTriangles) return;
    prove_glb_surfaces(files.front(), decode_glb_surfaces(files.front()));
}

FuzzTarget space_target(std::string_view name, const char* path) {
    return {name, [=](const std::string& bytes) { read_space_tile(path, bytes); },
            [=] {
                std::vector<std::string> seeds;
                for (const std::vector<EncodedFile>& set : space_files(path)) {
                    std::vector<std::string> files;
                    for (const EncodedFile& file : set) files.push_back(file.bytes);
                    seeds.push_back(files.size() == 1 ? files.front() : join_files(files));
                }
                return seeds;
            }};
}

void read_grid(const std::string& bytes) {
    prove_mpas_grid(std::get<GridReader*>(find_format("t.nc")->read)({{"t.nc", bytes}}));
}

std::vector<std::string> grid_seeds() {
    const plane::PeriodicMesh cells = hexagonal_cells(3, 4);
    const Torus torus{cells, plane::Vec2::Zero(), {}};
    TorusWriter* write = std::get<TorusWriter*>(find_format("t.nc")->write);
    return {write(torus, {}, "t.nc").front().bytes};
}

void read_voxels(const std::string& bytes) {
    const std::vector<EncodedFile> files = {{"t.vti", bytes}};
    prove_voxel_file(files, decode_vti(files));
}

std::vector<std::string> voxel_seeds() {
    const plane::Lattice lattice = plane::Lattice::rectangle(2, 1);
    const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, uniform_points(lattice, 5, 1)));
    plane::VoxelCells cells{.lattice = lattice, .sites = plane::Points(2, 5)};
    for (SiteId s = 0; s < 5; ++s) cells.sites.col(s) = delaunay.sites().position(s);
    const plane::VoxelImage image =
        voxel_image(delaunay, {}, voxel_grid(lattice, {0, 0}, {6, 4}), 1);
    const space::Lattice box = space::Lattice::box(2, 1, 1);
    const auto tetrahedra = space::periodic_delaunay(space::Sites(box, uniform_points(box, 5, 1)));
    const space::VoxelImage of_space =
        voxel_image(tetrahedra, {}, voxel_grid(box, {0, 0, 0}, {6, 4, 3}), 1);
    const space::VoxelCells in_space{.lattice = box, .sites = tetrahedra.sites.positions()};
    return {encode_vti(image, cells, {}, {}, "t.vti").front().bytes,
            encode_space_vti(of_space, in_space, {}, {}, "t.vti").front().bytes};
}

void read_materials(const std::string& bytes) { decode_damask_material("t.material.yaml", bytes); }

std::vector<std::string> material_seeds() {
    return {encode_damask_material(2, {}),
            encode_damask_material(2, {.phase_names = {"a", "b"},
                                       .site_phase = {1, 0},
                                       .site_orientation = {{10, 20, 30}, {40, 50, 60}}})};
}

void read_seam(const std::string& bytes) { decode_seam("t.seam.json", bytes); }

std::vector<std::string> seam_seeds() {
    std::vector<std::string> seeds;
    for (const plane::Tile& tile : example_tiles()) seeds.push_back(encode_seam(tile));
    return seeds;
}

void read_site_text(const std::string& bytes) {
    const SiteFile file = parse_sites<2>({.path = "sites.txt"}, bytes);
    if (file.points.cols() > kMostMeshedSites) return;
    // As every run of the command, it refuses sites that nearly coincide.
    plane::CvtOptions options;
    options.run.max_iterations = 0;
    const plane::CvtResult result = compute_cvt(oblique(), file.points, options);
    for (const plane::Outline outline : {plane::Outline::kWhole, plane::Outline::kBox}) {
        verify_generated_tile(build_tile(result.delaunay, {.outline = outline}).tile);
    }
}

void read_areas_text(const std::string& bytes) {
    const AreaFile file = parse_areas({.path = "areas.txt"}, bytes);
    require_areas(file, static_cast<int>(file.areas.size()));
}

std::vector<std::string> area_seeds() {
    return {"1\n2.5 # comment\n\n3e-1\r\n", "diameter\n1\n\t2\n",
            "\xEF\xBB\xBF"
            "Feature_ID;\"ECD (\xC2\xB5m)\"\r\n1;0,25\r\n2;1,5;\r\n",
            "sep=,\n,Area,Mean\n1,20,3\n2,40,5\n", "2\nid\tEquivalent Diameter\n1\t2\n2\t3\n"};
}

void read_inclusion_text(const std::string& bytes) {
    const InclusionFile file = parse_inclusions("inclusions.txt", bytes);
    const plane::Lattice lattice({1, 0}, {0.3, 0.9});
    plane::InclusionSet(lattice, plane::without_listed_images(lattice, {}, file.inclusions));
}

std::vector<std::string> inclusion_seeds() {
    return {
        "# shapes\ncircle a 0.1 0.9 0.2\r\nellipse b 0.5 0.4 0.2 1e-1 30\n"
        "polygon a 0.7,0.1 0.8 0.1 0.75 0.2\n",
        "polygon c 0.7 0.1 0.8 0.1 0.75 0.2 0.72 0.15\ncircle d 0 0 .1\n"};
}

void read_angles(const std::string& bytes) { parse_orientations({.path = "angles.txt"}, bytes); }

std::vector<std::string> angle_seeds() {
    return {"# angles\n10 20 30\r\n-0.5 90\t360\n", "10, 20, 30\n-0.5,90,\t360\n",
            "id,Euler1 (rad),Euler2 (rad),Euler3 (rad)\n1,0.5,1,2\n",
            "phi1;Phi;phi2\n10,5;20,25;30\n"};
}

std::vector<std::string> site_seeds() {
    return {encode_sites(uniform_points(oblique(), 5, 1)),
            "# a grid\r\n0 0\r\n.5 0\r\n0 +5e-1 # comment\r\n\t.5,.5",
            "\xEF\xBB\xBF-1e3 1e-300\n0.25 0.125\n\n",
            "site,x,y,neighbours\n0,0.1,0.2,1 2\n1,0.5,0.25,0 2\n",
            "x (um)\ty (um)\tphase\n0,5\t0,25\tA\n0,125\t0,75\tB\n"};
}

void read_csv(const std::string& bytes) {
    const MergedStudy merged = merge_runs({{"runs.csv", decode_csv("runs.csv", bytes)}});
    conclude_study(merged.study, merged.runs);
}

std::vector<std::string> csv_seeds() {
    std::vector<std::string> seeds;
    for (const StudyRecipe& recipe : study_recipes()) {
        if (recipe.timed) continue;
        const Study study{.name = recipe.name, .sites = {3}, .runs = 1};
        const std::optional<StudyTable> runs = run_study(study, {}, 1, {});
        seeds.push_back(encode_csv(*runs));
    }
    return seeds;
}

void read_formula(const std::string& bytes) {
    const plane::Density density = expression_density(bytes);
    densities_at(density, oblique(), uniform_points(oblique(), 3, 2));
}

std::vector<std::string> formula_seeds() {
    return {"1 + 99 * exp(-((v - 0.5) / 0.08)^2)",
            "2 + sin(2 * pi * u) * cos(2 * _pi * v) + abs(x) + max(y, 1e-3, 2)",
            "u < 0.5 && v >= .25 || x != y ? 4 : 1",
            "sqrt(x^2 + y^2) + _e + rint(7.5) - -avg(1, 2) / (3 + log2(8)) + atan2(1, 2)"};
}

/// Returns the bytes with the right checksum in each chunk, so that damage reaches the decoder.
std::string with_checksums(std::string bytes) {
    for (std::size_t at = png_signature().size(); at + 12 <= bytes.size();) {
        std::uint32_t length = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            length = length << 8 | static_cast<unsigned char>(bytes[at + k]);
        }
        if (length > bytes.size() - at - 12) break;
        const std::string type = bytes.substr(at + 4, 4);
        const std::string chunk = png_chunk(type, bytes.substr(at + 8, length));
        bytes.replace(at, chunk.size(), chunk);
        at += chunk.size();
    }
    return bytes;
}

void read_png(const std::string& bytes) {
    const GreyImage image = decode_png("t.png", with_checksums(bytes));
    if (image.width * image.height > kMostSampledPixels) return;
    densities_at(image_density(image, {}), oblique(), uniform_points(oblique(), 9, 2));
}

std::vector<std::string> png_seeds() {
    const std::string palette = png_chunk("PLTE", std::string("\0\0\0\xff\0\0\0\xff\0", 9));
    const std::string clear = png_chunk("tRNS", std::string("\x40\xff", 2));
    return {png_bytes({2, 2, 8, 0}, {"\x10\x20", "\x30\x40"}),
            png_bytes({2, 1, 16, 2}, {"abcdefghijkl"}),
            png_bytes({4, 2, 2, 3}, {"\x18", "\x24"}, palette + clear),
            png_bytes({1, 1, 8, 6}, {"\x10\x20\x30\x40"}), png_bytes({8, 1, 1, 0}, {"\x5a"})};
}

FuzzTarget format_target(const Format& format) {
    const std::string_view name = format.extension.substr(1);
    if (format.reads_grid()) return {name, read_grid, grid_seeds};
    if (format.reads_voxels()) return {name, read_voxels, voxel_seeds};
    return {name, [&](const std::string& bytes) { read_tile(format, bytes); },
            [&] { return tile_seeds(format); }};
}

std::vector<FuzzTarget> make_targets() {
    std::vector<FuzzTarget> targets;
    for (const Format& format : formats()) {
        if (format.is_readable() && !format.is_only_in_space())
            targets.push_back(format_target(format));
    }
    targets.push_back(space_target("space_vtu", "t.vtu"));
    targets.push_back(space_target("space_foam", "t.foam"));
    targets.push_back(space_target("space_msh", "t.msh"));
    targets.push_back(space_target("space_obj", "t.obj"));
    targets.push_back(space_target("space_ply", "t.ply"));
    targets.push_back(space_target("space_glb", "t.glb"));
    targets.push_back(space_target("space_om", "t.om"));
    targets.push_back(space_target("space_stl", "t.stl"));
    targets.push_back({"seam", read_seam, seam_seeds});
    targets.push_back({"material", read_materials, material_seeds});
    targets.push_back({"areas", read_areas_text, area_seeds});
    targets.push_back({"angles", read_angles, angle_seeds});
    targets.push_back({"inclusions", read_inclusion_text, inclusion_seeds});
    targets.push_back({"txt", read_site_text, site_seeds});
    targets.push_back({"csv", read_csv, csv_seeds});
    targets.push_back({"png", read_png, png_seeds});
    targets.push_back({"formula", read_formula, formula_seeds});
    return targets;
}

bool is_printable_line(std::string_view text) {
    return !text.empty() && std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    });
}

}  // namespace

const std::vector<FuzzTarget>& fuzz_targets() {
    static const std::vector<FuzzTarget> targets = make_targets();
    return targets;
}

const FuzzTarget* find_fuzz_target(std::string_view name) {
    const std::vector<FuzzTarget>& targets = fuzz_targets();
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [&](const FuzzTarget& row) { return row.name == name; });
    return found == targets.end() ? nullptr : &*found;
}

std::string run_fuzz_input(const FuzzTarget& target, const std::string& bytes) {
    try {
        target.read(bytes);
        return "";
    } catch (const InvalidInput& refusal) {
        if (is_printable_line(refusal.what())) return "";
        return std::string("a refusal is not one printable line: ") + refusal.what();
    } catch (const LimitExceeded& refusal) {
        if (is_printable_line(refusal.what())) return "";
        return std::string("a refusal is not one printable line: ") + refusal.what();
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::exception& error) {
        return std::string("an exception that is not a refusal: ") + error.what();
    }
}

std::string join_files(const std::vector<std::string>& files) {
    std::string bytes;
    for (const std::string& file : files) {
        if (&file != files.data()) bytes += kNextFile;
        bytes += file;
    }
    return bytes;
}

std::vector<std::string> split_files(std::string_view bytes) {
    std::vector<std::string> files(1);
    for (const char c : bytes) {
        if (c == kNextFile) {
            files.emplace_back();
        } else {
            files.back() += c;
        }
    }
    return files;
}

}  // namespace pcvt::testing
