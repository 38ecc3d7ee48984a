#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/box/box_sides.hpp"
#include "mesher/space/grains/grains.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/grain_cases.hpp"

namespace pcvt::space {
namespace {

using testing::case_count;
using testing::GrainCase;

/// Shorter edges, a part of the spacing, are removed where cells with them are refused.
constexpr double kRemedy = 1e-3;

double volume_of(const TetrahedralMesh& mesh, int t) {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    return volume6(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) / 6;
}

/// The tetrahedra conform, are positive, and fill each cell.
/// @param bent  how far faces of the cells are from plane, a part of h.
void expect_filled(const Grains& grains, const CellComplex& complex, double bent) {
    const TetrahedralMesh& mesh = grains.mesh.tetrahedra;
    const TetrahedralProof proof = prove_tetrahedra(mesh);
    EXPECT_EQ(proof.n_sites - proof.n_edges + proof.n_triangles - mesh.n_tetrahedra(), 0);
    std::vector<double> volumes(static_cast<std::size_t>(complex.n_cells), 0);
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        const double part = volume_of(mesh, t);
        EXPECT_GT(part, 0);
        volumes[mesh.cell[t]] += part;
    }
    const std::vector<CellBody> bodies = cell_bodies(complex);
    for (int c = 0; c < complex.n_cells; ++c) {
        volumes[complex.site_of(c)] -= bodies[c].volume;
    }
    const double whole =
        complex.reduced.volume() / (1 + *std::max_element(mesh.cell.begin(), mesh.cell.end()));
    for (const double left : volumes) EXPECT_NEAR(left / whole, 0, 1e-9 + 10 * bent);
}

/// Law (2) of MidsideNodes, and the sides of tetrahedra of order 2: a node in the middle of an edge
/// is its representative plus a translation.
void expect_middles(const TetrahedralMesh& mesh) {
    const MidsideNodes middles = midside_nodes(mesh);
    const int n = mesh.n_points();
    for (std::size_t k = 0; k < middles.points.size(); ++k) {
        const Vec3 moved = middles.points[middles.orbit[k] - n];
        EXPECT_EQ(middles.points[k], moved + mesh.lattice.translation(middles.offset[k]));
    }
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        for (std::size_t k = 0; k < kEdgeCorners.size(); ++k) {
            const auto& [i, j] = kEdgeCorners[k];
            const Vec3 middle =
                (mesh.points[mesh.tetrahedra[t][i]] + mesh.points[mesh.tetrahedra[t][j]]) / 2;
            EXPECT_LT((middles.points[middles.of_tetrahedron[t][k] - n] - middle).norm(), 1e-12);
        }
    }
}

/// The corner of the box: 0, a vertex, a site, or anywhere. Outline 0 is that of whole cells.
Vec3 origin_of(const GrainCase& c, int outline) {
    if (outline == 2) return c.complex.vertices.front();
    if (outline == 3) return c.complex.sites.front();
    if (outline == 4) return {0.1234, 0.0077, 0.0031};
    return Vec3::Zero();
}

struct Campaign {
    int n_cells = 0;
    int n_cases = 0;
    int n_remedied = 0;
    int n_refused = 0;
    DihedralRange away = {};
    Workers workers = Workers(2);

    void fill(const GrainCase& c, const CellComplex& whole, double snapped, int outline,
              const std::string& name) {
        const Vec3 origin = origin_of(c, outline);
        const CellComplex cells =
            outline == 0 ? whole : cells_in_box(c.sites, whole, origin, snapped);
        Grains grains = mesh_grains(
            c.sites, cells, {.size = c.sites.spacing() / 1.5, .n_rounds = 1}, workers, origin);
        if (outline > 0) put_on_sides(origin, grains.mesh.tetrahedra);
        expect_filled(grains, cells, outline > 0 ? snapped : 0);
        expect_middles(grains.mesh.tetrahedra);
        std::printf("%s: %d cells, %d tetrahedra, %.2f degrees\n", name.c_str(), cells.n_cells,
                    grains.mesh.tetrahedra.n_tetrahedra(), grains.angles.smallest);
        away.add(grains.angles);
        n_cells += cells.n_cells;
        ++n_cases;
    }

    /// Only boxes through vertices that fall apart into edges of 1e-5 of the spacing and less may
    /// be refused, and without these edges, which the refusal names, they must be filled. The
    /// campaign goes on past cells that are not filled, so that it lists all of them.
    void run(const GrainCase& c, int outline, const std::string& name) {
        SCOPED_TRACE(name);
        try {
            fill(c, c.complex, kSnappedVertices, outline, name);
        } catch (const LimitExceeded& limit) {
            EXPECT_TRUE(outline > 0 && name.starts_with("shifted")) << limit.what();
            std::printf("%s: refused, %s\n", name.c_str(), limit.what());
            ++n_remedied;
            run_without_short_edges(c, outline, name + " without short edges");
        }
    }

    void run_without_short_edges(const GrainCase& c, int outline, const std::string& name) {
        const CellComplex remedied =
            without_short_edges(c.complex, kRemedy, ShrinkRule::kWideCorners);
        try {
            fill(c, remedied, kSnappedVertices, outline, name);
        } catch (const LimitExceeded& limit) {
            ADD_FAILURE() << limit.what();
            std::printf("%s: refused, %s\n", name.c_str(), limit.what());
            ++n_refused;
        }
    }
};

/// Cells of every kind are filled: lattices with planes through their faces, lattices whose sites
/// moved by 1e-6 of their spacing, clusters, oblique lattices, plates, rods and power cells; whole,
/// and cut by boxes through vertices, sites and faces. Tetrahedra of both orders.
/// PCVT_GRAIN_CELLS: the number of cells in all; PCVT_GRAIN_SEED: the first seed.
TEST(GrainCampaign, EveryKindOfCellIsFilled) {
    const int n_cells = case_count("PCVT_GRAIN_CELLS", 0);
    const bool is_full = n_cells > 0;
    Campaign campaign;
    for (int seed = case_count("PCVT_GRAIN_SEED", 1);
         campaign.n_cases == 0 || campaign.n_cells < n_cells; ++seed) {
        int outline = seed;
        for (const std::string& kind : testing::grain_kinds()) {
            // Flat cells, clusters and cells with very short edges take seconds.
            if (!is_full && kind == "shifted") break;
            const GrainCase c =
                testing::grain_case(kind, is_full ? 20 : 2, static_cast<std::uint64_t>(seed));
            outline = (outline + 1) % 5;
            campaign.run(
                c, outline,
                kind + " seed " + std::to_string(seed) + " outline " + std::to_string(outline));
        }
    }
    RecordProperty("cells", campaign.n_cells);
    RecordProperty("cases", campaign.n_cases);
    RecordProperty("remedied", campaign.n_remedied);
    RecordProperty("smallest_angle_away_from_features", std::to_string(campaign.away.smallest));
    if (is_full) {
        std::printf("%d cells, %d cases, %d of them without short edges, %.2f degrees\n",
                    campaign.n_cells, campaign.n_cases, campaign.n_remedied,
                    campaign.away.smallest);
    }
}

/// A box through a vertex cuts narrow strips off faces that snapped vertices bend, and a thin piece
/// beside one is seen from no point until the strip is smooth.
TEST(Grains, PiecesBesideBentStripsAreFilledSlow) {
    const GrainCase c = testing::grain_case("cvt", 20, 34);
    Campaign campaign;
    EXPECT_NO_THROW(campaign.fill(c, c.complex, kSnappedVertices, 2, "cvt seed 34 outline 2"));
}

/// The smallest angle away from named features, of some seeds. PCVT_GRAIN_SITES: the number of
/// cells, with 4 seeds of centroidal cells, 14 of random ones and 8 power diagrams.
TEST(GrainQuality, AnglesAwayFromSharpFeaturesAreWide) {
    const int n = case_count("PCVT_GRAIN_SITES", 6);
    const bool is_full = n > 6;
    const auto expect_wide = [&](const std::string& kind, int n_seeds, double least) {
        Workers workers(2);
        for (int seed = 1; seed <= (is_full ? n_seeds : 1); ++seed) {
            SCOPED_TRACE(kind + " seed " + std::to_string(seed));
            const GrainCase c = testing::grain_case(kind, n, static_cast<std::uint64_t>(seed));
            const Grains grains = mesh_grains(
                c.sites, c.complex, {.size = c.sites.spacing() / (is_full ? 3 : 2)}, workers);
            EXPECT_GE(grains.angles.smallest, least);
            for (const SharpFeature& feature : grains.sharp_features) {
                if (feature.kind == SharpFeature::Kind::kFlatCell) continue;
                EXPECT_TRUE(feature.angle < kSharpAngle || feature.angle > 180 - kSharpAngle);
            }
        }
    };
    expect_wide("cvt", 4, 18);
    expect_wide("random", 14, 10);
    expect_wide("power", 8, 10);
}

}  // namespace
}  // namespace pcvt::space
