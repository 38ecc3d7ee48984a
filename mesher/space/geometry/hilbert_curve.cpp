#include "mesher/space/geometry/hilbert_curve.hpp"

#include <functional>
#include <utility>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

/// A cube is visited octant by octant in the order of a Gray code, which is rotated by an axis and
/// reflected so that the curve enters at one corner and leaves at a neighbouring one. An octant is
/// three bits, one an axis.
struct Octant {
    /// The place of the octant in its cube, and the pose of the curve within the octant.
    std::uint8_t place;
    std::uint8_t pose;
};
constexpr int kPoses = 24;

constexpr unsigned rotated_left(unsigned octant, unsigned axes) {
    return ((octant << axes) | (octant >> (3 - axes))) & 7;
}

constexpr unsigned gray(unsigned place) { return place ^ (place >> 1); }

/// The corner at which the curve enters the octant with this place.
constexpr unsigned entry(unsigned place) { return place == 0 ? 0 : gray((place - 1) & ~1u); }

/// The axis along which the curve crosses the octant with this place.
constexpr unsigned axis_within(unsigned place) {
    unsigned ones = place == 0 ? 0 : (place % 2 == 0 ? place - 1 : place);
    unsigned axis = 0;
    for (; ones % 2 == 1; ones /= 2) ++axis;
    return axis % 3;
}

/// A pose is 8 times the axis plus the corner at which the curve enters.
constexpr std::array<std::array<Octant, 8>, kPoses> octants() {
    std::array<std::array<Octant, 8>, kPoses> table{};
    for (unsigned pose = 0; pose < kPoses; ++pose) {
        const unsigned corner = pose % 8;
        const unsigned axis = pose / 8;
        const unsigned turn = (axis + 1) % 3;
        for (unsigned place = 0; place < 8; ++place) {
            const unsigned octant = rotated_left(gray(place), turn) ^ corner;
            const unsigned enters = corner ^ rotated_left(entry(place), turn);
            const unsigned crosses = (axis + axis_within(place) + 1) % 3;
            table[pose][octant] = {std::uint8_t(place), std::uint8_t(8 * crosses + enters)};
        }
    }
    return table;
}

constexpr auto kOctants = octants();

}  // namespace

std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& box) {
    std::uint64_t index = 0;
    unsigned pose = 0;
    for (int bit = kHilbertBits - 1; bit >= 0; --bit) {
        const unsigned octant =
            (box[0] >> bit & 1) | (box[1] >> bit & 1) << 1 | (box[2] >> bit & 1) << 2;
        const Octant next = kOctants[pose][octant];
        index = index << 3 | next.place;
        pose = next.pose;
    }
    return index;
}

std::vector<SiteId> hilbert_order(const Eigen::Matrix3Xd& coordinates) {
    std::vector<std::pair<std::uint64_t, SiteId>> places;
    places.reserve(static_cast<std::size_t>(coordinates.cols()));
    for (SiteId s = 0; s < static_cast<SiteId>(coordinates.cols()); ++s) {
        checkpoint_each(s);
        const auto slice = [&](int axis) {
            return std::uint32_t(coordinates(axis, s) * (1 << kHilbertBits));
        };
        places.emplace_back(hilbert_index({slice(0), slice(1), slice(2)}), s);
    }
    cancellable_sort(places.begin(), places.end(), std::less<>());
    std::vector<SiteId> order;
    order.reserve(places.size());
    for (const auto& [place, site] : places) order.push_back(site);
    return order;
}

}  // namespace pcvt::space
