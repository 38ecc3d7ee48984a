#include "mesher/plane/density/cell_sums.hpp"

#include <algorithm>
#include <cstdint>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// Number of cells whose corners and points stay in the first-level cache.
constexpr int kCellsAtOnce = 32;
/// Number of points per evaluation that makes the cost of the call negligible.
constexpr std::size_t kEnoughPoints = 4096;
/// Cells closer to a break line than this many periods are treated as cut, since rounding could
/// carry a point across.
constexpr double kFromBreak = 1e-12;

/// std::floor for moderate numbers, without a function call.
double floor_of(double number) {
    const auto whole = static_cast<double>(static_cast<std::int64_t>(number));
    return whole - (whole > number ? 1 : 0);
}

Vec2 wrapped(const Vec2& u) { return {u.x() - floor_of(u.x()), u.y() - floor_of(u.y())}; }

}  // namespace

bool CellSums::is_cut(SiteId site) {
    cells_.unwrap({&site, 1}, list_);
    return quadrature_.is_cut(list_.box(0, wrapped(cells_.site(site)), 0));
}

void CellSums::sort_by_order(std::span<const OrderedCell> cells) {
    end_ = {};
    for (const OrderedCell& cell : cells) ++end_[cell.q];
    int n = 0;
    for (int& end : end_) {
        const int begin = n;
        n += end;
        end = begin;
    }
    sites_.resize(n);
    numbers_.resize(n);
    for (int k = 0; k < n; ++k) {
        const int place = end_[cells[k].q]++;
        sites_[place] = cells[k].site;
        numbers_[place] = k;
    }
}

void CellSums::add(std::span<const SiteId> sites, std::span<const int> numbers, int q,
                   std::vector<Moments>& moments) {
    cells_.unwrap(sites, list_);
    whole_.begin_order(q);
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const Vec2 site = wrapped(cells_.site(sites[k]));
        if (!quadrature_.is_cut(list_.box(k, site, kFromBreak))) {
            whole_.add(list_, k, site, numbers[k]);
            continue;
        }
        list_.copy(k, site, polygon_);
        if (on_pixels_) {
            moments[numbers[k]] = (*on_pixels_)(polygon_, site);
            probe_.add(on_pixels_->take_range());
            continue;
        }
        quadrature_.add(polygon_, site, q, cut_);
        cut_numbers_.push_back(numbers[k]);
    }
    whole_.end_order();
}

void CellSums::finish(std::vector<Moments>& moments) {
    const std::size_t n_columns = probe_.n_reserved_columns();
    const std::span<const double> rho = probe_.evaluate_reserved();
    whole_.take(rho, n_columns, moments);
    const std::vector<Moments>& cut = cut_.take(rho);
    for (std::size_t k = 0; k < cut.size(); ++k) moments[cut_numbers_[k]] = cut[k];
    cut_numbers_.clear();
}

void CellSums::integrate(std::span<const OrderedCell> cells, std::vector<Moments>& moments) {
    moments.resize(cells.size());
    sort_by_order(cells);
    int done = 0;
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
        while (done < end_[q]) {
            checkpoint();
            const auto n = static_cast<std::size_t>(std::min(end_[q] - done, kCellsAtOnce));
            add({&sites_[done], n}, {&numbers_[done], n}, q, moments);
            done += static_cast<int>(n);
            const std::size_t n_points = probe_.n_reserved() + probe_.n_reserved_columns();
            if (n_points >= kEnoughPoints) finish(moments);
        }
    }
    finish(moments);
}

}  // namespace pcvt::plane
