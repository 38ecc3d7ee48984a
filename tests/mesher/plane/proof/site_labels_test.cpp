#include "mesher/plane/proof/site_labels.hpp"

#include <gmock/gmock.h>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/plane/tile/site_positions.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;
using testing::kOblique;

std::vector<TileOptions> all_options() {
    std::vector<TileOptions> all;
    for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
        for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
            if (kind == MeshKind::kDelaunay && outline == Outline::kBox) continue;
            const auto add = [&]() -> TileOptions& {
                TileOptions& options = all.emplace_back();
                options.kind = kind;
                options.outline = outline;
                return options;
            };
            add();
            TileOptions& repeated = add();
            repeated.repeat.columns = 3;
            repeated.repeat.rows = 2;
            if (kind != MeshKind::kDelaunay) add().short_edges = 0.3;
        }
    }
    return all;
}

Tile tile_of(const Lattice& lattice, int n, const TileOptions& options) {
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 5)));
    return build_tile(delaunay, options).tile;
}

/// The complaint of prove_sites(); empty if it has none.
std::string complaint(const Tile& tile) {
    try {
        prove_sites(tile, prove_tile(tile, Precision::kDouble));
        return "";
    } catch (const NotATile& error) {
        return error.what();
    }
}

std::vector<SiteId>& sites_of(Tile& tile) {
    return faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
}

TEST(SiteLabels, TilesOfRandomSitesHaveTheirSites) {
    for (const Lattice& lattice :
         {kOblique, Lattice::rectangle(1, 30), Lattice({1e-3, 0}, {3.3e-3, 1e-3})}) {
        for (const TileOptions& options : all_options()) {
            for (const int n : {1, 2, 3, 9, 200}) {
                EXPECT_EQ(complaint(tile_of(lattice, n, options)), "")
                    << n << ' ' << int(options.kind) << ' ' << int(options.outline) << ' '
                    << options.repeat.columns << ' ' << options.short_edges;
            }
        }
    }
}

TEST(SiteLabels, AFileWithPositionsProvesTheSame) {
    for (const TileOptions& options : all_options()) {
        Tile tile = tile_of(kOblique, 30, options);
        tile.site_positions = site_positions(tile);
        tile.site_points.clear();
        tile.grain_site_points.clear();
        EXPECT_EQ(complaint(tile), "");
    }
}

TEST(SiteLabels, NoIdMayDiffer) {
    for (const TileOptions& options : all_options()) {
        const Tile tile = tile_of(kOblique, 12, options);
        const auto n_ids = static_cast<int>(tile.sites().size());
        for (int k = 0; k < n_ids; k += 1 + n_ids / 60) {
            for (const int other : {-1, 3, 11, 12, 1 << 30}) {
                Tile changed = tile;
                if (sites_of(changed)[k] == other) continue;
                sites_of(changed)[k] = other;
                changed.site_positions = site_positions(tile);
                EXPECT_THAT(complaint(changed), HasSubstr("law of the sites")) << k << ' ' << other;
            }
        }
    }
}

TEST(SiteLabels, EveryIdIsThere) {
    for (const TileOptions& options : all_options()) {
        const Tile tile = tile_of(kOblique, 12, options);
        for (const int other : {-1, 3, 12, 1 << 30}) {
            Tile changed = tile;
            changed.site_positions = site_positions(tile);
            for (SiteId& site : sites_of(changed)) site = site == 5 ? other : site;
            EXPECT_THAT(complaint(changed), HasSubstr("law of the sites")) << other;
        }
    }
}

TEST(SiteLabels, TwoExchangedSitesAreFound) {
    for (const TileOptions& options : all_options()) {
        Tile tile = tile_of(kOblique, 12, options);
        tile.site_positions = site_positions(tile);
        for (SiteId& site : sites_of(tile)) site = site == 4 ? 7 : site == 7 ? 4 : site;
        EXPECT_THAT(complaint(tile), HasSubstr("law of the sites")) << int(options.kind);
    }
}

TEST(SiteLabels, NoSiteMayMove) {
    for (const TileOptions& options : all_options()) {
        const Tile tile = tile_of(kOblique, 12, options);
        for (std::size_t s = 0; s < 12; ++s) {
            for (const Vec2& step : {Vec2(0.1, 0), Vec2(0, -0.1), kOblique.b(), Vec2(7, 0)}) {
                Tile changed = tile;
                changed.site_positions = site_positions(tile);
                changed.site_positions[s] += step;
                // Another image of a cell that the box cuts is in the tile, too.
                if (options.outline == Outline::kBox && step == kOblique.b()) continue;
                EXPECT_THAT(complaint(changed), HasSubstr("law of the sites")) << s;
            }
        }
    }
}

TEST(SiteLabels, ASmallStepOfASiteIsFoundByItsCorners) {
    for (const TileOptions& options : all_options()) {
        const Tile tile = tile_of(kOblique, 12, options);
        Tile changed = tile;
        changed.site_positions = site_positions(tile);
        changed.site_positions[5].x() += 1e-5;
        EXPECT_THAT(complaint(changed), HasSubstr("law of the sites"));
    }
}

TEST(SiteLabels, WithoutPositionsEachIdOccursAndOrbitsAgree) {
    for (Tile tile :
         {testing::grid_tile(kOblique, 4, 3), testing::triangle_grid_tile(kOblique, 4, 3)}) {
        ASSERT_TRUE(site_positions(tile).empty());
        EXPECT_EQ(complaint(tile), "");
        Tile lacking = tile;
        for (SiteId& site : sites_of(lacking)) site = site == 5 ? 6 : site;
        EXPECT_THAT(complaint(lacking), HasSubstr("law of the sites"));
        sites_of(tile)[0] = -1;
        EXPECT_THAT(complaint(tile), HasSubstr("names site -1"));
    }
    Tile triangles = testing::triangle_grid_tile(kOblique, 4, 3);
    const VertexPair& pair = triangles.vertex_pairs.front();
    std::swap(triangles.vertex_site[pair.w], triangles.vertex_site[pair.w + 1]);
    EXPECT_THAT(complaint(triangles), HasSubstr("its image"));
}

TEST(SiteLabels, HugeNumbersOfPeriodsAndDistantSitesAreRefused) {
    Tile tile = tile_of(kOblique, 9, {});
    tile.site_positions = site_positions(tile);
    tile.columns = tile.rows = 10000;
    EXPECT_THAT(complaint(tile), HasSubstr("fewer faces than images"));
    tile.columns = tile.rows = 1;
    tile.site_positions[3] = Vec2(1e300, 0);
    EXPECT_THAT(complaint(tile), HasSubstr("too many periods away"));
}

// Where eight cells in mirror symmetry meet, the mean of their Voronoi vertices lies at the vertex,
// however far these are from it.
TEST(SiteLabels, GrainsInABoxWithWallsBelongToTheirCells) {
    const Tile tile = testing::walled_tile(Walls::kXY, WallCells::kWhole, 7,
                                           {.kind = MeshKind::kGrains, .grain_per_edge = 1});
    EXPECT_NO_THROW(prove_sites(tile, prove_tile(tile, Precision::kDouble)));
    for (int f = 0; f < tile.n_faces(); ++f) {
        for (SiteId other = 0; other < 7; ++other) {
            if (other == tile.face_site[f]) continue;
            Tile wrong = tile;
            wrong.face_site[f] = other;
            EXPECT_THROW(prove_sites(wrong, prove_tile(wrong, Precision::kDouble)), NotATile)
                << "face " << f << " of site " << tile.face_site[f] << " as of " << other;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
