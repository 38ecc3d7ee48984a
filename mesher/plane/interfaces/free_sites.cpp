#include "mesher/plane/interfaces/free_sites.hpp"

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/interfaces/empty_circles.hpp"

namespace pcvt::plane {
namespace {

/// The first distance in units of the spacing: no more darts find a place at 0.83. The factor from
/// one round of darts to the next.
constexpr double kFirstDistance = 0.8;
constexpr double kShrink = 0.96;
/// Darts per round: at least this number.
constexpr int kFewestDarts = 64;

/// Points of the torus that keep distances, each with its mirror images.
class PlacedPoints {
   public:
    PlacedPoints(const InclusionSet& set, int n)
        : set_(set), grid_(reduced(), n * n_images(set.walls())) {}

    void add(const Vec2& place) {
        for (int r = 0; r < n_images(set_.walls()); ++r) {
            images_.push_back(image(place, r));
            grid_.add(static_cast<int>(images_.size()) - 1, images_.back());
        }
    }
    /// Whether no point, and no image of the place itself, is nearer than `distance`.
    bool leave_room(const Vec2& place, double distance) const {
        const auto is_far = [&](const Vec2& d) {
            return reduced().to_position(d).squaredNorm() >= distance * distance;
        };
        bool is_free = true;
        grid_.visit(place, distance, [&](int k, Offset offset) {
            is_free = is_free && is_far(images_[k] + Vec2(offset.i, offset.j) - place);
        });
        for (int r = 1; r < n_images(set_.walls()); ++r) {
            const Vec2 d = image(place, r) - place;
            is_free = is_free && is_far(d - Vec2(d.array().round()));
        }
        return is_free;
    }

   private:
    const Lattice& reduced() const { return set_.reduction().reduced; }
    Vec2 image(const Vec2& place, int r) const {
        if (r == 0) return place;
        const Vec2 u =
            reduced().to_lattice(mirror_image(reduced().to_position(place), set_.walls(), r));
        return {wrap(u.x()).fraction, wrap(u.y()).fraction};
    }

    const InclusionSet& set_;
    TorusGrid grid_;
    std::vector<Vec2> images_;
};

}  // namespace

Points free_sites(const InclusionSet& set, const InterfaceSites& interfaces,
                  const FreeSitesOptions& options) {
    const Lattice& reduced = set.reduction().reduced;
    const EmptyCircles circles(reduced, interfaces.circles);
    PlacedPoints placed(set, interfaces.n_seeds() + options.n);
    for (const auto& seed : interfaces.coordinates.colwise()) placed.add(seed);
    Points places(2, options.n);
    int n = 0;
    double factor = kFirstDistance;
    for (std::uint64_t round = 0; n < options.n; ++round, factor *= kShrink) {
        // Rounds of one seed and those of the next share no random numbers.
        const Points darts = options.draw(std::max(options.n, kFewestDarts),
                                          options.seed * 0x9e3779b97f4a7c15u + round);
        for (Eigen::Index k = 0; k < darts.cols() && n < options.n; ++k) {
            checkpoint_each(static_cast<long>(k));
            const Vec2 u = reduced.to_lattice(darts.col(k));
            const Vec2 place(wrap(u.x()).fraction, wrap(u.y()).fraction);
            if (circles.contain(place)) continue;
            if (!placed.leave_room(place, factor * options.spacing(darts.col(k)))) continue;
            places.col(n++) = place;
            placed.add(place);
        }
    }
    return places;
}

}  // namespace pcvt::plane
