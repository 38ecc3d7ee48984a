#include "mesher/plane/interfaces/interface_sites.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/interfaces/place_tree.hpp"

namespace pcvt::plane {
namespace {

/// In units of the radius: other seeds are at least this far outside of a circle.
constexpr double kMargin = 0.01;
/// A seed has at least this height above its chord, in units of the chord.
constexpr double kLeastHeight = 0.02;
/// The factor by which chords become shorter where seeds do not fit.
constexpr double kShorter = 0.75;
constexpr int kMostSiteRounds = 20;

/// A point of the plane wrapped into the reduced domain.
struct WrappedPoint {
    Vec2 fraction;
    Offset whole;
};

WrappedPoint wrapped(const Lattice& reduced, const Vec2& p) {
    const Vec2 u = reduced.to_lattice(p);
    const Wrapped x = wrap(u.x());
    const Wrapped y = wrap(u.y());
    return {{x.fraction, y.fraction}, {x.whole, y.whole}};
}

/// A seed in the frame of its inclusion.
struct Seed {
    int inclusion;
    bool is_inside;
    Vec2 point;
    /// The node before its chord; a shared seed is at this node.
    int node;
};

/// One curve with its seeds.
struct Curve {
    std::vector<InterfaceNode> nodes;
    /// The seeds beside the chord from each node to the next.
    std::vector<SiteId> inside;
    std::vector<SiteId> outside;

    int n() const { return static_cast<int>(nodes.size()); }
    int next(int k) const { return k + 1 == n() ? 0 : k + 1; }
    int previous(int k) const { return k == 0 ? n() - 1 : k - 1; }
    double chord(int k) const { return (nodes[next(k)].point - nodes[k].point).norm(); }
    double longer_chord(int k) const { return std::max(chord(k), chord(previous(k))); }
};

class Placement {
   public:
    Placement(const InclusionSet& set, const std::function<double(const Vec2&)>& spacing)
        : set_(set), sizing_{spacing, {}}, curves_(static_cast<std::size_t>(set.size())) {
        sizing_.limits.resize(static_cast<std::size_t>(set.n_given()));
        changed_.assign(sizing_.limits.size(), true);
    }

    InterfaceSites run() {
        for (int round = 0; round < kMostSiteRounds; ++round) {
            divide();
            add_seeds();
            check_circles();
            if (!first_bad_) return result();
        }
        const Vec2& p = first_bad_->second;
        throw BadInclusion(
            set_[first_bad_->first].line,
            "the interface near (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) +
                ") is too sharp or too close to another one; change the shape there");
    }

   private:
    /// Divides the curves whose limits have changed, and the images of all curves behind walls.
    void divide() {
        for (int i = 0; i < set_.n_given(); ++i) {
            if (changed_[i]) curves_[i].nodes = interface_nodes(set_, i, sizing_);
            changed_[i] = false;
        }
        for (int i = set_.n_given(); i < set_.size(); ++i) {
            const int r = i / set_.n_given();
            std::vector<InterfaceNode> nodes = curves_[i % set_.n_given()].nodes;
            for (InterfaceNode& node : nodes) {
                node.point = mirror_image(node.point, set_.walls(), r);
            }
            if (is_reflection(r)) std::reverse(nodes.begin(), nodes.end());
            curves_[i].nodes = std::move(nodes);
        }
    }

    /// Shortens the chords at a node, more than the limits that exist; behind a wall, those of the
    /// node of which it is an image.
    void shorten(int inclusion, int node) {
        if (inclusion >= set_.n_given()) {
            const bool is_reversed = is_reflection(inclusion / set_.n_given());
            if (is_reversed) node = curves_[inclusion].n() - 1 - node;
            inclusion %= set_.n_given();
        }
        const Curve& curve = curves_[inclusion];
        const Vec2& p = curve.nodes[node].point;
        std::vector<SizeLimit>& limits = sizing_.limits[inclusion];
        const double size = std::min(curve.longer_chord(node), size_at(limits, p));
        limits.push_back({p, kShorter * size});
        changed_[inclusion] = true;
        if (!first_bad_) first_bad_ = {inclusion, p};
    }

    SiteId add_seed(const Seed& seed) {
        seeds_.push_back(seed);
        wrapped_.push_back(wrapped(set_.reduction().reduced, seed.point));
        return static_cast<SiteId>(seeds_.size()) - 1;
    }

    void add_seeds() {
        seeds_.clear();
        wrapped_.clear();
        first_bad_.reset();
        for (int i = 0; i < set_.size(); ++i) {
            Curve& curve = curves_[i];
            curve.inside.assign(curve.nodes.size(), -1);
            curve.outside.assign(curve.nodes.size(), -1);
            for (int k = 0; k < curve.n(); ++k) {
                checkpoint_each(k);
                add_pair(i, k);
            }
        }
    }

    /// Adds the seeds of the chord from node k to the next one.
    void add_pair(int i, int k) {
        Curve& curve = curves_[i];
        const InterfaceNode& from = curve.nodes[k];
        const InterfaceNode& to = curve.nodes[curve.next(k)];
        const double length = curve.chord(k);
        const Vec2 along = (to.point - from.point) / length;
        const double r = from.radius;
        const double foot = (length * length + (r - to.radius) * (r + to.radius)) / (2 * length);
        const double square = (r - foot) * (r + foot);
        // Circles that do not intersect: their chords differ too much.
        const bool meets = square > kLeastHeight * kLeastHeight * length * length;
        const double height = meets ? std::sqrt(square) : length / 2;
        if (!meets) {
            shorten(i, k);
            shorten(i, curve.next(k));
        }
        const Vec2 middle = from.point + foot * along;
        const Vec2 up = height * turned_left(along);
        const auto seed = [&](int side) {
            // The chord before shares the seed at `from`, the chord after this one that at `to`.
            std::vector<SiteId>& own = side > 0 ? curve.inside : curve.outside;
            const bool is_wrap = curve.next(k) == 0;
            if (from.shared_side == side && k > 0) own[k] = own[k - 1];
            if (to.shared_side == side && is_wrap) own[k] = own[0];
            if (own[k] >= 0) return;
            own[k] = add_seed({i, side > 0, middle + side * up, k});
        };
        seed(1);
        seed(-1);
    }

    /// Shortens the chords of each circle with a foreign seed inside, and those of the seed.
    void check_circles() {
        Points places(2, static_cast<Eigen::Index>(seeds_.size()));
        for (std::size_t s = 0; s < seeds_.size(); ++s) {
            places.col(Eigen::Index(s)) = wrapped_[s].fraction;
        }
        const PlaceTree tree(set_.reduction().reduced, std::move(places));
        for (int i = 0; i < set_.size(); ++i) {
            for (int k = 0; k < curves_[i].n(); ++k) {
                checkpoint_each(k);
                check_circle(tree, i, k);
            }
        }
    }

    void check_circle(const PlaceTree& tree, int i, int k) {
        const Curve& curve = curves_[i];
        const Lattice& reduced = set_.reduction().reduced;
        const double reach = (1 + kMargin) * curve.nodes[k].radius;
        const WrappedPoint centre = wrapped(reduced, curve.nodes[k].point);
        const int before = curve.previous(k);
        const std::array<SiteId, 4> own{curve.inside[k], curve.outside[k], curve.inside[before],
                                        curve.outside[before]};
        for (const auto& [s, offset] : tree.within(centre.fraction, reach)) {
            const bool is_own = std::find(own.begin(), own.end(), s) != own.end();
            if (is_own && offset == wrapped_[s].whole - centre.whole) continue;
            shorten(i, k);
            shorten(seeds_[s].inclusion, seeds_[s].node);
        }
    }

    InterfaceSites result() const {
        InterfaceSites sites;
        // The seeds of images behind walls come last.
        for (const Seed& seed : seeds_) {
            if (seed.inclusion >= set_.n_given()) break;
            sites.inclusion.push_back(seed.is_inside ? seed.inclusion
                                                     : set_.parent(seed.inclusion));
        }
        for (int i = 0; i < set_.n_given(); ++i) sites.parents.push_back(set_.parent(i));
        sites.coordinates.resize(2, sites.n_seeds());
        for (int s = 0; s < sites.n_seeds(); ++s) {
            sites.coordinates.col(s) = wrapped_[s].fraction;
        }
        const Reduction& reduction = set_.reduction();
        for (int i = 0; i < set_.size(); ++i) {
            for (const InterfaceNode& node : curves_[i].nodes) {
                sites.circles.push_back(
                    {wrapped(reduction.reduced, node.point).fraction, node.radius});
            }
        }
        for (int i = 0; i < set_.n_given(); ++i) {
            const Curve& curve = curves_[i];
            Polygon polygon;
            for (int k = 0; k < curve.n(); ++k) {
                const InterfaceNode& node = curve.nodes[k];
                polygon.push_back(node.point);
                const WrappedPoint& inside = wrapped_[curve.inside[k]];
                const WrappedPoint& outside = wrapped_[curve.outside[k]];
                const Vec2 back = reduction.reduced.translation(inside.whole);
                sites.chords.push_back({i, curve.inside[k], curve.outside[k],
                                        reduction.to_original(outside.whole - inside.whole),
                                        node.point - back,
                                        curve.nodes[curve.next(k)].point - back});
            }
            sites.polygons.push_back(std::move(polygon));
        }
        return sites;
    }

    const InclusionSet& set_;
    InterfaceSizing sizing_;
    std::vector<Curve> curves_;
    std::vector<bool> changed_;
    std::vector<Seed> seeds_;
    /// The place of each seed, wrapped.
    std::vector<WrappedPoint> wrapped_;
    /// The inclusion and the place where seeds do not fit first.
    std::optional<std::pair<int, Vec2>> first_bad_;
};

}  // namespace

InterfaceSites place_interface_sites(const InclusionSet& set,
                                     const std::function<double(const Vec2&)>& spacing) {
    return Placement(set, spacing).run();
}

}  // namespace pcvt::plane
