#include "mesher/cells/misorientations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

using Quaternion = std::array<double, 4>;

/// The rotation of an orientation as a unit quaternion (w, x, y, z).
Quaternion quaternion_of(const BungeAngles& angles) {
    const auto [c, s] = cos_sin_of_degrees(angles.Phi / 2);
    const auto [c_sum, s_sum] = cos_sin_of_degrees((angles.phi1 + angles.phi2) / 2);
    const auto [c_difference, s_difference] = cos_sin_of_degrees((angles.phi1 - angles.phi2) / 2);
    return {c * c_sum, s * c_difference, s * s_difference, c * s_sum};
}

/// The components of the rotation between two orientations, up to their signs and their order.
Quaternion between(const Quaternion& p, const Quaternion& q) {
    return {p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3],
            p[0] * q[1] - p[1] * q[0] + p[3] * q[2] - p[2] * q[3],
            p[0] * q[2] - p[2] * q[0] + p[1] * q[3] - p[3] * q[1],
            p[0] * q[3] - p[3] * q[0] + p[2] * q[1] - p[1] * q[2]};
}

/// The products with the 24 rotations of the cube have these largest scalar parts: about <100> by
/// 0 and 90 degrees, and about <111> by 120 degrees.
double disorientation(const Quaternion& p, const Quaternion& q) {
    Quaternion r = between(p, q);
    for (double& component : r) component = std::abs(component);
    std::sort(r.begin(), r.end(), std::greater<>());
    const double cosine =
        std::max({r[0], (r[0] + r[1]) * std::numbers::sqrt2 / 2, (r[0] + r[1] + r[2] + r[3]) / 2});
    return 2 * portable_acos(std::min(cosine, 1.0)) * (180 / std::numbers::pi);
}

}  // namespace

double cubic_disorientation(const BungeAngles& one, const BungeAngles& other) {
    return disorientation(quaternion_of(one), quaternion_of(other));
}

std::optional<Misorientations> misorientations(const CellTable& cells,
                                               const CellMaterials& materials) {
    if (materials.site_orientation.empty()) return std::nullopt;
    std::vector<Quaternion> rotations;
    for (const BungeAngles& angles : materials.site_orientation) {
        rotations.push_back(quaternion_of(angles));
    }
    const std::vector<int>& phase = materials.site_phase;
    const auto are_alike = [&](SiteId s, SiteId t) {
        return phase.empty() || phase[s] == phase[t];
    };
    Misorientations found;
    double sum = 0;
    for (SiteId s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        for (int k = cells.neighbour_begin[s]; k < cells.neighbour_begin[s + 1]; ++k) {
            const SiteId t = cells.neighbours[k];
            const bool is_first = s < t;
            if (!is_first || !are_alike(s, t)) continue;
            const double angle = disorientation(rotations[s], rotations[t]);
            ++found.counts[static_cast<std::size_t>(angle / Misorientations::kClass)];
            ++found.n_boundaries;
            sum += angle;
            found.largest = std::max(found.largest, angle);
        }
    }
    if (found.n_boundaries == 0) return std::nullopt;
    found.mean = sum / found.n_boundaries;
    return found;
}

}  // namespace pcvt
