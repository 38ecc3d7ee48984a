#include "mesher/cells/cell_materials.hpp"

#include "mesher/base/error.hpp"

namespace pcvt {

BungeAngles checked_angles(const BungeAngles& angles) {
    constexpr double kFullTurn = 360;
    for (const double angle : {angles.phi1, angles.Phi, angles.phi2}) {
        if (angle >= -kFullTurn && angle <= kFullTurn) continue;
        throw InvalidInput(
            "an angle of an orientation is not from -360 to 360 degrees; correct it");
    }
    return angles;
}

}  // namespace pcvt
