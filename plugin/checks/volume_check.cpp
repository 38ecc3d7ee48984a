#include "plugin/checks/volume_check.hpp"

#include <limits>

#include "io/bytes/readable_number.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/space/cvt/volume_cvt.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/proof/volume_proof.hpp"

namespace pcvt::checks {
namespace {

/// Volumes of a file may be off by this many tolerances of a run.
constexpr double kVolumeTolerances = 10;

std::string prove_volumes(const space::StatedPolyhedra& cells, const AreaFile& wanted) {
    const int n = cells.mesh.n_sites();
    try {
        require_areas(wanted, n, "volume");
    } catch (const BadFile& error) {
        throw UnusableFile(error.what());  // The table does not fit; the tile may be right.
    }
    const Eigen::VectorXd volumes = scaled_volumes(wanted.areas, n, cells.mesh.lattice.volume());
    const space::VolumeComparison found =
        compare_volumes(cells, volumes, kVolumeTolerances * space::volume_tolerance(n));
    const std::string text = figure(found.error) + " of the mean of " + wanted.name +
                             " (tolerance " + figure(found.tolerance) + ")";
    if (found.error <= found.tolerance) {
        return ", volumes of " + counted(n, "cell") + " within " + text;
    }
    throw NotATile("law of the volumes: cell " + std::to_string(found.cell) + " has the volume " +
                   figure(found.volume) + ", not " + figure(volumes[found.cell]) + ": off by " +
                   text);
}

}  // namespace

std::string prove_cell_volumes(const SpaceFileProof& proof, const AreaFile& wanted) {
    const SpaceTile& tile = proof.tile;
    return prove_volumes({tile.mesh, tile.sites, tile.weights, proof.proof.tolerance}, wanted);
}

std::string prove_voxel_volumes(const std::string& path, const SpaceVoxels& voxels,
                                const AreaFile& wanted) {
    if (!voxels.cells) {
        throw UnusableFile(path +
                           ": states no sites, so it has no cells; check it without "
                           "--volumes");
    }
    const space::VoxelCells& stated = *voxels.cells;
    const Eigen::VectorXd weights =
        stated.weights.size() > 0 ? stated.weights : Eigen::VectorXd::Zero(stated.n_cells());
    const space::PeriodicDelaunay delaunay =
        weighted_cells(stated.lattice, stated.sites, weights, {.n_threads = 1}).delaunay;
    const space::CellComplex complex =
        cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights);
    std::vector<space::Offset> images;
    const space::PolyhedralMesh mesh =
        polyhedral_mesh(delaunay.sites, complex, space::Vec3::Zero(), &images);
    const space::Points sites = sites_of_cells(complex, images);
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() * stated.sites.cwiseAbs().maxCoeff();
    return prove_volumes({mesh, sites, weights, rounding}, wanted);
}

}  // namespace pcvt::checks
