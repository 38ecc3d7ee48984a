#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/output_error.hpp"
#include "io/graphics/stl_proof.hpp"
#include "mesher/base/law_violation.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/space_tiles.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile stl_of(const ClosedSurfaces& surfaces) { return encode_stl(surfaces, "t.stl").front(); }

ClosedSurfaces random_surfaces(SurfaceForm form = SurfaceForm::kCells) {
    return closed_surfaces(testing::random_space_tile(6).mesh, form);
}

/// The message of the proof of a file whose facets were changed.
template <class Change>
std::string fault_of(const Change& change) {
    StlFile stl = decode_stl(stl_of(random_surfaces()));
    change(stl);
    return testing::refusal_of([&] { prove_stl(encode_stl(stl, "t.stl").front()); });
}

/// Of the sides of faces by their three corners, in rising order, how often each occurs.
std::map<std::array<int, 3>, int> counts_of(const ClosedSurfaces& surfaces) {
    std::map<std::array<int, 3>, int> counts;
    for (std::array<int, 3> corners : surfaces.triangles) {
        std::sort(corners.begin(), corners.end());
        ++counts[corners];
    }
    return counts;
}

TEST(Stl, HoldsOneClosedSurfaceOfEachCell) {
    int n_held = 0;
    int n_tested = 0;
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        const ClosedSurfaces surfaces = closed_surfaces(tile.mesh, SurfaceForm::kCells);
        try {
            const EncodedFile file = stl_of(surfaces);
            const StlProof proof = prove_stl(file);
            EXPECT_EQ(proof.n_surfaces, tile.mesh.n_cells);
            EXPECT_NEAR(proof.volume, tile.mesh.lattice.volume(), proof.tolerance);
            EXPECT_TRUE(holds_surfaces(file, surfaces));
            EXPECT_NO_THROW(prove_own_space_files({file}, tile));
            ++n_held;
            n_tested += proof.repeats ? 1 : 0;
        } catch (const CoarsePrecision&) {
            // Cells far from 0, or with short edges.
        }
    }
    EXPECT_GT(n_held, 30);
    EXPECT_GT(n_tested, 25);
}

TEST(Stl, TrianglesOfFacesAreOneOnBothSidesAndAcrossTheSeam) {
    const SpaceTile tile = testing::random_space_tile(6);
    const ClosedSurfaces cells = closed_surfaces(tile.mesh, SurfaceForm::kCells);
    const ClosedSurfaces boundary = closed_surfaces(tile.mesh, SurfaceForm::kBoundary);
    const auto counts = counts_of(cells);
    std::size_t n_once = 0;
    for (const auto& [corners, count] : counts) {
        EXPECT_LE(count, 2);
        n_once += count == 1;
    }
    EXPECT_EQ(n_once, boundary.triangles.size());
    // The images of the corners of each triangle are those of exactly one other.
    std::map<std::vector<SiteId>, int> orbits;
    for (const std::array<int, 3>& corners : boundary.triangles) {
        std::vector<SiteId> orbit;
        for (const int v : corners) orbit.push_back(tile.mesh.point_orbit[v]);
        std::sort(orbit.begin(), orbit.end());
        ++orbits[orbit];
    }
    for (const auto& [orbit, count] : orbits) EXPECT_EQ(count % 2, 0);
}

TEST(Stl, BoundaryOfTheTileIsOneClosedSurface) {
    const ClosedSurfaces surfaces = random_surfaces(SurfaceForm::kBoundary);
    const StlProof proof = prove_stl(stl_of(surfaces));
    EXPECT_EQ(proof.n_surfaces, 1);
    EXPECT_NEAR(proof.volume, surfaces.lattice.volume(), proof.tolerance);
    EXPECT_EQ(stl_form(decode_stl(stl_of(surfaces))), SurfaceForm::kBoundary);
}

TEST(Stl, TetrahedraGiveTheSurfacesOfTheirCells) {
    const space::TetrahedralMesh mesh = testing::grain_tetrahedra(5);
    for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
        const ClosedSurfaces surfaces = closed_surfaces(mesh, form);
        const EncodedFile file = stl_of(surfaces);
        const StlProof proof = prove_stl(file);
        EXPECT_EQ(proof.n_surfaces, form == SurfaceForm::kCells ? 5 : 1);
        EXPECT_NEAR(proof.volume, mesh.lattice.volume(), proof.tolerance);
        EXPECT_NO_THROW(prove_own_tetrahedra({file}, mesh));
    }
    EXPECT_THROW(
        prove_own_tetrahedra(
            {stl_of(closed_surfaces(testing::grain_tetrahedra(4), SurfaceForm::kCells))}, mesh),
        InternalError);
}

TEST(Stl, FacetsAreOfSinglePrecisionInTheOrderOfBinaryFiles) {
    const ClosedSurfaces surfaces = random_surfaces();
    const EncodedFile file = stl_of(surfaces);
    EXPECT_EQ(file.bytes.size(), 84 + 50 * surfaces.triangles.size());
    EXPECT_FALSE(file.bytes.starts_with("solid"));
    const StlFile stl = decode_stl(file);
    ASSERT_TRUE(stl_lattice(stl));
    EXPECT_EQ(stl_lattice(stl)->periods(), surfaces.lattice.periods());
    const space::Vec3& point = surfaces.points[surfaces.triangles[7][1]];
    EXPECT_EQ(stl.facets[7].corners[1], Eigen::Vector3f(point.cast<float>()));
    EXPECT_NEAR(stl.facets[7].normal.norm(), 1, 1e-6);
}

TEST(Stl, ThatDoesNotCloseIsRefuted) {
    EXPECT_EQ(fault_of([](StlFile&) {}), "");
    EXPECT_THAT(fault_of([](StlFile& stl) { stl.facets.pop_back(); }),
                HasSubstr("the last surface does not close"));
    EXPECT_THAT(fault_of([](StlFile& stl) { stl.facets[3].corners[0].x() += 1; }),
                HasSubstr("does not close"));
    EXPECT_THAT(fault_of([](StlFile& stl) {
                    std::swap(stl.facets[3].corners[0], stl.facets[3].corners[1]);
                }),
                HasSubstr("does not close"));
    EXPECT_THAT(fault_of([](StlFile& stl) {
                    for (StlFacet& facet : stl.facets) {
                        std::swap(facet.corners[0], facet.corners[1]);
                    }
                }),
                HasSubstr("turned inside out"));
    EXPECT_THAT(fault_of([](StlFile& stl) { stl.facets[0].corners[2] = stl.facets[0].corners[1]; }),
                HasSubstr("triangle 1 has no area"));
}

TEST(Stl, FieldsOfPcvtAreProvedAndThoseOfOthersAreNot) {
    const auto turn_normal = [](StlFile& stl) { stl.facets[2].normal *= -1; };
    EXPECT_THAT(fault_of(turn_normal), HasSubstr("the normals or the attributes"));
    EXPECT_EQ(fault_of([&](StlFile& stl) {
                  turn_normal(stl);
                  stl.header = "exported by another program";
              }),
              "");
    // Other periods have another volume.
    EXPECT_THAT(
        fault_of([](StlFile& stl) { stl.header = "pcvt cells, periods 1 0 0 0 1 0 0 0 1"; }),
        HasSubstr("they sum to"));
}

TEST(Stl, StatedPeriodsMapTheBoundaryOntoItself) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const SpaceTile tile = testing::tile_of({"cube", cube, uniform_points(cube, 6, 3)});
    for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
        ClosedSurfaces surfaces = closed_surfaces(tile.mesh, form);
        EXPECT_TRUE(prove_stl(stl_of(surfaces)).repeats);
        // Sheared by translations of the same volume.
        for (const double shear : {1e-5, 0.5, 1.0}) {
            surfaces.lattice = space::Lattice({1, shear, 0}, {0, 1, 0}, {0, 0, 1});
            EXPECT_THAT(testing::refusal_of([&] { prove_stl(stl_of(surfaces)); }),
                        HasSubstr(shear < 1 ? "no partner by the periods" : ""));
        }
    }
}

TEST(Stl, DamagedFilesAreRefusedByName) {
    const EncodedFile file = stl_of(random_surfaces());
    EncodedFile damaged = file;
    damaged.bytes.pop_back();
    EXPECT_THAT(testing::refusal_of([&] { prove_stl(damaged); }),
                HasSubstr("t.stl: not a whole binary STL"));
    damaged.bytes = "solid cells\nendsolid\n";
    EXPECT_THAT(testing::refusal_of([&] { prove_stl(damaged); }), HasSubstr("an STL in ASCII"));
    damaged.bytes = file.bytes;
    damaged.bytes.replace(84 + 12, 4, "\xff\xff\xff\x7f");
    EXPECT_THAT(testing::refusal_of([&] { prove_stl(damaged); }), HasSubstr("not finite"));
    damaged.bytes = file.bytes;
    damaged.bytes[84 + 48] = 1;
    EXPECT_THAT(testing::refusal_of([&] { prove_stl(damaged); }), HasSubstr("attributes"));
}

TEST(Stl, SinglePrecisionThatMergesOrTurnsIsRefused) {
    const space::Vec3 apart(1e-9, 0, 0);
    ClosedSurfaces surfaces{.form = SurfaceForm::kCells, .lattice = space::Lattice::box(1, 1, 1)};
    surfaces.points = {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    surfaces.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    EXPECT_NO_THROW(stl_of(surfaces));
    for (space::Vec3& point : surfaces.points) point += space::Vec3(1e9, 0, 0);
    EXPECT_THROW(stl_of(surfaces), CoarsePrecision);
    // Rounding turns two flat sides by 90 degrees.
    surfaces.points = {{1, 0, 0}, {2, 0, 0}, {1.5, 4e-8, 1e-8}, {1.5, 0, 5e-8}};
    for (space::Vec3& point : surfaces.points) point += space::Vec3(0, 1, 1);
    EXPECT_THROW(stl_of(surfaces), CoarsePrecision);
    surfaces.points = {{1, 0, 0}, space::Vec3(1, 0, 0) + apart, {1, 1, 0}, {1, 0, 1}};
    EXPECT_THROW(stl_of(surfaces), CoarsePrecision);
}

}  // namespace
}  // namespace pcvt
