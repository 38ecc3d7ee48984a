#include "mesher/interfaces/free_sites.hpp"

#include "mesher/base/checkpoint.hpp"
#include "mesher/interfaces/empty_circles.hpp"

namespace pcvt {
namespace {

/// The first distance in units of the spacing: no more darts find a place at 0.83. The factor from
/// one round of darts to the next.
constexpr double kFirstDistance = 0.8;
constexpr double kShrink = 0.96;
/// Darts per round: at least this number.
constexpr int kFewestDarts = 64;

}  // namespace

Points free_sites(const InclusionSet& set, const InterfaceSites& interfaces,
                  const FreeSitesOptions& options) {
    const Lattice& reduced = set.reduction().reduced;
    const EmptyCircles circles(reduced, interfaces.circles);
    const int n_seeds = interfaces.n_seeds();
    Points all(2, n_seeds + options.n);
    all.leftCols(n_seeds) = interfaces.coordinates;
    TorusGrid grid(reduced, n_seeds + options.n);
    for (int s = 0; s < n_seeds; ++s) grid.add(s, all.col(s));
    int n = n_seeds;
    double factor = kFirstDistance;
    for (std::uint64_t round = 0; n < all.cols(); ++round, factor *= kShrink) {
        // Rounds of one seed and those of the next share no random numbers.
        const Points darts = options.draw(std::max(options.n, kFewestDarts),
                                          options.seed * 0x9e3779b97f4a7c15u + round);
        for (Eigen::Index k = 0; k < darts.cols() && n < all.cols(); ++k) {
            checkpoint_each(static_cast<long>(k));
            const Vec2 u = reduced.to_lattice(darts.col(k));
            const Vec2 place(wrap(u.x()).fraction, wrap(u.y()).fraction);
            if (circles.contain(place)) continue;
            const double distance = factor * options.spacing(darts.col(k));
            bool is_free = true;
            grid.visit(place, distance, [&](int s, Offset offset) {
                const Vec2 d = all.col(s) + Vec2(offset.i, offset.j) - place;
                is_free = is_free && reduced.to_plane(d).squaredNorm() >= distance * distance;
            });
            if (!is_free) continue;
            all.col(n) = place;
            grid.add(n++, place);
        }
    }
    return all.rightCols(options.n);
}

}  // namespace pcvt
