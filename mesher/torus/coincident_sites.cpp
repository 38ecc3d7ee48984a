#include "mesher/torus/coincident_sites.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "mesher/base/cancellable_sort.hpp"

namespace pcvt {
namespace {

/// Boxes of the first search are wider than the distance by this factor, so that few sites lie near
/// to a side of their box.
constexpr double kWideBoxes = 64;
/// More boxes than this along a period would be narrower than the rounding of the coordinates.
constexpr double kMostBoxes = 0x1p48;
/// Distances and coordinates are rounded: by this factor, and by this number.
constexpr double kRounding = 1 + 1e-9;
constexpr double kCoordinateRounding = 0x1p-50;

std::uint64_t mixed(std::uint64_t x) {
    x ^= x >> 32;
    x *= 0xd6e8feb86659fd93;
    x ^= x >> 32;
    x *= 0xd6e8feb86659fd93;
    return x ^ (x >> 32);
}

template <int Dimension>
class Search {
   public:
    using Coordinates = Eigen::Matrix<double, Dimension, Eigen::Dynamic>;
    using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
    using Vector = Eigen::Matrix<double, Dimension, 1>;

    Search(const Coordinates& coordinates, const Matrix& periods, double distance)
        : coordinates_(coordinates),
          periods_(periods),
          distance_(distance),
          extent_(kRounding * distance * periods.inverse().rowwise().norm() +
                  Vector::Constant(kCoordinateRounding)) {}

    std::vector<CoincidentSite> run() {
        // Most runs end here, without candidates.
        find_candidates();
        std::vector<CoincidentSite> found;
        const Boxes boxes = boxes_of(1);
        std::unordered_map<std::uint64_t, std::vector<SiteId>> kept;
        for (SiteId s = 0; s < static_cast<SiteId>(coordinates_.cols()); ++s) {
            checkpoint_each(s);
            if (!is_candidate_[s]) continue;
            const SiteId earlier = first_near(s, boxes, kept);
            if (earlier >= 0) {
                found.push_back({s, earlier});
            } else {
                kept[key_of(box_of(s, boxes))].push_back(s);
            }
        }
        return found;
    }

   private:
    using Boxes = std::array<std::int64_t, Dimension>;

    /// The numbers of boxes that are `factor` distances wide or wider.
    Boxes boxes_of(double factor) const {
        Boxes boxes;
        for (int k = 0; k < Dimension; ++k) {
            const double n = std::floor(1 / (factor * extent_[k]));
            // Fewer than three have no two different neighbours.
            boxes[k] = n < 3 ? 1 : static_cast<std::int64_t>(std::min(n, kMostBoxes));
        }
        return boxes;
    }

    Boxes box_of(SiteId s, const Boxes& boxes) const {
        Boxes box;
        for (int k = 0; k < Dimension; ++k) {
            const auto at = static_cast<std::int64_t>(coordinates_(k, s) * double(boxes[k]));
            box[k] = std::min(at, boxes[k] - 1);
        }
        return box;
    }

    static std::uint64_t key_of(const Boxes& box) {
        std::uint64_t key = 0;
        for (const std::int64_t at : box) key = mixed(key ^ mixed(std::uint64_t(at) + 1));
        return key;
    }

    /// Visits the boxes box + step with each component of the step between low and high, modulo
    /// the periods.
    template <class Visit>
    static void visit_boxes(const Boxes& box, const std::array<int, Dimension>& low,
                            const std::array<int, Dimension>& high, const Boxes& boxes,
                            const Visit& visit) {
        std::array<int, Dimension> step = low;
        for (;;) {
            Boxes other;
            for (int k = 0; k < Dimension; ++k) {
                other[k] = (box[k] + step[k] + boxes[k]) % boxes[k];
            }
            visit(key_of(other));
            int axis = 0;
            while (axis < Dimension && step[axis] == high[axis]) {
                step[axis] = low[axis];
                ++axis;
            }
            if (axis == Dimension) return;
            ++step[axis];
        }
    }

    /// Marks the sites that share a wide box, or a side of one, with another site.
    void find_candidates() {
        const auto n = static_cast<SiteId>(coordinates_.cols());
        const Boxes boxes = boxes_of(kWideBoxes);
        std::vector<std::pair<std::uint64_t, SiteId>> entries;
        entries.reserve(static_cast<std::size_t>(n) + static_cast<std::size_t>(n) / 8);
        for (SiteId s = 0; s < n; ++s) {
            checkpoint_each(s);
            const Boxes box = box_of(s, boxes);
            std::array<int, Dimension> low{};
            std::array<int, Dimension> high{};
            for (int k = 0; k < Dimension; ++k) {
                if (boxes[k] == 1) continue;
                const double width = 1 / double(boxes[k]);
                const double into = coordinates_(k, s) - double(box[k]) * width;
                if (into <= extent_[k]) low[k] = -1;
                if (into >= width - extent_[k]) high[k] = 1;
            }
            visit_boxes(box, low, high, boxes,
                        [&](std::uint64_t key) { entries.emplace_back(key, s); });
        }
        cancellable_sort(entries.begin(), entries.end());
        is_candidate_.assign(static_cast<std::size_t>(n), false);
        for (std::size_t k = 1; k < entries.size(); ++k) {
            if (entries[k].first != entries[k - 1].first) continue;
            is_candidate_[entries[k].second] = is_candidate_[entries[k - 1].second] = true;
        }
    }

    /// The first of the kept sites that a site coincides with, or -1.
    SiteId first_near(SiteId s, const Boxes& boxes,
                      const std::unordered_map<std::uint64_t, std::vector<SiteId>>& kept) const {
        SiteId first = -1;
        std::array<int, Dimension> low;
        std::array<int, Dimension> high;
        for (int k = 0; k < Dimension; ++k) {
            low[k] = boxes[k] == 1 ? 0 : -1;
            high[k] = boxes[k] == 1 ? 0 : 1;
        }
        visit_boxes(box_of(s, boxes), low, high, boxes, [&](std::uint64_t key) {
            const auto found = kept.find(key);
            if (found == kept.end()) return;
            for (const SiteId other : found->second) {
                if ((first < 0 || other < first) && are_near(s, other)) first = other;
            }
        });
        return first;
    }

    bool are_near(SiteId s, SiteId t) const {
        Vector d = coordinates_.col(s) - coordinates_.col(t);
        d -= d.array().round().matrix();
        return (periods_ * d).norm() < distance_;
    }

    const Coordinates& coordinates_;
    Matrix periods_;
    double distance_;
    /// By how much the distance extends in each coordinate.
    Vector extent_;
    std::vector<bool> is_candidate_;
};

template <int Dimension>
std::vector<CoincidentSite> to_drop(const typename Search<Dimension>::Coordinates& coordinates,
                                    const typename Search<Dimension>::Matrix& periods, double h) {
    const auto n = static_cast<int>(coordinates.cols());
    std::vector<CoincidentSite> dropped =
        Search<Dimension>(coordinates, periods, kCoincident * h).run();
    for (std::size_t n_before = 0; n_before < dropped.size();) {
        n_before = dropped.size();
        const std::vector<SiteId> kept = kept_sites(n, dropped);
        const double n_kept = static_cast<double>(kept.size());
        const double h_kept = h * std::pow(n / n_kept, 1.0 / Dimension);
        const typename Search<Dimension>::Coordinates left = coordinates(Eigen::all, kept);
        for (const CoincidentSite& more :
             Search<Dimension>(left, periods, kCoincident * h_kept).run()) {
            dropped.push_back({kept[more.site], kept[more.earlier]});
        }
        std::sort(dropped.begin(), dropped.end(),
                  [](const auto& s, const auto& t) { return s.site < t.site; });
    }
    return dropped;
}

}  // namespace

std::vector<CoincidentSite> coincident_sites(const Eigen::Matrix2Xd& coordinates,
                                             const Eigen::Matrix2d& periods, double distance) {
    return Search<2>(coordinates, periods, distance).run();
}

std::vector<CoincidentSite> coincident_sites(const Eigen::Matrix3Xd& coordinates,
                                             const Eigen::Matrix3d& periods, double distance) {
    return Search<3>(coordinates, periods, distance).run();
}

std::vector<CoincidentSite> sites_to_drop(const Eigen::Matrix2Xd& coordinates,
                                          const Eigen::Matrix2d& periods, double h) {
    return to_drop<2>(coordinates, periods, h);
}

std::vector<CoincidentSite> sites_to_drop(const Eigen::Matrix3Xd& coordinates,
                                          const Eigen::Matrix3d& periods, double h) {
    return to_drop<3>(coordinates, periods, h);
}

DroppedSites dropped_sites(std::vector<CoincidentSite> sites, const std::vector<int>& line_of) {
    DroppedSites dropped{.sites = std::move(sites)};
    if (line_of.empty()) return dropped;
    for (const auto& [site, earlier] : dropped.sites) {
        dropped.lines.push_back({line_of[site], line_of[earlier]});
    }
    return dropped;
}

std::vector<SiteId> kept_sites(int n, const std::vector<CoincidentSite>& dropped) {
    std::vector<SiteId> kept;
    kept.reserve(static_cast<std::size_t>(n) - dropped.size());
    auto next = dropped.begin();
    for (SiteId s = 0; s < n; ++s) {
        if (next != dropped.end() && next->site == s) {
            ++next;
        } else {
            kept.push_back(s);
        }
    }
    return kept;
}

}  // namespace pcvt
