#include "mesher/space/delaunay/mirror_diagram.hpp"

// CGAL's containers lose a block if the memory for their list of blocks runs out.
#include "mesher/base/scoped_blocks.hpp"
#define CGAL_ALLOCATOR(T) pcvt::ScopedAllocator<T>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_vertex_base_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/delaunay/image_search.hpp"
#include "mesher/space/geometry/unspoilt_thread.hpp"

namespace pcvt::space {
namespace {

/// Makes CGAL triangulate images with the predicates of predicates.hpp. CGAL breaks ties by
/// the lexicographic order of the points, as violates_delaunay() does.
struct Traits {
    using Point_3 = Image;
    struct Segment_3 {};
    struct Triangle_3 {};
    struct Tetrahedron_3 {};
    struct Line_3 {};
    struct Ray_3 {};
    struct Object_3 {};
    struct Construct_point_3 {
        const Image& operator()(const Image& p) const { return p; }
    };
    struct Construct_segment_3 {};
    struct Construct_triangle_3 {};
    struct Construct_tetrahedron_3 {};
    template <int axis>
    struct Less {
        bool operator()(const Image& p, const Image& q) const { return p.at[axis] < q.at[axis]; }
    };
    using Less_x_3 = Less<0>;
    using Less_y_3 = Less<1>;
    using Less_z_3 = Less<2>;
    struct Compare_xyz_3 {
        CGAL::Comparison_result operator()(const Image& p, const Image& q) const {
            if (is_lexicographically_less(p, q)) return CGAL::SMALLER;
            return is_lexicographically_less(q, p) ? CGAL::LARGER : CGAL::EQUAL;
        }
    };
    struct Orientation_3 {
        CGAL::Orientation operator()(const Image& p, const Image& q, const Image& r,
                                     const Image& s) const {
            return CGAL::Orientation(orientation(p, q, r, s));
        }
    };
    struct Coplanar_orientation_3 {
        /// In the first projection in which p, q and r are not collinear.
        CGAL::Orientation operator()(const Image& p, const Image& q, const Image& r) const {
            int turn = 0;
            for (int axis = 2; axis >= 0 && turn == 0; --axis) {
                turn = projected_orientation(axis, p, q, r);
            }
            return CGAL::Orientation(turn);
        }
    };
    struct Side_of_oriented_sphere_3 {
        Gram gram;
        CGAL::Oriented_side operator()(const Image& p, const Image& q, const Image& r,
                                       const Image& s, const Image& t) const {
            checkpoint();
            return CGAL::Oriented_side(in_sphere(gram, p, q, r, s, t));
        }
    };
    struct Coplanar_side_of_bounded_circle_3 {
        Gram gram;
        CGAL::Bounded_side operator()(const Image& p, const Image& q, const Image& r,
                                      const Image& t) const {
            return CGAL::Bounded_side(in_coplanar_circle(gram, p, q, r, t));
        }
    };
    struct Compare_distance_3 {
        Gram gram;
        CGAL::Comparison_result operator()(const Image& p, const Image& q, const Image& r) const {
            const auto distance = [&](const Image& x) {
                const Vec3 d = x.at - p.at;
                return gram.squared_length(d.x(), d.y(), d.z());
            };
            return CGAL::compare(distance(q), distance(r));
        }
    };

    Construct_point_3 construct_point_3_object() const { return {}; }
    Less_x_3 less_x_3_object() const { return {}; }
    Less_y_3 less_y_3_object() const { return {}; }
    Less_z_3 less_z_3_object() const { return {}; }
    Compare_xyz_3 compare_xyz_3_object() const { return {}; }
    Orientation_3 orientation_3_object() const { return {}; }
    Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }
    Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {gram}; }
    Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const {
        return {gram};
    }
    Compare_distance_3 compare_distance_3_object() const { return {gram}; }

    Gram gram{};
};

using Cells =
    CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Traits>,
                                         CGAL::Delaunay_triangulation_cell_base_3<Traits>>;
using Euclidean = CGAL::Delaunay_triangulation_3<Traits, Cells>;
using Vertex = Euclidean::Vertex_handle;
using Cell = Euclidean::Cell_handle;

/// The width of the first band in units of h: the total time has a flat minimum here.
constexpr double kBand = 0.8;
/// Spheres count as larger by this factor: a superfluous image does no harm, a missing one does.
constexpr double kRounding = 1 + 1e-9;
/// A cell lies within one period of its site, so neighbouring sites are less than two away.
constexpr double kNeighbours = 2;

bool in_domain(const Corner& corner) { return corner.offset == Offset{}; }

/// The Euclidean triangulation of the sites and a growing set of their images.
class Flooding {
   public:
    explicit Flooding(const Sites& sites)
        : sites_(sites), images_(sites), euclidean_(Traits{images_.gram()}) {}

    /// Inserts the images in the domain widened by `band` (reduced coordinates).
    void insert_band(const Vec3& band) {
        band_ = band;
        const int reach = int(std::ceil(band.maxCoeff()));
        std::vector<Image> images;
        for (SiteId s = 0; s < sites_.n_sites(); ++s) {
            checkpoint_each(s);
            for_each_offset(reach, [&](Offset offset) {
                const Corner corner{s, offset};
                if (in_band(corner)) images.push_back(image(sites_.coordinates(), corner));
            });
        }
        euclidean_.insert(images.begin(), images.end());
    }

    /// Inserts images until the stars of the sites in the domain are right.
    void flood() {
        if (euclidean_.dimension() < 3) insert({required_neighbours({0, {}})});
        std::set<Corner> required;
        for (const Cell cell : euclidean_.all_cell_handles()) require_images(cell, required);
        while (!required.empty()) {
            const std::vector<Vertex> inserted = insert({required});
            required.clear();
            std::vector<Cell> cells;
            for (const Vertex v : inserted) {
                cells.clear();
                euclidean_.incident_cells(v, std::back_inserter(cells));
                for (const Cell cell : cells) require_images(cell, required);
            }
        }
    }

    Vec3 first_band() const { return (kBand * images_.spacing() * images_.extent()).cwiseMin(1); }
    std::size_t n_tetrahedra() const { return euclidean_.number_of_finite_cells(); }
    int n_mirrors() const {
        return static_cast<int>(euclidean_.number_of_vertices()) - sites_.n_sites();
    }

    /// One tetrahedron of each orbit at a site of the domain.
    std::vector<Tetrahedron> tetrahedra_of_domain() const {
        std::vector<Tetrahedron> tetrahedra;
        if (euclidean_.dimension() < 3) return tetrahedra;
        for (const Cell cell : euclidean_.finite_cell_handles()) {
            Tetrahedron corners;
            for (int k = 0; k < 4; ++k) corners[k] = cell->vertex(k)->point().name;
            const Corner least = *std::min_element(corners.begin(), corners.end());
            if (in_domain(least)) tetrahedra.push_back(corners);
        }
        // The order of CGAL's cells follows that of the standard library's partial sorts.
        put_in_canonical_order(sites_.n_sites(), tetrahedra);
        return tetrahedra;
    }

    /// Whether the tetrahedra fill the torus once and those across its seam are Delaunay; CGAL
    /// vouches for the others.
    bool is_torus(const std::vector<Tetrahedron>& tetrahedra) const;

   private:
    template <class Visit>
    static void for_each_offset(int reach, const Visit& visit) {
        for (int i = -reach; i <= reach; ++i) {
            for (int j = -reach; j <= reach; ++j) {
                for (int k = -reach; k <= reach; ++k) visit(Offset{i, j, k});
            }
        }
    }

    bool in_band(const Corner& corner) const {
        const Vec3 at = image(sites_.coordinates(), corner).at;
        return ((at + band_).array() >= 0).all() && ((at - band_).array() < 1).all();
    }
    bool is_missing(const Corner& corner) const {
        return !in_band(corner) && !mirrors_.contains(corner);
    }

    std::set<Corner> required_neighbours(const Corner& corner) const {
        std::set<Corner> required;
        for_each_offset(1, [&](Offset offset) {
            const Corner other{corner.site, offset};
            if (is_missing(other)) required.insert(other);
        });
        return required;
    }

    std::vector<Vertex> insert(const std::set<Corner>& required) {
        std::vector<Vertex> inserted;
        for (const Corner& corner : required) {
            mirrors_.insert(corner);
            const Cell hint = inserted.empty() ? Cell() : inserted.back()->cell();
            inserted.push_back(euclidean_.insert(image(sites_.coordinates(), corner), hint));
        }
        return inserted;
    }

    /// Adds the images that the cell requires, at most one unless the cell reaches beyond the
    /// neighbours of a site.
    void require_images(Cell cell, std::set<Corner>& required) const {
        const Image* at_domain = nullptr;
        for (int k = 0; k < 4; ++k) {
            if (euclidean_.is_infinite(cell->vertex(k))) continue;
            const Image& p = cell->vertex(k)->point();
            if (in_domain(p.name)) at_domain = &p;
        }
        if (at_domain == nullptr) return;
        if (!euclidean_.is_infinite(cell)) {
            const Vec3 to_centre = centre_from(*at_domain, cell);
            // The cell of a site among its own images lies within one period of it.
            if (to_centre.cwiseAbs().maxCoeff() <= 1) {
                require_in_sphere(*at_domain, to_centre, required);
                return;
            }
        }
        required.merge(required_neighbours(at_domain->name));
    }

    Vec3 centre_from(const Image& origin, Cell cell) const {
        const auto corner = [&](int k) -> const Image& { return cell->vertex(k)->point(); };
        const Vec3 centre =
            corner(0).at + circumcentre(images_.gram(), corner(0), corner(1), corner(2), corner(3));
        return centre - origin.at;
    }

    void require_in_sphere(const Image& origin, const Vec3& to_centre,
                           std::set<Corner>& required) const {
        const double radius = kRounding * std::sqrt(images_.gram().squared_length(
                                              to_centre.x(), to_centre.y(), to_centre.z()));
        const Vec3 centre = origin.at + to_centre;
        const Vec3 reach = radius * images_.extent() + band_ * (1 - kRounding);
        if (((centre - reach + band_).array() >= 0).all() &&
            ((centre + reach - band_).array() < 1).all()) {
            return;
        }
        const Corner nearest = images_.nearest(
            centre, radius, [this](const Corner& corner) { return is_missing(corner); });
        if (nearest.site >= 0) required.insert(nearest);
    }

    const Sites& sites_;
    /// Is destroyed after the triangulation.
    ScopedBlocks blocks_;
    ImageSearch images_;
    Euclidean euclidean_;
    Vec3 band_ = Vec3::Zero();
    /// The images outside of the band that are inserted.
    std::set<Corner> mirrors_;
};

bool Flooding::is_torus(const std::vector<Tetrahedron>& tetrahedra) const {
    const auto opposite = match_facets(sites_.n_sites(), tetrahedra);
    if (!opposite) return false;
    const auto at = [&](const Corner& corner) { return image(sites_.coordinates(), corner); };
    double volume = 0;
    for (const Tetrahedron& t : tetrahedra) {
        const Vec3 p = at(t[0]).at;
        volume += (at(t[1]).at - p).dot((at(t[2]).at - p).cross(at(t[3]).at - p));
    }
    // Six times the volume in units of the domain: any other number of sheets differs by 6.
    return std::abs(volume - 6) < 1;
}

MirrorDiagram result_of(const Flooding& flooding) {
    return {flooding.tetrahedra_of_domain(), flooding.n_mirrors()};
}

MirrorDiagram full_copies(const Sites& sites) {
    Flooding flooding(sites);
    flooding.insert_band(Vec3::Constant(kNeighbours));
    MirrorDiagram result = result_of(flooding);
    if (!flooding.is_torus(result.tetrahedra)) {
        throw InternalError("the tetrahedra of the mirrors do not fill the torus");
    }
    return result;
}

MirrorDiagram mirrors(const Sites& sites) {
    Flooding flooding(sites);
    flooding.insert_band(flooding.first_band());
    flooding.flood();
    MirrorDiagram result = result_of(flooding);
    if (flooding.is_torus(result.tetrahedra)) return result;
    return full_copies(sites);
}

}  // namespace

MirrorDiagram mirror_diagram(const Sites& sites) {
    MirrorDiagram result;
    run_in_unspoilt_thread([&] { result = mirrors(sites); });
    return result;
}

MirrorDiagram full_copies_diagram(const Sites& sites) {
    MirrorDiagram result;
    run_in_unspoilt_thread([&] { result = full_copies(sites); });
    return result;
}

std::size_t euclidean_tetrahedra(const Sites& sites) {
    Flooding flooding(sites);
    flooding.insert_band(Vec3::Zero());
    return flooding.n_tetrahedra();
}

}  // namespace pcvt::space
