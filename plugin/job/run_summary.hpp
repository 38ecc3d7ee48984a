#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_error.hpp"
#include "mesher/cells/elastic_choices.hpp"
#include "mesher/cells/material_choices.hpp"
#include "mesher/cells/misorientations.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/cvt/size_summary.hpp"
#include "mesher/optimize/minimum.hpp"
#include "mesher/optimize/run_statistics.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/tessellation/tessellation.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"

namespace pcvt {

/// Seconds of each stage.
struct JobSeconds {
    double build = 0;
    double optimize = 0;
    double write = 0;
    double total = 0;
};

/// The best exact lattice for the number of sites.
struct PatternFigures {
    /// A reduced basis, one vector a column, length units.
    Eigen::MatrixXd basis;
    /// The numbers of its Hermite form: a, b, d in the plane, a, d, f, b, c, e in space.
    std::vector<int> hermite;
    double energy = 0;
    LatticeStability stability = {};
};

/// What is known of a start, besides the sites.
struct StartFigures {
    /// Of sites that were not given.
    Start chosen = Start::kRandom;
    /// Set by the starts that look for it.
    std::optional<PatternFigures> pattern = {};
    /// How the global search found its best state, in words; else empty.
    std::string found = {};
};

/// The figures of a tile of polyhedra.
struct PolyhedraFigures {
    int n_removed_edges = 0;
    space::PolyhedralProof proof = {};
    /// The corner of a box outline, length units; its cells are pieces.
    std::optional<space::Vec3> box_origin = {};
};

/// The figures of tetrahedra inside of cells.
struct SpaceGrainFigures {
    int n_tetrahedra = 0;
    int n_points = 0;
    /// Dihedral angles of the tetrahedra that touch no sharp feature of the cells, degrees; nothing
    /// where each touches one.
    std::optional<double> smallest_angle = {};
    std::optional<double> largest_angle = {};
    /// The corners of faces and the edges of cells that are sharp, the sharpest one, and the
    /// smallest angle of the tetrahedra at them, degrees.
    int n_sharp = 0;
    double sharpest = 0;
    double smallest_sharp_angle = 0;
};

/// The summary of a run, besides its files.
struct RunSummary {
    /// Its evaluations include those of a global search, but not those of the coarser problems of a
    /// coarse start. kCancelled: no file was written, and only `recovered` is set. The energy is F,
    /// length^4, in space length^5.
    RunStatistics run = {.stop = Stop::kCancelled};
    int n_sites = 0;
    /// The number of seeds, from Job::seed on, whose cells an output refused.
    int retries = 0;
    /// The energy of as many regular hexagons, or of truncated octahedra; `nullopt` with a density.
    std::optional<double> energy_bound = {};
    /// The answer of minimum_of(), where the job asks for the stability.
    std::optional<Minimum> minimum = {};
    /// `nullopt` if the triangulation was built without mirrors.
    std::optional<int> n_mirrors = {};
    /// Cells by their number of sides, in space of faces, on the unrepeated torus; edges under 1e-5
    /// h do not count in the plane.
    std::map<int, int> valences = {};
    /// Figures of the density, if the job has one.
    std::optional<plane::DensityFigures> density = {};
    /// Figures of the prescribed areas or volumes, if the job has them.
    std::optional<SizeSummary> sizes = {};
    /// Figures of prescribed centroids, if the job has them.
    std::optional<CentroidFigures> centroids = {};
    /// The number of orbits of sites; 0 without a symmetry.
    int n_orbits = 0;
    /// The number of sites that lie on walls.
    int n_on_walls = 0;
    /// Figures of the inclusions, if the job has some.
    std::optional<plane::InterfaceFigures> interfaces = {};
    /// One entry for each phase.
    std::vector<PhaseFigures> phases = {};
    /// The range of the orientations, if the job has some.
    std::optional<AngleRange> angles = {};
    /// The misorientations of neighbours, as of cubic crystals; `nullopt` where there are none.
    std::optional<Misorientations> misorientations = {};
    /// The materials whose elastic constants the files state.
    std::vector<NamedConstants> constants = {};
    /// In the plane, one entry for each mesh of the job.
    std::vector<plane::TileFigures> tiles = {};
    /// Figures of the tile in space; `nullopt` in the plane.
    std::optional<PolyhedraFigures> polyhedra = {};
    /// Of runs with tetrahedra inside of the cells of space.
    std::optional<SpaceGrainFigures> space_grains = {};
    /// The files and folders that were written, in the order of the outputs, without the report.
    std::vector<std::string> files = {};
    /// The outputs that were not written, in their order.
    std::vector<RefusedFile> refused = {};
    /// One line for each set of an earlier run that was finished before this one.
    std::vector<std::string> recovered = {};
    StartFigures start = {};
    JobSeconds seconds = {};

    /// The number of cells with this number of sides.
    int n_with_sides(int sides) const {
        const auto entry = valences.find(sides);
        return entry == valences.end() ? 0 : entry->second;
    }
};

}  // namespace pcvt
