#pragma once

#include <vector>

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// A face of a cell: its number, and whether its corners run clockwise seen from outside.
struct FaceUse {
    int face;
    bool reversed;
};

/// The faces of each cell, by rising number.
///
/// Example usage:
///     const CellFaces cells(mesh);
///     for (const FaceUse& use : cells[s]) sum += (use.reversed ? -1 : 1) * flux[use.face];
class CellFaces {
   public:
    explicit CellFaces(const PolyhedralMesh& mesh);

    int n_cells() const { return static_cast<int>(begin_.size()) - 1; }
    std::span<const FaceUse> operator[](int cell) const {
        return {uses_.data() + begin_[cell], uses_.data() + begin_[cell + 1]};
    }

   private:
    std::vector<int> begin_;
    std::vector<FaceUse> uses_;
};

/// Returns the volumes and centroids of the cells. Corners of a face may lie off its plane by
/// rounding; each face counts as the fan of triangles from its first corner. Where short edges were
/// removed, faces are bent, and the volume is the one that finite-volume solvers compute
/// (OpenFOAM): a third of the sum over the faces of their vector area times their centre, which is
/// the mean of the triangles round the mean of the corners, by their areas.
std::vector<CellBody> cell_bodies(const PolyhedralMesh& mesh);

}  // namespace pcvt::space
