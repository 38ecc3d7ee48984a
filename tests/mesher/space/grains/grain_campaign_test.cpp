#include <gtest/gtest.h>

#include <cstdio>
#include <optional>

#include "mesher/space/grains/grains.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/grain_cases.hpp"

namespace pcvt::space {
namespace {

using testing::case_count;
using testing::GrainCase;

double volume_of(const TetrahedralMesh& mesh, int t) {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    return volume6(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) / 6;
}

/// The tetrahedra conform, are positive, and fill each cell.
void expect_filled(const Grains& grains, const CellComplex& complex) {
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
    for (std::size_t c = 0; c < bodies.size(); ++c) {
        EXPECT_NEAR(volumes[c] / bodies[c].volume, 1, 1e-9);
    }
}

/// Cells of every kind are filled: lattices with planes through their faces, lattices whose sites
/// moved by 1e-6 of their spacing, clusters, oblique lattices, plates, rods and power cells.
/// PCVT_GRAIN_CELLS: the number of cells in all; PCVT_GRAIN_SEED: the first seed.
TEST(GrainCampaign, EveryKindOfCellIsFilled) {
    const int n_cells = case_count("PCVT_GRAIN_CELLS", 0);
    const bool is_full = n_cells > 0;
    const int n = is_full ? 30 : 3;
    int n_done = 0;
    int n_cases = 0;
    int n_refused = 0;
    DihedralRange away;
    Workers workers(2);
    for (int seed = case_count("PCVT_GRAIN_SEED", 1); n_cases == 0 || n_done < n_cells; ++seed) {
        for (const std::string& kind : testing::grain_kinds()) {
            // Flat cells, clusters and cells with very short edges take seconds.
            if (!is_full && kind == "shifted") break;
            SCOPED_TRACE(kind + " seed " + std::to_string(seed));
            const GrainCase c = testing::grain_case(kind, n, static_cast<std::uint64_t>(seed));
            std::optional<Grains> filled;
            try {
                filled = mesh_grains(c.sites, c.complex,
                                     {.size = c.sites.spacing() / 1.5, .n_rounds = 1}, workers);
            } catch (const NarrowFeature& limit) {
                // Only lattices whose sites moved by 1e-5 of their spacing and less.
                EXPECT_EQ(kind, "shifted") << limit.what();
                n_refused += c.complex.n_cells;
                std::printf("%s seed %d: refused\n", kind.c_str(), seed);
                continue;
            }
            const Grains& grains = *filled;
            expect_filled(grains, c.complex);
            if (is_full) {
                std::printf("%s seed %d: %d cells, %d tetrahedra, %.2f degrees\n", kind.c_str(),
                            seed, c.complex.n_cells, grains.mesh.tetrahedra.n_tetrahedra(),
                            grains.angles.smallest);
            }
            away.add(grains.angles);
            n_done += c.complex.n_cells;
            ++n_cases;
        }
    }
    RecordProperty("cells", n_done);
    RecordProperty("cases", n_cases);
    RecordProperty("refused", n_refused);
    RecordProperty("smallest_angle_away_from_features", std::to_string(away.smallest));
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
