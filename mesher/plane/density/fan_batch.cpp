#include "mesher/plane/density/fan_batch.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"

namespace pcvt::plane {
namespace {

constexpr int kFirstRoom = 2048;
constexpr double DensityPoint::*kCoordinates[] = {&DensityPoint::x, &DensityPoint::y,
                                                  &DensityPoint::u, &DensityPoint::v};

/// The layout of one rule's points in the fans of cells: the first point of every triangle, then
/// the second point of every triangle, and so on.
struct Placement {
    DensityPoint along_x;
    DensityPoint along_y;
    const double* x;
    const double* y;
    int n_corners;
    int q;
    const double* outwards;
    const double* across;
    DensityPoint* points;
};

static_assert(sizeof(DensityPoint) == sizeof(Quad));

PCVT_TARGET_CLONES void place_fan(const Placement& p, int begin, int end,
                                  const DensityPoint& site) {
    Quad origin;
    Quad along_x;
    Quad along_y;
    std::memcpy(&origin, &site, sizeof origin);
    std::memcpy(&along_x, &p.along_x, sizeof along_x);
    std::memcpy(&along_y, &p.along_y, sizeof along_y);
    // Place the points ray by ray, one triangle after the other.
    const std::ptrdiff_t stride = p.n_corners;
    const int q = p.q;
    Quad from = along_x * p.x[end - 1] + along_y * p.y[end - 1];
    for (int c = begin; c < end; ++c) {
        const Quad to = along_x * p.x[c] + along_y * p.y[c];
        const Quad side = to - from;
        for (int j = 0; j < q; ++j) {
            const Quad ray = from + p.across[j] * side;
            DensityPoint* at = p.points + j * stride + c;
            for (int i = 0; i < q; ++i) {
                const Quad point = origin + p.outwards[i] * ray;
                std::memcpy(at, &point, sizeof point);
                at += q * stride;
            }
        }
        from = to;
    }
}

/// The same for one coordinate of points by columns.
struct ColumnPlacement {
    double along_x;
    double along_y;
    const double* from_x;
    const double* from_y;
    const double* to_x;
    const double* to_y;
    const double* origin;
    int stride;
    int q;
    const double* outwards;
    const double* across;
    double* column;
};

/// Computes the numbers of place_fan, to the last bit.
PCVT_TARGET_CLONES void place_column(const ColumnPlacement& p) {
    const int stride = p.stride;
    const int q = p.q;
    for (int c = 0; c < stride; c += kLanes) {
        Lanes from_x, from_y, to_x, to_y, origin;
        std::memcpy(&from_x, p.from_x + c, sizeof from_x);
        std::memcpy(&from_y, p.from_y + c, sizeof from_y);
        std::memcpy(&to_x, p.to_x + c, sizeof to_x);
        std::memcpy(&to_y, p.to_y + c, sizeof to_y);
        std::memcpy(&origin, p.origin + c, sizeof origin);
        const Lanes from = p.along_x * from_x + p.along_y * from_y;
        const Lanes to = p.along_x * to_x + p.along_y * to_y;
        const Lanes side = to - from;
        for (int j = 0; j < q; ++j) {
            const Lanes ray = from + p.across[j] * side;
            double* at = p.column + j * std::ptrdiff_t{stride} + c;
            for (int i = 0; i < q; ++i) {
                const Lanes point = origin + p.outwards[i] * ray;
                std::memcpy(at, &point, sizeof point);
                at += q * std::ptrdiff_t{stride};
            }
        }
    }
}

struct Corners {
    const double* from_x;
    const double* from_y;
    const double* to_x;
    const double* to_y;
    double* mass;
    double* first_x;
    double* first_y;
    double* second;
};

/// Computes the moments of the triangles (0, from, to).
/// @param stride  the number of values from one point of the triangles to the next.
PCVT_TARGET_CLONES void sum_triangles(int n_corners, int stride, const Corners& corners,
                                      int n_points, const double* weights, const double* rho) {
    for (int c = 0; c < n_corners; c += kLanes) {
        // Sum rho times the weights of the monomials over the points.
        Lanes s0{}, s1{}, s2{}, s3{}, s4{}, s5{};
        const double* w = weights;
        const double* here = rho + c;
        for (int k = 0; k < n_points; ++k) {
            Lanes r;
            std::memcpy(&r, here, sizeof r);
            s0 += w[0] * r;
            s1 += w[1] * r;
            s2 += w[2] * r;
            s3 += w[3] * r;
            s4 += w[4] * r;
            s5 += w[5] * r;
            w += 6;
            here += stride;
        }
        // Scale the sums to the triangle (0, p, r).
        Lanes px, py, rx, ry;
        std::memcpy(&px, corners.from_x + c, sizeof px);
        std::memcpy(&py, corners.from_y + c, sizeof py);
        std::memcpy(&rx, corners.to_x + c, sizeof rx);
        std::memcpy(&ry, corners.to_y + c, sizeof ry);
        Lanes cross = px * ry - py * rx;
        // Coincident corners make triangles that consist of rounding only.
        cross = cross > 0 ? cross : 0 * cross;
        const Lanes mass = cross * s0;
        const Lanes first_x = cross * (s1 * px + s2 * rx);
        const Lanes first_y = cross * (s1 * py + s2 * ry);
        const Lanes second = cross * (s3 * (px * px + py * py) + 2 * s4 * (px * rx + py * ry) +
                                      s5 * (rx * rx + ry * ry));
        // Store the moments.
        std::memcpy(corners.mass + c, &mass, sizeof mass);
        std::memcpy(corners.first_x + c, &first_x, sizeof first_x);
        std::memcpy(corners.first_y + c, &first_y, sizeof first_y);
        std::memcpy(corners.second + c, &second, sizeof second);
    }
}

}  // namespace

FanBatch::FanBatch(DensityProbe& probe, const Eigen::Matrix2d& from_frame)
    : probe_(probe),
      along_x_(probe.change(from_frame.col(0))),
      along_y_(probe.change(from_frame.col(1))) {}

void FanBatch::make_room(int n_corners) {
    const std::size_t n = std::max(2 * n_corners, kFirstRoom);
    for (auto* array :
         {&from_x_, &from_y_, &to_x_, &to_y_, &mass_, &first_x_, &first_y_, &second_, &origin_}) {
        array->resize(n);
    }
}

void FanBatch::add(const CellList& cells, std::size_t k, const Vec2& site, int number) {
    const int begin = cells.begin[k];
    const int n = cells.begin[k + 1] - begin;
    // Grow the arrays.
    if (n_corners_ + n + kLanes > static_cast<int>(from_x_.size())) {
        make_room(n_corners_ + n + kLanes);
    }
    // Copy the corners and their predecessors.
    const double* const from_list_x = cells.x.data() + begin;
    const double* const from_list_y = cells.y.data() + begin;
    double* const to_x = to_x_.data() + n_corners_;
    double* const to_y = to_y_.data() + n_corners_;
    double* const from_x = from_x_.data() + n_corners_;
    double* const from_y = from_y_.data() + n_corners_;
    from_x[0] = from_list_x[n - 1];
    from_y[0] = from_list_y[n - 1];
    for (int c = 0; c < n - 1; ++c) {
        to_x[c] = from_x[c + 1] = from_list_x[c];
        to_y[c] = from_y[c + 1] = from_list_y[c];
    }
    to_x[n - 1] = from_x[0];
    to_y[n - 1] = from_y[0];
    // Record the cell.
    n_corners_ += n;
    cells_.push_back({n, number, probe_.change(site)});
}

void FanBatch::place_points(Group& group, int n_corners) {
    const TriangleRule& rule = triangle_rule(group.q);
    group.first_point = probe_.n_reserved();
    group.stride = n_corners;
    DensityPoint* const points =
        probe_.reserve(std::size_t(n_corners) * std::size_t(rule.n_points()));
    const Placement placement{along_x_,
                              along_y_,
                              to_x_.data() + group.first_corner,
                              to_y_.data() + group.first_corner,
                              n_corners,
                              group.q,
                              rule.outwards.data(),
                              rule.across.data(),
                              points};
    // Place the points cell by cell.
    int begin = 0;
    for (std::size_t k = group.first_cell; k < cells_.size(); ++k) {
        const int end = begin + cells_[k].n_corners;
        place_fan(placement, begin, end, cells_[k].origin);
        begin = end;
    }
}

void FanBatch::place_columns(Group& group, int n_corners) {
    const TriangleRule& rule = triangle_rule(group.q);
    const auto n_points = static_cast<std::size_t>(rule.n_points());
    group.first_point = probe_.n_reserved_columns();
    group.stride = whole_lanes(n_corners);
    const auto n_repeats = static_cast<std::size_t>(group.stride - n_corners);
    const std::array<double*, 4> columns =
        probe_.reserve_columns(n_points * std::size_t(group.stride), n_points * n_repeats);
    // Fill the last lanes with the last corner.
    const int first = group.first_corner;
    for (auto* array : {&from_x_, &from_y_, &to_x_, &to_y_}) {
        double* const corners = array->data() + first;
        std::fill_n(corners + n_corners, n_repeats, corners[std::max(n_corners - 1, 0)]);
    }
    // Place one coordinate after the other.
    for (std::size_t d = 0; d < 4; ++d) {
        if (columns[d] == nullptr || n_corners == 0) continue;
        double* end = origin_.data();
        for (std::size_t k = group.first_cell; k < cells_.size(); ++k) {
            end = std::fill_n(end, cells_[k].n_corners, cells_[k].origin.*kCoordinates[d]);
        }
        std::fill_n(end, n_repeats, end[-1]);
        place_column({along_x_.*kCoordinates[d], along_y_.*kCoordinates[d], from_x_.data() + first,
                      from_y_.data() + first, to_x_.data() + first, to_y_.data() + first,
                      origin_.data(), group.stride, group.q, rule.outwards.data(),
                      rule.across.data(), columns[d]});
    }
}

void FanBatch::end_order() {
    Group& group = groups_.back();
    const int n_corners = n_corners_ - group.first_corner;
    if (probe_.takes_columns()) {
        place_columns(group, n_corners);
    } else {
        place_points(group, n_corners);
    }
}

void FanBatch::take(std::span<const double> rho, std::size_t n_columns,
                    std::vector<Moments>& moments) {
    const double* const values = rho.data() + (probe_.takes_columns() ? rho.size() - n_columns : 0);
    // Integrate over triangles, one group of cells after the other.
    groups_.push_back({0, n_corners_, cells_.size(), 0, 0});
    for (std::size_t g = 0; g + 1 < groups_.size(); ++g) {
        const Group& group = groups_[g];
        const TriangleRule& rule = triangle_rule(group.q);
        const int first = group.first_corner;
        const Corners corners{from_x_.data() + first,  from_y_.data() + first,
                              to_x_.data() + first,    to_y_.data() + first,
                              mass_.data() + first,    first_x_.data() + first,
                              first_y_.data() + first, second_.data() + first};
        sum_triangles(groups_[g + 1].first_corner - first, group.stride, corners, rule.n_points(),
                      rule.weights.data(), values + group.first_point);
    }
    // Add up the triangles of each cell.
    int c = 0;
    for (const Cell& cell : cells_) {
        const int end = c + cell.n_corners;
        double mass = 0;
        double first_x = 0;
        double first_y = 0;
        double second = 0;
        for (; c < end; ++c) {
            mass += mass_[c];
            first_x += first_x_[c];
            first_y += first_y_[c];
            second += second_[c];
        }
        moments[cell.number] = {mass, {first_x, first_y}, second};
    }
    groups_.clear();
    cells_.clear();
    n_corners_ = 0;
}

}  // namespace pcvt::plane
