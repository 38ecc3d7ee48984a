#include "mesher/base/site_id.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "mesher/base/cancellable_sort.hpp"

namespace pcvt {
namespace {

template <typename Coordinates>
std::pair<SiteId, SiteId> first_equal_columns(const Coordinates& coordinates) {
    std::vector<SiteId> order(static_cast<std::size_t>(coordinates.cols()));
    std::iota(order.begin(), order.end(), 0);
    cancellable_sort(order.begin(), order.end(), [&](SiteId s, SiteId t) {
        for (Eigen::Index k = 0; k < coordinates.rows(); ++k) {
            if (coordinates(k, s) != coordinates(k, t))
                return coordinates(k, s) < coordinates(k, t);
        }
        return s < t;
    });
    std::pair<SiteId, SiteId> found{-1, -1};
    for (std::size_t k = 1; k < order.size(); ++k) {
        const std::pair<SiteId, SiteId> pair{order[k - 1], order[k]};
        const bool same = coordinates.col(pair.first) == coordinates.col(pair.second);
        if (same && (found.first < 0 || pair < found)) found = pair;
    }
    return found;
}

}  // namespace

std::pair<SiteId, SiteId> first_equal_sites(const Eigen::Matrix2Xd& coordinates) {
    return first_equal_columns(coordinates);
}

std::pair<SiteId, SiteId> first_equal_sites(const Eigen::Matrix3Xd& coordinates) {
    return first_equal_columns(coordinates);
}

}  // namespace pcvt
