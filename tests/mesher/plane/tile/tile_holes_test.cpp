#include "mesher/plane/tile/tile_holes.hpp"

#include <gmock/gmock.h>

#include <numeric>
#include <random>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/proof/site_labels.hpp"
#include "mesher/plane/tile/openmesh_tile.hpp"
#include "mesher/plane/tile/tile_equality.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/holed_tiles.hpp"
#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

double area_of_faces(const Tile& tile) {
    double area = 0;
    for (int f = 0; f < tile.n_faces(); ++f) {
        Polygon polygon;
        for (const int v : tile.faces[f]) polygon.push_back(tile.points[v]);
        area += polygon_area(polygon);
    }
    return area;
}

double length_of_holes(const Tile& tile) {
    double length = 0;
    for (const auto& [wall, v, w] : tile.wall_edges) {
        if (wall.is_hole()) length += (tile.points[w] - tile.points[v]).norm();
    }
    return length;
}

/// A random tessellation with inclusions, and the tags of its holes.
struct Case {
    InterfaceCvt cvt;
    std::vector<int> tags;
};

Case random_case(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const Lattice lattice({1, 0}, {0.8 * unit(random), 0.6 + unit(random)});
    const testing::RandomInclusions wanted{.n_shapes = 1 + int(8 * unit(random)),
                                           .n_across = int(4 * unit(random)),
                                           .fraction = 0.1 + 0.4 * unit(random)};
    const std::vector<Inclusion> shapes = testing::random_inclusions(lattice, wanted, random);
    const InclusionSet set(lattice, shapes);
    CvtOptions few_steps;
    few_steps.run.max_iterations = int(3 * unit(random));
    std::vector<int> tags{1};
    if (shapes.size() > 1 && unit(random) < 0.7) tags.push_back(2);
    return {compute_interface_cvt(set, 900 + int(500 * unit(random)), random(), few_steps), tags};
}

/// The area and the length of the outlines of the inclusions that are holes.
std::pair<double, double> holes_in(const Case& made) {
    double area = 0;
    double length = 0;
    const InterfaceSites& interfaces = made.cvt.interfaces;
    std::vector<bool> is_hole(interfaces.polygons.size(), false);
    for (std::size_t s = 0; s < made.cvt.tag.size(); ++s) {
        const bool found =
            std::find(made.tags.begin(), made.tags.end(), made.cvt.tag[s]) != made.tags.end();
        if (found) is_hole[made.cvt.inclusion[s]] = true;
    }
    for (std::size_t k = 0; k < is_hole.size(); ++k) {
        if (is_hole[k]) area += polygon_area(interfaces.polygons[k]);
    }
    for (const Chord& chord : interfaces.chords) {
        if (is_hole[chord.inclusion]) length += (chord.to - chord.from).norm();
    }
    return {area, length};
}

// The edges of holes are the chords of the interfaces.
TEST(TileHoles, SlowRandomTilesAreProvedAndLackTheAreaOfTheirHoles) {
    std::mt19937_64 random(11);
    const auto draw = [&](int to) { return std::uniform_int_distribution<int>(0, to)(random); };
    for (int k = 0; k < testing::case_count("PCVT_HOLE_CASES", 30); ++k) {
        const Case made = random_case(random);
        const auto kind = draw(1) == 0 ? MeshKind::kVoronoi : MeshKind::kGrains;
        TileOptions options{.kind = kind,
                            .outline = draw(1) == 0 ? Outline::kWhole : Outline::kBox,
                            .short_edges = 0.1 * draw(1),
                            .repeat = {1 + draw(1), 1 + draw(1)},
                            .origin = {0.01 * draw(99), 0.01 * draw(99)},
                            .site_tags = made.cvt.tag};
        options.holes = testing::holes_of(made.cvt.tag, made.tags);
        SCOPED_TRACE("case " + std::to_string(k) + ": " + mesh_kind_row(kind).word +
                     (options.outline == Outline::kBox ? ", box" : ", whole"));
        const Tile tile = build_tile(made.cvt.cvt.delaunay, options).tile;
        const TileProof proof = verify_generated_tile(tile);
        EXPECT_EQ(proof.wall_edges, tile.wall_edges);
        EXPECT_EQ(tile.holes.size(), made.tags.size());
        const int copies = options.repeat.columns * options.repeat.rows;
        const auto [area, length] = holes_in(made);
        const double domain = made.cvt.cvt.delaunay.sites().lattice().area();
        EXPECT_NEAR(area_of_faces(tile) / copies, domain - area, 1e-12 * domain);
        EXPECT_NEAR(length_of_holes(tile) / copies, length, 1e-9);
    }
}

TEST(TileHoles, SitesThatStayAreNumberedFromZeroInTheirOrder) {
    const std::vector<int> tags{1, 0, 0, 2, 0, 1};
    const HoleSites holes = testing::holes_of(tags, {2, 1});
    EXPECT_EQ(holes.of_site, (std::vector<int>{1, -1, -1, 0, -1, 1}));
    EXPECT_EQ(holes.kept(), (std::vector<SiteId>{1, 2, 4}));
    const Tile tile = testing::holed_tile({});
    std::vector<SiteId> ids = tile.face_site;
    std::sort(ids.begin(), ids.end());
    std::vector<SiteId> wanted(ids.size());
    std::iota(wanted.begin(), wanted.end(), 0);
    EXPECT_EQ(ids, wanted);
}

// The mesh of the torus that views and tables read.
TEST(TileHoles, MeshesOfTheTorusKeepTheirNeighboursAcrossAllOtherEdges) {
    std::mt19937_64 random(12);
    for (int k = 0; k < testing::case_count("PCVT_HOLE_CASES", 5); ++k) {
        const Case made = random_case(random);
        const PeriodicMesh whole = cell_mesh(made.cvt.cvt.delaunay);
        const HoleSites holes = testing::holes_of(made.cvt.tag, made.tags);
        const PeriodicMesh mesh = with_holes(whole, holes);
        const std::vector<SiteId> kept = holes.kept();
        ASSERT_EQ(mesh.n_faces(), std::ssize(kept));
        int n_on_holes = 0;
        for (int c = 0; c < mesh.n_corners(); ++c) {
            const int across = mesh.opposite[c];
            n_on_holes += across < 0;
            if (across < 0) continue;
            EXPECT_EQ(mesh.opposite[across], c);
            EXPECT_NE(mesh.corner_face[across], mesh.corner_face[c]);
        }
        int n_chords = 0;
        for (int c = 0; c < whole.n_corners(); ++c) {
            const auto is_hole = [&](int corner) {
                return holes.of_site[whole.site[whole.corner_face[corner]]] >= 0;
            };
            n_chords += !is_hole(c) && is_hole(whole.opposite[c]);
        }
        EXPECT_EQ(n_on_holes, n_chords);
    }
}

// Law (3)
TEST(TileHoles, VerticesAndFacesKeepTheirOrderAndTheirPlaces) {
    Tile whole = testing::holed_tile({});
    const TileOptions options{};
    HoleSites none;
    EXPECT_TRUE(same_geometry(with_holes(whole, none), whole));
}

std::vector<Tile> holed_tiles() {
    std::vector<Tile> tiles;
    for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kGrains}) {
        for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
            tiles.push_back(testing::holed_tile({.kind = kind, .outline = outline}));
        }
    }
    tiles.push_back(testing::holed_tile({.kind = MeshKind::kDelaunay}));
    return tiles;
}

TEST(TileHoles, EachMeshAndOutlineIsProvedAndSurvivesOpenMesh) {
    for (const Tile& made : holed_tiles()) {
        const TileProof proof = verify_generated_tile(made);
        const Tile back = tile(openmesh_tile(made));
        EXPECT_EQ(back.holes, made.holes);
        EXPECT_EQ(back.wall_edges, made.wall_edges);
        EXPECT_TRUE(same_geometry(back, made));
        EXPECT_EQ(proof.n_boundary_edges, int(2 * made.edge_pairs.size() + made.wall_edges.size()));
    }
}

/// The violation of a tile that was changed; empty if there is none.
template <class Change>
std::string fault_after(Tile tile, const Change& change) {
    change(tile);
    try {
        const TileProof proof = prove_tile(tile, Precision::kDouble);
        compare_wall_edges(tile, proof);
        compare_edge_pairs(tile, proof);
        prove_sites(tile, proof);
        return "";
    } catch (const NotATile& fault) {
        return fault.what();
    }
}

TEST(TileHoles, TheProofFindsEveryWrongEdge) {
    for (const Tile& made : holed_tiles()) {
        EXPECT_EQ(fault_after(made, [](Tile&) {}), "");
        EXPECT_THAT(fault_after(made, [](Tile& tile) { tile.wall_edges.pop_back(); }),
                    HasSubstr("has no reversed partner by any lattice vector"));
        EXPECT_THAT(fault_after(made,
                                [](Tile& tile) {
                                    tile.wall_edges.clear();
                                    tile.holes.clear();
                                }),
                    HasSubstr("has no reversed partner by any lattice vector"));
        EXPECT_THAT(
            fault_after(made, [](Tile& tile) { tile.wall_edges.front().wall = WallId::hole(1); }),
            HasSubstr("has two names"));
        EXPECT_THAT(fault_after(made, [](Tile& tile) { tile.holes.emplace_back("more"); }),
                    HasSubstr("no edge lies at a hole more"));
        EXPECT_THAT(fault_after(made, [](Tile& tile) { tile.holes.pop_back(); }),
                    HasSubstr("lies at a hole without a name"));
        EXPECT_THAT(fault_after(made,
                                [](Tile& tile) {
                                    const EdgePair pair = tile.edge_pairs.front();
                                    tile.wall_edges.push_back({WallId::hole(1), pair.v0, pair.v1});
                                }),
                    HasSubstr("the boundary of no hole runs there"));
    }
}

/// Leaves face f out.
void remove_face(Tile& tile, int f) {
    Faces faces;
    for (int g = 0; g < tile.n_faces(); ++g) {
        if (g != f) faces.add(tile.faces[g]);
    }
    tile.faces = faces;
    tile.face_site.erase(tile.face_site.begin() + f);
}

TEST(TileHoles, AMissingFaceIsNoHole) {
    const Tile made = testing::holed_tile({});
    for (const int f : {0, 17, 60}) {
        EXPECT_NE(fault_after(made, [f](Tile& tile) { remove_face(tile, f); }), "");
    }
}

TEST(TileHoles, ListsOfNumbersGiveTheHolesBack) {
    const Tile made = testing::holed_tile({});
    const std::vector<double> numbers = holes_as_numbers(made);
    Tile back = made;
    back.holes.clear();
    back.wall_edges.clear();
    take_holes(numbers, back);
    EXPECT_EQ(back.holes, made.holes);
    EXPECT_EQ(back.wall_edges, made.wall_edges);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        std::vector<double> damaged = numbers;
        for (const double bad : {-1.0, 0.5, 1e9}) {
            damaged[k] = bad;
            back.holes.clear();
            EXPECT_THROW(take_holes(damaged, back), InvalidInput) << k;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
