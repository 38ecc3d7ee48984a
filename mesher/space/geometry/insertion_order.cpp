#include "mesher/space/geometry/insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/geometry/hilbert_curve.hpp"

namespace pcvt::space {
namespace {

/// Four bits of a sort key are left for the round.
constexpr int kMostRounds = 15;

/// Mixes the bits of a number (the finalizer of splitmix64).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

/// A site belongs to the last round with probability 7/8, to the one before with 7/64, ...
std::uint64_t round_of(SiteId site) {
    const int rounds_from_last = std::countr_zero(mixed(std::uint64_t(site))) / 3;
    return std::uint64_t(std::max(kMostRounds - rounds_from_last, 0));
}

std::uint64_t place_on_curve(const double* u) {
    std::array<std::uint32_t, 3> box;
    for (int axis = 0; axis < 3; ++axis) box[axis] = std::uint32_t(u[axis] * (1 << kHilbertBits));
    return hilbert_index(box);
}

}  // namespace

std::vector<SiteId> spread_sample(const Eigen::Matrix3Xd& coordinates,
                                  const std::array<int, 3>& n_boxes) {
    struct Nearest {
        double distance = std::numeric_limits<double>::infinity();
        SiteId site = -1;
    };
    const Eigen::Vector3d size(n_boxes[0], n_boxes[1], n_boxes[2]);
    std::vector<Nearest> nearest(static_cast<std::size_t>(size.prod()));
    for (SiteId s = 0; s < static_cast<SiteId>(coordinates.cols()); ++s) {
        checkpoint_each(s);
        const Eigen::Vector3d at = coordinates.col(s).cwiseProduct(size);
        const Eigen::Vector3d corner = at.array().floor().min(size.array() - 1);
        Nearest& box = nearest[std::size_t((corner[0] * size[1] + corner[1]) * size[2]) +
                               std::size_t(corner[2])];
        const double distance = (at - corner - Eigen::Vector3d::Constant(0.5)).squaredNorm();
        if (distance < box.distance) box = {distance, s};
    }
    std::vector<SiteId> sample;
    for (const Nearest& box : nearest) {
        if (box.site >= 0) sample.push_back(box.site);
    }
    return sample;
}

std::vector<SiteId> insertion_order(const Eigen::Matrix3Xd& coordinates,
                                    const std::vector<SiteId>& first) {
    struct Entry {
        std::uint64_t key;
        SiteId site;
    };
    const auto n = static_cast<SiteId>(coordinates.cols());
    std::vector<bool> is_first(static_cast<std::size_t>(n));
    for (const SiteId s : first) is_first[s] = true;
    std::vector<Entry> others;
    others.reserve(static_cast<std::size_t>(n) - first.size());
    for (SiteId s = 0; s < n; ++s) {
        checkpoint_each(s);
        if (is_first[s]) continue;
        const std::uint64_t place = place_on_curve(coordinates.col(s).data());
        others.push_back({round_of(s) << (3 * kHilbertBits) | place, s});
    }
    cancellable_sort(others.begin(), others.end(), [](const Entry& one, const Entry& other) {
        return one.key != other.key ? one.key < other.key : one.site < other.site;
    });
    std::vector<SiteId> order = first;
    order.reserve(static_cast<std::size_t>(n));
    for (const Entry& entry : others) order.push_back(entry.site);
    return order;
}

}  // namespace pcvt::space
