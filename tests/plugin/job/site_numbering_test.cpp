#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "io/run_files/site_reader.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/tile/site_positions.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/run_job.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using pcvt::testing::TemporaryFolder;

/// glTF holds positions as 32-bit floats.
constexpr double kSamePlace = 1e-6;
constexpr int kNumberedSites = 64;

/// One combination of the features that change, order or leave out sites.
struct Features {
    Walls walls = Walls::kNone;
    WallCells wall_cells = WallCells::kWhole;
    bool has_inclusions = false;
    bool has_hole = false;
    /// Sites of a file, in an order of their own, in place of drawn ones.
    bool are_given = false;
    bool has_materials = false;
    bool is_repeated = false;
    bool has_origin = false;
    plane::Outline outline = plane::Outline::kWhole;
    double short_edges = 0;

    bool is_walled(int axis) const { return has_walls_across(walls, axis); }
    /// Whether the job is one that pcvt accepts.
    bool fit_together() const {
        const bool is_free = !has_inclusions || (!are_given && !has_materials);
        const bool can_move = walls != Walls::kXY || (!is_repeated && !has_origin);
        return is_free && can_move && (has_inclusions || !has_hole) &&
               (walls != Walls::kNone || wall_cells == WallCells::kWhole);
    }
    std::string text() const {
        std::ostringstream words;
        words << "walls " << walls_row(walls).word << " " << wall_cells_row(wall_cells).word
              << ", inclusions " << has_inclusions << ", hole " << has_hole << ", given "
              << are_given << ", materials " << has_materials << ", repeated " << is_repeated
              << ", origin " << has_origin << ", box " << (outline == plane::Outline::kBox)
              << ", short edges " << short_edges;
        return words.str();
    }
};

/// Calls `visit` for every combination that pcvt accepts.
void for_all_features(const std::function<void(const Features&)>& visit) {
    for (const WallsRow& walls : kWalls) {
        for (unsigned bits = 0; bits < 1U << 9U; ++bits) {
            const auto bit = [bits](unsigned k) { return (bits >> k & 1U) != 0; };
            const Features features{
                .walls = walls.walls,
                .wall_cells = bit(0) ? WallCells::kHalf : WallCells::kWhole,
                .has_inclusions = bit(1),
                .has_hole = bit(2),
                .are_given = bit(3),
                .has_materials = bit(4),
                .is_repeated = bit(5),
                .has_origin = bit(6),
                .outline = bit(7) ? plane::Outline::kBox : plane::Outline::kWhole,
                .short_edges = bit(8) ? 0.1 : 0.0};
            if (features.fit_together()) visit(features);
        }
    }
}

/// Sites whose order is neither that of their columns nor of their rows.
plane::Points scattered_sites(const plane::Lattice& lattice) {
    plane::Points points(2, kNumberedSites);
    for (int s = 0; s < kNumberedSites; ++s) {
        const int cell = s * 37 % kNumberedSites;
        const double jitter = 0.05 * std::sin(12.9898 * s);
        points.col(s) = lattice.to_position(
            {(cell % 8 + 0.5 + jitter) / 8, (double(cell / 8) + 0.5 - jitter) / 8});
    }
    return points;
}

Job job_with(const Features& features) {
    Job job;
    job.in_plane().lattice = plane::Lattice::rectangle(1.25, 1);
    job.n_sites = kNumberedSites;
    job.seed = 5;
    job.run.max_iterations = 2;
    job.walls = features.walls;
    job.wall_cells = features.wall_cells;
    if (features.are_given) {
        job.in_plane().points = scattered_sites(job.in_plane().lattice);
        // The sites beside walls move onto them.
        if (features.wall_cells == WallCells::kWhole) job.run.max_iterations = 0;
    }
    if (features.has_inclusions) {
        job.inclusions =
            parse_inclusions("shapes", "circle a 0.42 0.5 0.16\ncircle b 0.88 0.48 0.12");
        if (features.has_hole) job.holes = {"a"};
    }
    if (features.has_materials) {
        job.materials.phases = parse_phases("soft:0.6,hard:0.4");
        job.materials.draws_orientations = true;
    }
    if (features.is_repeated) {
        job.tile.repeat.columns = features.is_walled(0) ? 1 : 2;
        job.tile.repeat.rows = features.is_walled(1) ? 1 : 2;
    }
    if (features.has_origin) {
        job.in_plane().origin = {features.is_walled(0) ? 0 : 0.3, features.is_walled(1) ? 0 : -7.7};
    }
    job.tile.outline = features.outline;
    job.tile.short_edges = features.short_edges;
    return job;
}

TileFile read_tile(const std::string& path) {
    const Format& format = *find_format(path);
    std::vector<EncodedFile> files;
    for (const std::string& part : format.paths(path)) {
        files.push_back({part, testing::bytes_of(part)});
    }
    return decode_tile(format, files, std::nullopt);
}

/// One row of a table of cells.
struct Row {
    plane::Vec2 site;
    double area;
    std::string phase;
};

std::vector<Row> read_table(const std::string& path) {
    std::vector<Row> rows;
    std::istringstream lines(testing::bytes_of(path));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#') || line.starts_with("site")) continue;
        std::vector<std::string> fields;
        std::istringstream words(line);
        for (std::string word; std::getline(words, word, ',');) fields.push_back(word);
        EXPECT_EQ(fields[0], std::to_string(rows.size()));
        rows.push_back(
            {{std::stod(fields[1]), std::stod(fields[2])}, std::stod(fields[4]), fields[8]});
    }
    return rows;
}

/// Requires the same sites in the same order, up to translations along the periods.
void expect_same_sites(const std::vector<plane::Vec2>& found,
                       const std::vector<plane::Vec2>& wanted, const Job& job,
                       const std::string& where) {
    ASSERT_EQ(found.size(), wanted.size()) << where;
    int n_wrong = 0;
    for (std::size_t s = 0; s < found.size(); ++s) {
        plane::Vec2 periods = job.in_plane().lattice.to_lattice(found[s] - wanted[s]);
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(job.walls, axis)) periods[axis] -= std::round(periods[axis]);
        }
        if (periods.norm() > kSamePlace) ++n_wrong;
    }
    EXPECT_EQ(n_wrong, 0) << where << ": sites of " << found.size() << " lie elsewhere";
}

std::vector<plane::Vec2> list_of(const plane::Points& points) {
    return {points.colwise().begin(), points.colwise().end()};
}

/// The area of the cell of each site in one period.
std::vector<double> areas_in(const plane::Tile& tile, std::size_t n_sites) {
    std::vector<double> areas(n_sites, 0);
    for (int f = 0; f < tile.n_faces(); ++f) {
        std::vector<plane::Vec2> corners;
        for (const int v : tile.faces[f]) corners.push_back(tile.points[v]);
        areas.at(tile.face_site[f]) += plane::polygon_area(corners) / (tile.columns * tile.rows);
    }
    return areas;
}

/// The part of the area of a grain that the removal of its shortest edges may change.
constexpr double kMovedCorners = 0.05;

/// Requires the areas and the phases of the rows to be those of the cells or grains of a file.
void expect_same_cells(const std::vector<Row>& rows, const TileFile& file, const Job& job) {
    const std::vector<double> areas = areas_in(file.tile, rows.size());
    for (std::size_t s = 0; s < rows.size(); ++s) {
        if (job.tile.short_edges == 0) {
            const double margin = job.meshes.empty() ? 1e-9 : kMovedCorners * areas[s];
            EXPECT_NEAR(rows[s].area, areas[s], margin) << "site " << s;
        }
        EXPECT_EQ(rows[s].phase, file.materials.phase_of(int(s))) << "site " << s;
    }
}

/// Writes a job in all formats that state its sites, and requires the same sites in all of them.
void expect_one_numbering(Job job, const std::vector<std::string>& extensions) {
    const TemporaryFolder folder;
    job.outputs = {folder / "t.txt", folder / "t.csv"};
    for (const std::string& extension : extensions)
        job.outputs.push_back(folder / ("t." + extension));
    run_job(job, [](const JobProgress&) { return true; });

    const std::vector<plane::Vec2> sites =
        list_of(read_sites<2>({.path = folder / "t.txt"}).points);
    const std::vector<Row> rows = read_table(folder / "t.csv");
    std::vector<plane::Vec2> of_rows;
    for (const Row& row : rows) of_rows.push_back(row.site);
    expect_same_sites(of_rows, sites, job, "table");
    if (job.in_plane().points.cols() > 0 && job.run.max_iterations == 0) {
        expect_same_sites(sites, list_of(job.in_plane().points), job, "input");
    }
    for (const std::string& extension : extensions) {
        const TileFile file = read_tile(folder / ("t." + extension));
        expect_same_sites(site_positions(file.tile), sites, job, extension);
        if (extension == "vtu") expect_same_cells(rows, file, job);
    }
}

/// Every fourth format, from the given one on, that states the sites of its tile and does not
/// consist of only triangles; and the one whose cells are compared.
std::vector<std::string> extensions_of_cells(const Job& job, int first) {
    std::vector<std::string> extensions;
    int turn = first;
    for (const Format& format : formats()) {
        if (!format.needs_tile() || !format.is_readable() || !format.holds_polygons) continue;
        const bool is_cut = format.is_folder && job.tile.outline == plane::Outline::kBox;
        const bool has_turn = ++turn % 4 == 0 || format.extension == ".vtu";
        if (has_turn && !is_cut) extensions.emplace_back(format.extension.substr(1));
    }
    return extensions;
}

TEST(SiteNumberingSlow, TableSitesAndCellsAreNumberedAlikeForAllFeatures) {
    int n_jobs = 0;
    for_all_features([&](const Features& features) {
        SCOPED_TRACE(features.text());
        const Job job = job_with(features);
        expect_one_numbering(job, extensions_of_cells(job, n_jobs));
        ++n_jobs;
    });
    EXPECT_GT(n_jobs, 500);
}

TEST(SiteNumberingSlow, SolversGetTheSameNumbersForAllFeatures) {
    for_all_features([&](const Features& features) {
        if (features.has_origin || features.short_edges > 0 || features.is_repeated) return;
        SCOPED_TRACE(features.text());
        Job job = job_with(features);
        job.meshes = {plane::MeshKind::kGrains};
        expect_one_numbering(job, {"msh", "inp", "vtu"});
    });
}

}  // namespace
}  // namespace pcvt
