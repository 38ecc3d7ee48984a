#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// The sizes in an MPAS mesh file; all but kOne are dimensions of the file.
enum class MpasSize { kCells, kEdges, kVertices, kMaxEdges, kMaxEdges2, kTwo, kVertexDegree, kOne };

struct MpasDimension {
    const char* name;
    MpasSize size;
};
/// Returns the dimensions in the order of the file, without the unlimited `Time`.
const std::vector<MpasDimension>& mpas_dimensions();
/// Returns the value of `size` for `grid`.
int mpas_size(const MpasGrid& grid, MpasSize size);

/// A variable of the file and the table of MpasGrid that it stores; exactly one of `indices`,
/// `counts` and `numbers` is set. Indices count from 1 in the file, and 0 fills unused entries.
struct MpasVariable {
    const char* name;
    MpasSize rows;
    /// kOne: the variable has one dimension.
    MpasSize columns;
    std::vector<int> MpasGrid::*indices = nullptr;
    std::vector<int> MpasGrid::*counts = nullptr;
    std::vector<double> MpasGrid::*numbers = nullptr;
};
/// The attributes that say that a mesh is a torus in the plane.
inline constexpr std::array<std::array<const char*, 2>, 2> kMpasPlane{
    {{"on_a_sphere", "NO"}, {"is_periodic", "YES"}}};
inline constexpr const char* kMpasSphereRadius = "sphere_radius";
/// The mean of meshDensity over the area.
inline constexpr const char* kMpasMeanDensity = "mesh_density_mean";
/// `latCell` and so on are 0, because the plane has neither latitudes nor heights.
inline constexpr std::array<const char*, 3> kMpasZeros{"lat", "lon", "z"};

/// Returns the variables in the order of the file, without the ids and without the latitudes,
/// longitudes and z, which are 0.
const std::vector<MpasVariable>& mpas_variables();

}  // namespace pcvt
