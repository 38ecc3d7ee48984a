#pragma once

#include <string>
#include <vector>

#include "mesher/cells/set_names.hpp"

namespace pcvt {

/// The orientation of a crystal by Bunge's Euler angles, degrees: turns by phi1 about z, by Phi
/// about the new x, by phi2 about the new z take the axes of the sample to those of the crystal
/// (H.-J. Bunge 1982).
struct BungeAngles {
    double phi1 = 0;
    double Phi = 0;
    double phi2 = 0;

    friend bool operator==(const BungeAngles&, const BungeAngles&) = default;
};

/// @throws InvalidInput unless each angle lies from -360 to 360 degrees.
BungeAngles checked_angles(const BungeAngles& angles);

/// The materials of the cells of a polycrystal.
struct CellMaterials {
    /// In the order in which the user named them; empty: the cells have no phases.
    std::vector<std::string> phase_names = {};
    /// The index of the phase of the cell of each site 0 ... n - 1; empty without phases.
    std::vector<int> site_phase = {};
    /// The orientation of the cell of each site; may be empty.
    std::vector<BungeAngles> site_orientation = {};

    friend bool operator==(const CellMaterials&, const CellMaterials&) = default;

    /// The name of the phase of a site; empty without phases.
    std::string phase_of(int site) const {
        return site_phase.empty() ? "" : phase_names[site_phase[site]];
    }
    bool empty() const { return site_phase.empty() && site_orientation.empty(); }
};

/// The name of the group of the elements of a phase, in every format: `phase_steel`.
inline std::string phase_group(const std::string& phase_name) {
    return std::string(kPhaseSet) + phase_name;
}

}  // namespace pcvt
