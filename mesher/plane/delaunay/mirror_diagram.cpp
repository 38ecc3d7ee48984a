#include "mesher/plane/delaunay/mirror_diagram.hpp"

// CGAL's containers lose a block if the memory for their list of blocks runs out.
#include "mesher/base/scoped_blocks.hpp"
#define CGAL_ALLOCATOR(T) pcvt::ScopedAllocator<T>

#include <CGAL/Delaunay_triangulation_2.h>

#include <algorithm>
#include <limits>
#include <set>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/delaunay/predicates.hpp"

namespace pcvt::plane {
namespace {

/// Makes CGAL triangulate images with the predicates of predicates.hpp. CGAL breaks ties of
/// in_circle by the lexicographic order of the points, which here is the order of exact
/// coordinates. The rule is therefore the same for all translates, and cocircular images are
/// triangulated alike.
struct ImageTraits {
    using FT = double;
    using Point_2 = Image;
    struct Segment_2 {};
    struct Triangle_2 {};
    struct Construct_point_2 {
        const Image& operator()(const Image& p) const { return p; }
    };
    struct Compare_x_2 {
        CGAL::Comparison_result operator()(const Image& p, const Image& q) const {
            return CGAL::Comparison_result(compare_u(p, q));
        }
    };
    struct Compare_y_2 {
        CGAL::Comparison_result operator()(const Image& p, const Image& q) const {
            return CGAL::Comparison_result(compare_v(p, q));
        }
    };
    struct Less_x_2 {
        bool operator()(const Image& p, const Image& q) const { return compare_u(p, q) < 0; }
    };
    struct Less_y_2 {
        bool operator()(const Image& p, const Image& q) const { return compare_v(p, q) < 0; }
    };
    struct Orientation_2 {
        CGAL::Orientation operator()(const Image& p, const Image& q, const Image& r) const {
            checkpoint();
            return CGAL::Orientation(orientation(p, q, r));
        }
    };
    struct Side_of_oriented_circle_2 {
        Gram gram;
        CGAL::Oriented_side operator()(const Image& p, const Image& q, const Image& r,
                                       const Image& s) const {
            return CGAL::Oriented_side(in_circle(gram, p, q, r, s));
        }
    };

    Construct_point_2 construct_point_2_object() const { return {}; }
    Compare_x_2 compare_x_2_object() const { return {}; }
    Compare_y_2 compare_y_2_object() const { return {}; }
    Less_x_2 less_x_2_object() const { return {}; }
    Less_y_2 less_y_2_object() const { return {}; }
    Orientation_2 orientation_2_object() const { return {}; }
    Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {gram}; }

    Gram gram{};
};

using Euclidean = CGAL::Delaunay_triangulation_2<ImageTraits>;
using Vertex = Euclidean::Vertex_handle;

/// Cells this close to a side of the domain count as touching it: a superfluous image does no harm,
/// a missing image does.
constexpr double kTouch = 1e-9;

/// The four sides of [-margin, 1 + margin]^2, counter-clockwise.
std::vector<Vec2> square(double margin) {
    const double lo = -margin;
    const double hi = 1 + margin;
    return {{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}};
}

/// Keeps the part of the polygon that is nearer to p than to q (Sutherland and Hodgman's clipping
/// by one half-plane).
std::vector<Vec2> clip_by_bisector(const std::vector<Vec2>& polygon, const Gram& gram,
                                   const Image& p, const Image& q) {
    const Vec2 d = difference(p, q);
    const Vec2 normal(gram.aa * d.x() + gram.ab * d.y(), gram.ab * d.x() + gram.bb * d.y());
    const Vec2 origin(p.u + p.offset.i, p.v + p.offset.j);
    const double level = normal.dot(d) / 2;
    const auto beyond = [&](const Vec2& x) { return normal.dot(x - origin) - level; };

    std::vector<Vec2> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& x = polygon[k];
        const Vec2& y = polygon[(k + 1) % polygon.size()];
        const double fx = beyond(x);
        const double fy = beyond(y);
        if (fx <= 0) kept.push_back(x);
        if ((fx < 0 && fy > 0) || (fx > 0 && fy < 0)) kept.push_back(x + fx / (fx - fy) * (y - x));
    }
    return kept;
}

/// Collects the neighbouring domains whose common side or corner with D_0 the polygon meets.
void collect_neighbours(const std::vector<Vec2>& polygon, std::set<Offset>& neighbours) {
    const auto side = [](double x) { return x < kTouch ? -1 : (x > 1 - kTouch ? 1 : 0); };
    for (const Vec2& x : polygon) {
        const Offset t{side(x.x()), side(x.y())};
        if (t.i != 0) neighbours.insert({t.i, 0});
        if (t.j != 0) neighbours.insert({0, t.j});
        if (t.i != 0 && t.j != 0) neighbours.insert(t);
    }
}

/// The Euclidean diagram of the sites and a growing set of their images.
class Flooding {
   public:
    explicit Flooding(const Sites& sites)
        : sites_(sites),
          gram_(gram_of(sites.reduction().reduced)),
          euclidean_(ImageTraits{gram_}) {}

    void insert_sites() {
        std::vector<Image> images;
        for (SiteId s = 0; s < sites_.n_sites(); ++s) images.push_back(image(sites_, s, {}));
        euclidean_.insert(images.begin(), images.end());
    }

    void insert_all_copies() {
        std::vector<Image> images;
        for (SiteId s = 0; s < sites_.n_sites(); ++s) {
            checkpoint_each(s);
            for (int i = -1; i <= 1; ++i) {
                for (int j = -1; j <= 1; ++j) images.push_back(image(sites_, s, {i, j}));
            }
        }
        euclidean_.insert(images.begin(), images.end());
    }

    /// Returns the sites with an unbounded cell or a Voronoi vertex outside of D_0.
    std::vector<Vertex> boundary_sites() const {
        std::vector<Vertex> found;
        for (const Vertex v : euclidean_.finite_vertex_handles()) {
            if (!is_inner(v)) found.push_back(v);
        }
        return found;
    }

    /// Inserts the images that the pieces of `front` require, then the images that the new pieces
    /// require, until none is missing. Cells only shrink in the meantime, so each image needs to be
    /// examined only once.
    /// @returns false if more than `most` images would be inserted.
    bool flood(std::vector<Vertex> front, std::size_t most) {
        while (!front.empty()) {
            checkpoint();
            std::vector<Image> required;
            for (const Vertex v : front) require_images(v, required);
            if (mirrors_.size() > most) return false;
            front.clear();
            for (const Image& image : required) {
                const auto hint = front.empty() ? Euclidean::Face_handle() : front.back()->face();
                front.push_back(euclidean_.insert(image, hint));
            }
        }
        return true;
    }

    std::size_t n_triangles() const { return euclidean_.number_of_faces(); }
    int n_mirrors() const { return static_cast<int>(mirrors_.size()); }

    /// Counts the sites outside of `boundary` that have a mirror as a neighbour.
    int count_shrunk(const std::vector<Vertex>& boundary) const {
        std::set<SiteId> tagged;
        for (const Vertex v : boundary) tagged.insert(v->point().site);
        std::set<SiteId> shrunk;
        for (const Vertex v : euclidean_.finite_vertex_handles()) {
            if (v->point().offset == Offset{}) continue;
            for (const Vertex w : neighbours(v)) {
                const Image& q = w->point();
                if (q.offset == Offset{} && !tagged.contains(q.site)) shrunk.insert(q.site);
            }
        }
        return static_cast<int>(shrunk.size());
    }

    /// Returns the triangles in the order of their corners, the least corner of each first.
    std::vector<Triangle> triangles_of_domain() const {
        std::vector<Triangle> triangles;
        for (const auto face : euclidean_.finite_face_handles()) {
            const Image& p = face->vertex(0)->point();
            const Image& q = face->vertex(1)->point();
            const Image& r = face->vertex(2)->point();
            if (circumcentre_in_domain(gram_, p, q, r)) {
                Triangle& corners = triangles.emplace_back(Triangle{
                    Corner{p.site, p.offset}, Corner{q.site, q.offset}, Corner{r.site, r.offset}});
                std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                            corners.end());
            }
        }
        // The order of CGAL's faces follows that of the standard library's partial sorts.
        std::sort(triangles.begin(), triangles.end());
        return triangles;
    }

    std::vector<Piece> pieces() const {
        std::vector<Piece> pieces;
        for (const Vertex v : euclidean_.finite_vertex_handles()) {
            auto polygon = clipped_cell(v, square(0));
            const Image& p = v->point();
            if (polygon.size() >= 3) pieces.push_back({p.site, p.offset, std::move(polygon)});
        }
        std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
            return std::tie(p.site, p.offset) < std::tie(q.site, q.offset);
        });
        return pieces;
    }

   private:
    bool is_inner(Vertex v) const {
        if (euclidean_.dimension() < 2) return false;
        auto face = euclidean_.incident_faces(v);
        const auto first = face;
        do {
            if (euclidean_.is_infinite(face) ||
                !circumcentre_in_domain(gram_, face->vertex(0)->point(), face->vertex(1)->point(),
                                        face->vertex(2)->point())) {
                return false;
            }
        } while (++face != first);
        return true;
    }

    std::vector<Vertex> neighbours(Vertex v) const {
        std::vector<Vertex> found;
        if (euclidean_.dimension() < 1) return found;
        auto w = euclidean_.incident_vertices(v);
        const auto first = w;
        do {
            if (!euclidean_.is_infinite(w)) found.push_back(w);
        } while (++w != first);
        return found;
    }

    std::vector<Vec2> clipped_cell(Vertex v, std::vector<Vec2> polygon) const {
        for (const Vertex w : neighbours(v)) {
            polygon = clip_by_bisector(polygon, gram_, v->point(), w->point());
        }
        return polygon;
    }

    void require_images(Vertex v, std::vector<Image>& required) {
        std::set<Offset> domains;
        collect_neighbours(clipped_cell(v, square(kTouch)), domains);
        const Image& p = v->point();
        for (const Offset t : domains) {
            const Offset offset = p.offset - t;
            if (offset != Offset{} && mirrors_.insert({p.site, offset}).second) {
                required.push_back(image(sites_, p.site, offset));
            }
        }
    }

    const Sites& sites_;
    /// Is destroyed after the triangulation.
    ScopedBlocks blocks_;
    Gram gram_;
    Euclidean euclidean_;
    std::set<std::pair<SiteId, Offset>> mirrors_;
};

void require_torus(const Sites& sites, const MirrorDiagram& diagram) {
    if (diagram.triangles.size() != 2 * static_cast<std::size_t>(sites.n_sites())) {
        throw InternalError("the mirror diagram does not have 2 n triangles");
    }
}

std::optional<MirrorDiagram> diagram_within(const Sites& sites, WithPieces with_pieces,
                                            std::size_t most_mirrors) {
    Flooding flooding(sites);
    flooding.insert_sites();
    const auto boundary = flooding.boundary_sites();
    if (!flooding.flood(boundary, most_mirrors)) return std::nullopt;

    MirrorDiagram diagram;
    diagram.triangles = flooding.triangles_of_domain();
    diagram.n_mirrors = flooding.n_mirrors();
    diagram.n_boundary_sites = static_cast<int>(boundary.size());
    diagram.n_shrunk_inner_sites = flooding.count_shrunk(boundary);
    if (with_pieces == WithPieces::kYes) diagram.pieces = flooding.pieces();
    require_torus(sites, diagram);
    return diagram;
}

}  // namespace

MirrorDiagram mirror_diagram(const Sites& sites, WithPieces with_pieces) {
    return *diagram_within(sites, with_pieces, std::numeric_limits<std::size_t>::max());
}

std::optional<MirrorDiagram> mirror_diagram_within(const Sites& sites, int most_mirrors) {
    return diagram_within(sites, WithPieces::kNo, static_cast<std::size_t>(most_mirrors));
}

std::size_t euclidean_delaunay(const Sites& sites) {
    Flooding flooding(sites);
    flooding.insert_sites();
    return flooding.n_triangles();
}

MirrorDiagram full_copies_diagram(const Sites& sites, WithPieces with_pieces) {
    Flooding flooding(sites);
    flooding.insert_all_copies();

    MirrorDiagram diagram;
    diagram.triangles = flooding.triangles_of_domain();
    diagram.n_mirrors = 8 * sites.n_sites();
    if (with_pieces == WithPieces::kYes) diagram.pieces = flooding.pieces();
    require_torus(sites, diagram);
    return diagram;
}

}  // namespace pcvt::plane
