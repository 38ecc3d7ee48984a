#include "mesher/plane/density/cell_quadrature.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mesher/plane/density/cell_cuts.hpp"
#include "mesher/plane/density/pixel_quadrature.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// A piece whose area equals the area of its bounding parallelogram up to this relative difference
/// is that parallelogram.
constexpr double kWhole = 1e-12;

LatticeBox lattice_box(CellView polygon) {
    LatticeBox box{polygon[0].lattice, polygon[0].lattice};
    for (const CellCorner& corner : polygon) {
        box.low = box.low.cwiseMin(corner.lattice);
        box.high = box.high.cwiseMax(corner.lattice);
    }
    return box;
}

double lattice_area(CellView polygon) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        twice += cross(polygon[k].lattice - polygon[0].lattice,
                       polygon[k + 1].lattice - polygon[0].lattice);
    }
    return std::abs(twice) / 2;
}

/// Returns the breaks, repeated in every period, between low and high.
std::vector<double> between(const std::vector<double>& breaks, double low, double high) {
    std::vector<double> found;
    double period = std::floor(low);
    auto next = std::upper_bound(breaks.begin(), breaks.end(), low - period);
    for (;; ++period, next = breaks.begin()) {
        for (; next != breaks.end(); ++next) {
            if (period + *next >= high) return found;
            found.push_back(period + *next);
        }
    }
}

void add_piece(CellView piece, int q, QuadratureBatch& batch) {
    const LatticeBox box = lattice_box(piece);
    const Vec2 size = box.high - box.low;
    const Vec2 period = ((box.low + box.high) / 2).array().floor();
    const bool whole =
        piece.size() == 4 && std::abs(lattice_area(piece) - size.prod()) <= kWhole * size.prod();
    if (whole) {
        batch.add_parallelogram(piece[0], piece[1], piece[3], period, q);
    } else {
        batch.add_fan(piece, piece[0], period, q);
    }
}

/// Calls take(part) for the parts of a convex polygon between the breaks along one axis.
template <class Take>
void cut_along(CellView polygon, int axis, const std::vector<double>& breaks, const Take& take) {
    const LatticeBox box = lattice_box(polygon);
    CellPolygon rest(polygon.begin(), polygon.end());
    CellPolygon below;
    CellPolygon above;
    for (const double at : between(breaks, box.low[axis], box.high[axis])) {
        cut(rest, axis, at, below, above);
        if (below.size() >= 3) take(below);
        rest.swap(above);
    }
    if (rest.size() >= 3) take(rest);
}

}  // namespace

CellQuadrature::CellQuadrature(const Density& density)
    : breaks_{density.u_breaks, density.v_breaks}, pixels_(density.pixels) {
    for (std::vector<double>& breaks : breaks_) {
        breaks.push_back(0);
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
        if (!(breaks.front() >= 0 && breaks.back() < 1)) {
            throw InvalidInput("a break line of the density is not in [0, 1); wrap it");
        }
    }
    has_breaks_ = breaks_[0].size() > 1 || breaks_[1].size() > 1;
}

int CellQuadrature::least_order() const { return pixels_ ? kPixelOrder : kLeastOrder; }

void CellQuadrature::cut_way(const Vec2& from, const Vec2& to, std::vector<double>& shares) const {
    shares = {0, 1};
    for (const int axis : {0, 1}) {
        const double low = std::min(from[axis], to[axis]);
        const double high = std::max(from[axis], to[axis]);
        if (breaks_[axis].size() == 1 && std::floor(low) == std::floor(high)) continue;
        for (const double at : between(breaks_[axis], low, high)) {
            shares.push_back((at - from[axis]) / (to[axis] - from[axis]));
        }
    }
    if (shares.size() > 2) std::sort(shares.begin(), shares.end());
}

bool CellQuadrature::is_cut_inside(const LatticeBox& box) const {
    for (const int axis : {0, 1}) {
        const std::vector<double>& breaks = breaks_[axis];
        const auto next = std::upper_bound(breaks.begin(), breaks.end(), box.low[axis]);
        if (next != breaks.end() && *next < box.high[axis]) return true;
    }
    return false;
}

void CellQuadrature::add(CellView cell, const Vec2& site, int q, QuadratureBatch& batch) const {
    const Vec2 period = site.array().floor();
    LatticeBox box = lattice_box(cell);
    box.low -= period;
    box.high -= period;
    if (!is_cut(box)) {
        batch.add_fan(cell, {Vec2::Zero(), site}, period, q);
    } else {
        cut_along(cell, 0, breaks_[0], [&](CellView strip) {
            cut_along(strip, 1, breaks_[1], [&](CellView piece) { add_piece(piece, q, batch); });
        });
    }
    batch.end_cell();
}

Moments CellQuadrature::operator()(CellView cell, const Vec2& site, int q,
                                   DensityProbe& probe) const {
    if (pixels_) {
        PixelQuadrature integrate(*pixels_, probe.basis().inverse());
        Moments moments = integrate(cell, site);
        probe.add(integrate.take_range());
        return moments;
    }
    QuadratureBatch batch(probe);
    add(cell, site, q, batch);
    return batch.collect().front();
}

}  // namespace pcvt::plane
