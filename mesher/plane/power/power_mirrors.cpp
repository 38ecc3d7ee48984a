#include "mesher/plane/power/power_mirrors.hpp"

#include <CGAL/Regular_triangulation_2.h>

#include <algorithm>
#include <set>

#include "mesher/plane/delaunay/power_predicates.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// Makes CGAL triangulate weighted images with our predicates. CGAL breaks ties by the
/// lexicographic order of exact coordinates, a rule that is the same for all translates.
struct WeightedImageTraits {
    using FT = double;
    using Point_2 = WeightedImage;
    using Weighted_point_2 = WeightedImage;
    struct Segment_2 {};
    struct Triangle_2 {};
    struct Construct_point_2 {
        const WeightedImage& operator()(const WeightedImage& p) const { return p; }
    };
    struct Construct_weighted_point_2 {
        const WeightedImage& operator()(const WeightedImage& p) const { return p; }
    };
    struct Compare_x_2 {
        CGAL::Comparison_result operator()(const WeightedImage& p, const WeightedImage& q) const {
            return CGAL::Comparison_result(compare_u(p.at, q.at));
        }
    };
    struct Compare_y_2 {
        CGAL::Comparison_result operator()(const WeightedImage& p, const WeightedImage& q) const {
            return CGAL::Comparison_result(compare_v(p.at, q.at));
        }
    };
    struct Less_x_2 {
        bool operator()(const WeightedImage& p, const WeightedImage& q) const {
            return compare_u(p.at, q.at) < 0;
        }
    };
    struct Less_y_2 {
        bool operator()(const WeightedImage& p, const WeightedImage& q) const {
            return compare_v(p.at, q.at) < 0;
        }
    };
    struct Orientation_2 {
        CGAL::Orientation operator()(const WeightedImage& p, const WeightedImage& q,
                                     const WeightedImage& r) const {
            return CGAL::Orientation(orientation(p.at, q.at, r.at));
        }
    };
    struct Power_side_of_oriented_power_circle_2 {
        Gram gram;
        CGAL::Oriented_side operator()(const WeightedImage& p, const WeightedImage& q,
                                       const WeightedImage& r, const WeightedImage& s) const {
            return CGAL::Oriented_side(in_power_circle(gram, p, q, r, s));
        }
        CGAL::Oriented_side operator()(const WeightedImage& p, const WeightedImage& q,
                                       const WeightedImage& s) const {
            return CGAL::Oriented_side(in_power_segment(gram, p, q, s));
        }
        CGAL::Oriented_side operator()(const WeightedImage& p, const WeightedImage& q) const {
            return CGAL::Oriented_side((q.weight > p.weight) - (q.weight < p.weight));
        }
    };

    Construct_point_2 construct_point_2_object() const { return {}; }
    Construct_weighted_point_2 construct_weighted_point_2_object() const { return {}; }
    Compare_x_2 compare_x_2_object() const { return {}; }
    Compare_y_2 compare_y_2_object() const { return {}; }
    Less_x_2 less_x_2_object() const { return {}; }
    Less_y_2 less_y_2_object() const { return {}; }
    Orientation_2 orientation_2_object() const { return {}; }
    Power_side_of_oriented_power_circle_2 power_side_of_oriented_power_circle_2_object() const {
        return {gram};
    }

    Gram gram{};
};

using Euclidean = CGAL::Regular_triangulation_2<WeightedImageTraits>;
using Vertex = Euclidean::Vertex_handle;

/// Cells this close to a side of the domain count as touching it: a superfluous image does no harm,
/// a missing image does.
constexpr double kTouch = 1e-9;

Polygon rectangle(double low, double high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
}

/// The Euclidean diagram of the sites and a growing set of their images.
class Flooding {
   public:
    Flooding(const Sites& sites, const Eigen::VectorXd& weights)
        : sites_(sites),
          weights_(weights),
          gram_(gram_of(sites.reduction().reduced)),
          euclidean_(WeightedImageTraits{gram_}) {
        for (SiteId s = 0; s < sites_.n_sites(); ++s) insert(s, {});
    }

    void insert_all_copies() {
        for (SiteId s = 0; s < sites_.n_sites(); ++s) {
            for (int i = -1; i <= 1; ++i) {
                for (int j = -1; j <= 1; ++j) require(s, {i, j});
            }
        }
        insert_required();
    }

    /// Inserts the images that the cells of all images require until none is missing. A cell only
    /// shrinks, but the cells of one site may leave D_0 altogether, so that its other images must
    /// be found from the remaining ones; hence the rounds.
    void flood() {
        for (const Vertex v : euclidean_.finite_vertex_handles()) require_images(v);
        do {
            while (!required_.empty()) {
                for (const Vertex v : insert_required()) require_images(v);
            }
            for (const SiteId s : sites_without_piece()) require_around(s);
        } while (!required_.empty());
    }

    PowerMirrors diagram() const {
        PowerMirrors diagram;
        diagram.n_mirrors = static_cast<int>(known_.size()) - sites_.n_sites();
        for (const auto face : euclidean_.finite_face_handles()) {
            const WeightedImage& p = face->vertex(0)->point();
            const WeightedImage& q = face->vertex(1)->point();
            const WeightedImage& r = face->vertex(2)->point();
            if (!orthocentre_in_domain(gram_, p, q, r)) continue;
            diagram.triangles.push_back({Corner{p.at.site, p.at.offset},
                                         Corner{q.at.site, q.at.offset},
                                         Corner{r.at.site, r.at.offset}});
        }
        return diagram;
    }

   private:
    void require(SiteId site, Offset offset) {
        if (!known_.contains({site, offset})) required_.insert({site, offset});
    }

    Vertex insert(SiteId site, Offset offset) {
        known_.insert({site, offset});
        const Vertex v = euclidean_.insert({image(sites_, site, offset), weights_[site]}, hint_);
        if (!v->is_hidden() && v->face() != Euclidean::Face_handle()) hint_ = v->face();
        return v;
    }

    std::vector<Vertex> insert_required() {
        std::vector<Vertex> inserted;
        for (const auto& [site, offset] : std::exchange(required_, {})) {
            inserted.push_back(insert(site, offset));
        }
        return inserted;
    }

    /// Clips a polygon, coordinates of the reduced basis, by the half-planes of all neighbours.
    Polygon clipped_cell(Vertex v, Polygon polygon) const {
        if (euclidean_.dimension() < 1) return polygon;
        auto w = euclidean_.incident_vertices(v);
        const auto first = w;
        do {
            if (!euclidean_.is_infinite(w)) polygon = clip(polygon, v->point(), w->point());
        } while (++w != first);
        return polygon;
    }

    Polygon clip(const Polygon& polygon, const WeightedImage& p, const WeightedImage& q) const {
        const Vec2 d = difference(p.at, q.at);
        const Vec2 normal(gram_.aa * d.x() + gram_.ab * d.y(), gram_.ab * d.x() + gram_.bb * d.y());
        const Vec2 origin(p.at.u + p.at.offset.i, p.at.v + p.at.offset.j);
        return clipped(polygon, normal,
                       normal.dot(origin) + (normal.dot(d) + p.weight - q.weight) / 2);
    }

    Polygon piece(Vertex v) const {
        return v->is_hidden() ? Polygon{} : clipped_cell(v, rectangle(-kTouch, 1 + kTouch));
    }

    /// The paper's rule: a piece that meets the side or corner towards the neighbouring domain t
    /// requires the image (i, o - t).
    void require_images(Vertex v) {
        const auto side = [](double x) { return x < kTouch ? -1 : (x > 1 - kTouch ? 1 : 0); };
        const Image p = v->point().at;
        for (const Vec2& x : piece(v)) {
            const Offset t{side(x.x()), side(x.y())};
            for (const Offset u : {Offset{t.i, 0}, Offset{0, t.j}, t}) {
                if (u != Offset{}) require(p.site, p.offset - u);
            }
        }
    }

    std::set<SiteId> sites_without_piece() const {
        std::set<SiteId> without;
        for (SiteId s = 0; s < sites_.n_sites(); ++s) without.insert(s);
        for (const Vertex v : euclidean_.finite_vertex_handles()) {
            if (!piece(v).empty()) without.erase(v->point().at.site);
        }
        return without;
    }

    /// Requires the images of a site in the domains that the cell of any of its images meets.
    void require_around(SiteId site) {
        for (const Vertex v : euclidean_.finite_vertex_handles()) {
            const Image p = v->point().at;
            if (p.site != site) continue;
            for (int i = -1; i <= 1; ++i) {
                for (int j = -1; j <= 1; ++j) {
                    const Offset t = p.offset + Offset{i, j};
                    Polygon domain = rectangle(-kTouch, 1 + kTouch);
                    for (Vec2& x : domain) x += Vec2(t.i, t.j);
                    if (!clipped_cell(v, domain).empty()) require(site, p.offset - t);
                }
            }
        }
    }

    const Sites& sites_;
    const Eigen::VectorXd& weights_;
    Gram gram_;
    Euclidean euclidean_;
    Euclidean::Face_handle hint_;
    std::set<std::pair<SiteId, Offset>> known_;
    std::set<std::pair<SiteId, Offset>> required_;
};

}  // namespace

PowerMirrors power_mirrors(const Sites& sites, const Eigen::VectorXd& weights) {
    Flooding flooding(sites, weights);
    flooding.flood();
    return flooding.diagram();
}

PowerMirrors power_copies(const Sites& sites, const Eigen::VectorXd& weights) {
    Flooding flooding(sites, weights);
    flooding.insert_all_copies();
    return flooding.diagram();
}

}  // namespace pcvt::plane
