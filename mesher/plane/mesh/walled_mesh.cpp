#include "mesher/plane/mesh/walled_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// The image of a vertex between walls.
struct MeshCornerImage {
    int vertex;
    Offset offset;
};

/// The nearest wall or image of one, as a multiple of the domain's side.
double nearest_line(double coordinate, double side) { return std::round(coordinate / side) * side; }

/// The axis (0: x, 1: y) across which the wall of an edge lies.
int wall_axis(const Vec2& p, const Vec2& q, Walls walls) {
    if (walls != Walls::kXY) return walls == Walls::kX ? 0 : 1;
    const bool is_upright_edge = std::abs(q.x() - p.x()) < std::abs(q.y() - p.y());
    return is_upright_edge ? 0 : 1;
}

Vec2 middle_of(const PeriodicMesh& mesh, int f) {
    Vec2 sum(0, 0);
    for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) sum += mesh.point(c);
    return sum / (mesh.face_begin[f + 1] - mesh.face_begin[f]);
}

/// Divides cells along the walls across one axis.
class WallCut {
   public:
    WallCut(PeriodicMesh cells, int axis, double side)
        : cells_(std::move(cells)), axis_(axis), side_(side) {}

    PeriodicMesh cut() {
        sides_.assign(static_cast<std::size_t>(cells_.n_corners()), 0);
        bool any = false;
        for (int f = 0; f < cells_.n_faces(); ++f) {
            checkpoint_each(f);
            any = classify(f) || any;
        }
        if (!any) return std::move(cells_);
        result_ = {.lattice = cells_.lattice, .kind = cells_.kind, .vertices = cells_.vertices};
        for (int f = 0; f < cells_.n_faces(); ++f) {
            checkpoint_each(f);
            divide(f);
        }
        link_faces(result_);
        return std::move(result_);
    }

   private:
    struct Corner {
        int vertex;
        Offset offset;
        /// The side of the wall on which the corner lies: -1 or 1, 0 on the wall.
        int side;
    };

    /// Whether the site of a cell lies on a wall.
    bool on_wall(int f) const {
        const double at = cells_.site_points[f][axis_];
        return std::abs(at - nearest_line(at, side_)) <= kRounding * side_;
    }

    /// Finds on which side of the wall each corner of a cell lies whose site is on the wall. Such
    /// cells are symmetric, so that only rounding errors move a corner off the wall.
    /// @returns whether the site lies on a wall.
    bool classify(int f) {
        if (!on_wall(f)) return false;
        const double line = nearest_line(cells_.site_points[f][axis_], side_);
        double reach = 0;
        for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
            reach = std::max(reach, std::abs(cells_.point(c)[axis_] - line));
        }
        for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
            const double off = cells_.point(c)[axis_] - line;
            sides_[c] = std::abs(off) <= kOnLine * reach ? 0 : (off > 0 ? 1 : -1);
            if (sides_[c] == 0) {
                const double shift = cells_.lattice.translation(cells_.corner_offset[c])[axis_];
                cells_.vertices[cells_.corner_vertex[c]][axis_] = line - shift;
            }
        }
        return true;
    }

    /// The vertex at which the edge of c crosses the wall at `line`, in the frame of c's face.
    Corner crossing(int c, double line) {
        const int o = cells_.opposite[c];
        const auto known = crossings_.find(o);
        if (known != crossings_.end()) {
            return {known->second, -cells_.frame_across(o), 0};
        }
        const Vec2 p = cells_.point(c);
        const Vec2 q = cells_.point(cells_.next(c));
        const double t = (line - p[axis_]) / (q[axis_] - p[axis_]);
        Vec2 at = p + t * (q - p);
        at[axis_] = line;
        crossings_[c] = result_.n_vertices();
        result_.vertices.push_back(at);
        return {crossings_[c], {}, 0};
    }

    void divide(int f) {
        std::vector<Corner> corners;
        const bool is_cut = on_wall(f);
        const double line = is_cut ? nearest_line(cells_.site_points[f][axis_], side_) : 0;
        for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
            corners.push_back({cells_.corner_vertex[c], cells_.corner_offset[c], sides_[c]});
            const int after = sides_[cells_.next(c)];
            if (is_cut && sides_[c] * after < 0) corners.push_back(crossing(c, line));
        }
        if (!is_cut) return add(corners, f);
        for (const int side : {-1, 1}) {
            std::vector<Corner> part;
            for (const Corner& corner : corners) {
                if (corner.side * side >= 0) part.push_back(corner);
            }
            if (part.size() >= 3) add(part, f);
        }
    }

    void add(const std::vector<Corner>& corners, int f) {
        for (const Corner& corner : corners) {
            result_.corner_vertex.push_back(corner.vertex);
            result_.corner_offset.push_back(corner.offset);
        }
        result_.face_begin.push_back(result_.n_corners());
        result_.site.push_back(cells_.site[f]);
        result_.site_points.push_back(cells_.site_points[f]);
    }

    /// Bounds the rounding of a site on a wall, in units of the domain's side.
    static constexpr double kRounding = 1e-12;
    /// Corners nearer to the wall than this lie on it, in units of the cell's reach.
    static constexpr double kOnLine = 1e-7;

    PeriodicMesh cells_;
    int axis_;
    double side_;
    /// Per corner.
    std::vector<int> sides_;
    PeriodicMesh result_{.lattice = Lattice::rectangle(1, 1), .kind = MeshKind::kVoronoi};
    /// The vertices of edges that cross a wall, by the corner from which they were found.
    std::map<int, int> crossings_;
};

/// Puts the vertices of walls on their lines to the last bit.
void put_on_lines(PeriodicMesh& between, const WalledDomain& domain) {
    for (int c = 0; c < between.n_corners(); ++c) {
        checkpoint_each(c);
        if (between.opposite[c] >= 0) continue;
        const WallSideRow& wall = wall_side_of(between, c, domain);
        for (const int end : {c, between.next(c)}) {
            between.vertices[between.corner_vertex[end]][wall.axis] =
                wall_line(wall, domain.lattice);
        }
    }
}

/// The translation that moves a coordinate between the walls of a torus of two sides.
int shift_between_walls(double coordinate, double side) {
    return -static_cast<int>(std::floor(coordinate / (2 * side)));
}

}  // namespace

PeriodicMesh cut_along_walls(PeriodicMesh cells, const WalledDomain& domain) {
    if (domain.n_on_walls == 0) return cells;
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(domain.walls, axis)) continue;
        cells = WallCut(std::move(cells), axis, side_length(domain.lattice, axis)).cut();
    }
    return cells;
}

std::vector<std::optional<Offset>> places_between_walls(const PeriodicMesh& mesh,
                                                        const WalledDomain& domain) {
    std::vector<std::optional<Offset>> places;
    places.reserve(static_cast<std::size_t>(mesh.n_faces()));
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        Vec2 middle = middle_of(mesh, f);
        std::array<int, 2> offset{0, 0};
        bool inside = true;
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(domain.walls, axis)) continue;
            const double side = side_length(domain.lattice, axis);
            offset[axis] = shift_between_walls(middle[axis], side);
            inside = inside && middle[axis] + offset[axis] * 2 * side < side;
        }
        places.push_back(inside ? std::optional(Offset{offset[0], offset[1]}) : std::nullopt);
    }
    return places;
}

void move_onto_walls(PeriodicMesh& mesh, const std::vector<std::optional<Offset>>& places,
                     const WalledDomain& domain) {
    for (int c = 0; c < mesh.n_corners(); ++c) {
        checkpoint_each(c);
        if (!places[mesh.corner_face[c]]) continue;
        if (places[mesh.corner_face[mesh.opposite[c]]]) continue;
        const Vec2 p = mesh.point(c);
        const Vec2 q = mesh.point(mesh.next(c));
        const int axis = wall_axis(p, q, domain.walls);
        const double side = side_length(domain.lattice, axis);
        const double line = nearest_line((p[axis] + q[axis]) / 2, side);
        for (const int end : {c, mesh.next(c)}) {
            const double shift = mesh.lattice.translation(mesh.corner_offset[end])[axis];
            mesh.vertices[mesh.corner_vertex[end]][axis] = line - shift;
        }
    }
}

PeriodicMesh mesh_between_walls(const PeriodicMesh& mesh,
                                const std::vector<std::optional<Offset>>& places,
                                const WalledDomain& domain) {
    PeriodicMesh part{.lattice = domain.lattice, .kind = mesh.kind};
    std::vector<int> new_corner(static_cast<std::size_t>(mesh.n_corners()), -1);
    std::vector<int> new_vertex(mesh.vertices.size(), -1);
    const bool keeps_x = !has_walls_across(domain.walls, 0);
    const bool keeps_y = !has_walls_across(domain.walls, 1);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        if (!places[f]) continue;
        const Offset place = *places[f];
        for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const Offset at = place + mesh.corner_offset[c];
            int& v = new_vertex[mesh.corner_vertex[c]];
            if (v < 0) {
                v = part.n_vertices();
                const Offset across{keeps_x ? 0 : at.i, keeps_y ? 0 : at.j};
                part.vertices.push_back(mesh.vertices[mesh.corner_vertex[c]] +
                                        mesh.lattice.translation(across));
                if (!faces_have_sites(mesh.kind)) {
                    part.site.push_back(mesh.site[mesh.corner_vertex[c]]);
                }
            }
            new_corner[c] = part.n_corners();
            part.corner_vertex.push_back(v);
            part.corner_offset.push_back({keeps_x ? at.i : 0, keeps_y ? at.j : 0});
            part.corner_face.push_back(part.n_faces());
        }
        part.face_begin.push_back(part.n_corners());
        const auto k = static_cast<std::size_t>(f);
        if (faces_have_sites(mesh.kind)) part.site.push_back(mesh.site[k]);
        if (k < mesh.site_points.size()) {
            part.site_points.push_back(mesh.site_points[k] + mesh.lattice.translation(place));
        }
        if (k < mesh.whole_sides.size()) part.whole_sides.push_back(mesh.whole_sides[k]);
    }
    for (int c = 0; c < mesh.n_corners(); ++c) {
        checkpoint_each(c);
        if (new_corner[c] >= 0) part.opposite.push_back(new_corner[mesh.opposite[c]]);
    }
    put_on_lines(part, domain);
    return part;
}

PeriodicMesh part_between_walls(PeriodicMesh torus, const WalledDomain& domain) {
    if (torus.kind == MeshKind::kVoronoi) torus = cut_along_walls(std::move(torus), domain);
    const auto places = places_between_walls(torus, domain);
    move_onto_walls(torus, places, domain);
    return mesh_between_walls(torus, places, domain);
}

PeriodicMesh mirrored_mesh(PeriodicMesh between, const WalledDomain& domain) {
    PeriodicMesh torus = std::move(between);
    torus.lattice = mirrored_lattice(domain.lattice, domain.walls);
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(domain.walls, axis)) continue;
        const double side = side_length(domain.lattice, axis);
        const Offset back{axis == 0 ? -1 : 0, axis == 0 ? 0 : -1};
        const auto image = [axis](Vec2 p) {
            p[axis] = p[axis] == 0 ? 0 : -p[axis];
            return p;
        };
        const int n_vertices = torus.n_vertices();
        std::vector<MeshCornerImage> images;
        for (int v = 0; v < n_vertices; ++v) {
            checkpoint_each(v);
            const double at = torus.vertices[v][axis];
            if (at == 0 || at == side) {
                images.push_back({v, at == 0 ? Offset{} : back});
            } else {
                images.push_back({torus.n_vertices(), {}});
                torus.vertices.push_back(image(torus.vertices[v]));
            }
        }
        for (int f = 0, n_faces = torus.n_faces(); f < n_faces; ++f) {
            checkpoint_each(f);
            for (int c = torus.face_begin[f + 1] - 1; c >= torus.face_begin[f]; --c) {
                const MeshCornerImage& corner = images[torus.corner_vertex[c]];
                torus.corner_vertex.push_back(corner.vertex);
                torus.corner_offset.push_back(corner.offset + torus.corner_offset[c]);
            }
            torus.face_begin.push_back(static_cast<int>(torus.corner_vertex.size()));
            torus.site.push_back(torus.site[f]);
            torus.site_points.push_back(image(torus.site_points[f]));
            if (!torus.whole_sides.empty()) torus.whole_sides.push_back(torus.whole_sides[f]);
        }
    }
    link_faces(torus);
    return torus;
}

const WallSideRow& wall_side_of(const PeriodicMesh& mesh, int c, const WalledDomain& domain) {
    const Vec2 p = mesh.point(c);
    const Vec2 q = mesh.point(mesh.next(c));
    const int axis = wall_axis(p, q, domain.walls);
    const bool at_end = p[axis] + q[axis] > side_length(domain.lattice, axis);
    return *find_row(kWallSides, [axis, at_end](const WallSideRow& row) {
        return row.axis == axis && row.at_end == at_end;
    });
}

}  // namespace pcvt::plane
