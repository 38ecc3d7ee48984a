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
    /// As MPAS writes them: "m", "m^2", "s^{-1}", "unitless".
    const char* units;
    const char* long_name;
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
/// The attributes that state the Coriolis parameter, where the file has one.
inline constexpr std::array<const char*, 2> kMpasCoriolis{"coriolis_f", "coriolis_beta"};

/// The beginning of a history that pcvt wrote, in whose file all attributes are its own.
inline constexpr const char* kMpasOwnHistory = "pcvt ";

/// A variable with equal values in all meshes of one size, and its attributes.
struct MpasPlain {
    std::string name;
    MpasSize rows;
    /// Whether it holds the ids, which count from 1; else all values are 0, because the plane has
    /// neither latitudes nor heights.
    bool is_id;
    const char* units;
    std::string long_name;
};
/// Returns `latCell`, `lonCell`, `zCell`, `indexToCellID`, and the same of edges and vertices, in
/// the order of the file.
const std::vector<MpasPlain>& mpas_plain_variables();

/// Returns the variables in the order of the file, without the ids and without the latitudes,
/// longitudes and z, which are 0. The last ones are the Coriolis parameter, which a file without
/// kMpasCoriolis lacks.
const std::vector<MpasVariable>& mpas_variables();

/// Whether a variable is the Coriolis parameter.
bool is_coriolis(const MpasVariable& variable);

}  // namespace pcvt
