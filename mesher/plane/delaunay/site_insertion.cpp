#include "mesher/plane/delaunay/site_insertion.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/delaunay/spatial_sort.hpp"

namespace pcvt::plane {
namespace {

/// Mixes the bits of a number (the finalizer of splitmix64).
std::uint64_t mixed_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

/// Rounds of random sites, each four times as many as in the round before, and in each round
/// neighbours after each other.
std::vector<SiteId> random_rounds(const Sites& sites) {
    SpatialSort columns = spatial_sort(sites.coordinates(), gram_of(sites.reduction().reduced));
    // Sites on a line across the columns follow each other along it.
    for (int k = 0; k < columns.n_columns(); ++k) {
        checkpoint();
        const auto at = [&](SiteId s) {
            const auto u = sites.coordinates().col(s);
            return std::pair(u[1 - columns.across], u[columns.across]);
        };
        std::sort(columns.order.begin() + columns.begin[k],
                  columns.order.begin() + columns.begin[k + 1],
                  [&](SiteId s, SiteId t) { return at(s) < at(t); });
    }
    std::vector<std::pair<int, SiteId>> entries;
    entries.reserve(columns.order.size());
    for (const SiteId s : columns.order) {
        entries.emplace_back(-std::countr_zero(mixed_bits(std::uint64_t(s))) / 2, s);
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    std::vector<SiteId> order;
    order.reserve(entries.size());
    for (const auto& [round, site] : entries) order.push_back(site);
    return order;
}

Sites first_of(const Sites& sites, const std::vector<SiteId>& order, int n) {
    Points coordinates(2, n);
    for (int k = 0; k < n; ++k) coordinates.col(k) = sites.coordinates().col(order[k]);
    return {sites.lattice(), sites.reduction(), std::move(coordinates)};
}

/// Whether the first of two images is the smaller one in the lexicographic order of coordinates.
bool is_smaller(const Image& p, const Image& q) {
    const int u = compare_u(p, q);
    return u != 0 ? u < 0 : compare_v(p, q) < 0;
}

/// Whether s lies inside of the circle through the counter-clockwise p, q, r; of cocircular images
/// by the rule of CGAL: the greatest one whose perturbation changes the determinant decides.
bool violates_circle(const Gram& gram, const Image& p, const Image& q, const Image& r,
                     const Image& s) {
    const int side = in_circle(gram, p, q, r, s);
    if (side != 0) return side > 0;
    std::array<const Image*, 4> order{&p, &q, &r, &s};
    std::sort(order.begin(), order.end(),
              [](const Image* one, const Image* other) { return is_smaller(*other, *one); });
    for (const Image* const greatest : order) {
        if (greatest == &s) return false;
        const auto or_s = [&](const Image& corner) -> const Image& {
            return &corner == greatest ? s : corner;
        };
        const int turn = orientation(or_s(p), or_s(q), or_s(r));
        if (turn != 0) return turn > 0;
    }
    return false;
}

/// A triangulation that grows site by site.
class Growth {
   public:
    Growth(const Sites& sites, TorusTriangulation triangulation)
        : coordinates_(sites.coordinates()),
          gram_(gram_of(sites.reduction().reduced)),
          triangulation_(std::move(triangulation)) {}

    void insert_all() {
        for (auto s = SiteId(triangulation_.n_sites()); s < coordinates_.cols(); ++s) {
            checkpoint_each(s, 64);
            insert(s);
        }
    }

    /// One of each orbit: the one whose circumcentre lies in the domain.
    /// @param name  the id of each site.
    std::vector<Triangle> triangles(const std::vector<SiteId>& name) const {
        std::vector<Triangle> all;
        all.reserve(static_cast<std::size_t>(triangulation_.n_triangles()));
        for (int t = 0; t < triangulation_.n_triangles(); ++t) {
            checkpoint_each(t);
            Triangle corners = in_domain(t);
            for (Corner& corner : corners) corner.site = name[corner.site];
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                        corners.end());
            all.push_back(corners);
        }
        std::sort(all.begin(), all.end());
        return all;
    }

   private:
    Image image_of(const Corner& corner, Offset shift) const {
        return image(coordinates_, corner.site, corner.offset + shift);
    }

    void insert(SiteId site) {
        const Image p = image(coordinates_, site, {});
        const auto [t, shift] = locate(p);
        // The edge that contains the new site, if there is one.
        int on_edge = -1;
        std::array<int, 3> beside{};
        for (int k = 0; k < 3; ++k) {
            const int h = 3 * t + k;
            if (turn_at(h, shift, p) == 0) on_edge = k;
        }
        beside = triangulation_.insert(t, -shift);
        stack_.assign(beside.begin(), beside.end());
        if (on_edge >= 0) flip(beside[on_edge]);
        while (!stack_.empty()) {
            const int h = stack_.back();
            stack_.pop_back();
            if (violates(h)) flip(h);
        }
    }

    int turn_at(int h, Offset shift, const Image& p) const {
        return orientation(image_of(triangulation_.corner(h), shift),
                           image_of(triangulation_.corner(TorusTriangulation::next(h)), shift), p);
    }

    /// The shift that brings a corner of a triangle, the nearest one, near to p.
    Offset shift_to_nearest(int t, const Image& p) const {
        Offset nearest;
        double least = 1;
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const Vec2 way = difference(image_of(triangulation_.corner(h), {}), p);
            const Vec2 whole = way.array().round();
            const double distance = (way - whole).cwiseAbs().maxCoeff();
            if (!(distance < least)) continue;
            least = distance;
            nearest = {int(whole.x()), int(whole.y())};
        }
        return nearest;
    }

    /// Walks from the last triangle to one that contains p.
    std::pair<int, Offset> locate(const Image& p) {
        int t = last_;
        Offset shift = shift_to_nearest(t, p);
        for (long step = 0;; ++step) {
            checkpoint_each(step);
            int exit = -1;
            for (int h = 3 * t; h < 3 * t + 3 && exit < 0; ++h) {
                if (turn_at(h, shift, p) < 0) exit = h;
            }
            if (exit < 0) break;
            shift = shift + triangulation_.frame_across(exit);
            t = triangulation_.opposite(exit) / 3;
        }
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (difference(image_of(triangulation_.corner(h), shift), p).isZero(0)) {
                throw InternalError("two sites coincide");
            }
        }
        last_ = t;
        return {t, shift};
    }

    bool violates(int h) const {
        return violates_circle(gram_, image_of(triangulation_.corner(h), {}),
                               image_of(triangulation_.corner(TorusTriangulation::next(h)), {}),
                               image_of(triangulation_.corner(TorusTriangulation::previous(h)), {}),
                               image_of(triangulation_.apex_across(h), {}));
    }

    void flip(int h) {
        const int o = triangulation_.opposite(h);
        triangulation_.flip(h);
        stack_.insert(stack_.end(), {TorusTriangulation::next(h), TorusTriangulation::previous(h),
                                     TorusTriangulation::next(o), TorusTriangulation::previous(o)});
    }

    Triangle in_domain(int t) const {
        const std::array<Corner, 3> corners{triangulation_.corner(3 * t),
                                            triangulation_.corner(3 * t + 1),
                                            triangulation_.corner(3 * t + 2)};
        const Image p = image_of(corners[0], {});
        const Vec2 centre = Vec2(p.u, p.v) + circumcentre(gram_, p, image_of(corners[1], {}),
                                                          image_of(corners[2], {}));
        const Vec2 whole = centre.array().floor();
        // Rounding may put a centre near a side of the domain on the wrong side of it.
        for (const int k : {4, 1, 3, 5, 7, 0, 2, 6, 8}) {
            const Offset shift{k / 3 - 1 - int(whole.x()), k % 3 - 1 - int(whole.y())};
            const auto at = [&](int c) { return image_of(corners[c], shift); };
            if (!circumcentre_in_domain(gram_, at(0), at(1), at(2))) continue;
            Triangle found = corners;
            for (Corner& corner : found) corner.offset = corner.offset + shift;
            return found;
        }
        throw InternalError("no image of a triangle has its circumcentre in the domain");
    }

    const Points& coordinates_;
    Gram gram_;
    TorusTriangulation triangulation_;
    int last_ = 0;
    std::vector<int> stack_;
};

}  // namespace

std::vector<Triangle> inserted_triangles(const Sites& sites, int n_first) {
    const std::vector<SiteId> order = random_rounds(sites);
    n_first = std::min(n_first, sites.n_sites());
    const Sites ordered = first_of(sites, order, sites.n_sites());
    Growth growth(ordered, TorusTriangulation(
                               n_first, mirror_diagram(first_of(sites, order, n_first)).triangles));
    growth.insert_all();
    return growth.triangles(order);
}

}  // namespace pcvt::plane
