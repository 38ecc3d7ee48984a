#include "mesher/finite_volume/extruded_base.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kPlanes = "(1) of extruded meshes, planes";
const char* const kOrder = "(2) of extruded meshes, faces";
const char* const kSeams = "(3) of extruded meshes, seam";
const char* const kWallPatches = "(4) of extruded meshes, walls";

/// A stored translation must agree with the lattice up to this many ulps.
constexpr double kTranslationUlps = 4;

void require_planes(const FiniteVolumeMesh& extruded) {
    const int above = extruded.n_points() / 2;
    if (above == 0 || extruded.n_points() % 2 != 0)
        throw_violation(kPlanes, "the number of points is odd or 0");
    const double thickness = extruded.points[above].z();
    if (!(thickness > 0)) throw_violation(kPlanes, "the extruded mesh has no thickness");
    for (int v = 0; v < above; ++v) {
        const Eigen::Vector3d& low = extruded.points[v];
        const Eigen::Vector3d& high = extruded.points[v + above];
        if (low.z() == 0 && high.z() == thickness && low.head<2>() == high.head<2>()) continue;
        throw_violation(
            kPlanes, "point " + to_string(v + above) + " does not lie above point " + to_string(v));
    }
}

const FiniteVolumePatch& patch_named(const FiniteVolumeMesh& extruded, std::string_view name) {
    for (const FiniteVolumePatch& patch : extruded.patches) {
        if (patch.name == name && patch.partner < 0) return patch;
    }
    throw_violation(kOrder, "there is no empty patch " + std::string(name));
}

/// Whether `lid` has the points above the points of `face`, in the same cyclic order.
bool stands_above(std::span<const int> lid, const std::vector<int>& face, int above) {
    const auto first = std::find(lid.begin(), lid.end(), face.front() + above);
    const auto above_it = [&](int q, int p) { return q == p + above; };
    return lid.size() == face.size() && first != lid.end() &&
           std::equal(first, lid.end(), face.begin(), above_it) &&
           std::equal(lid.begin(), first, face.end() - (first - lid.begin()), above_it);
}

/// Returns for each cell its one face in the patch, a lid of its prism.
std::vector<int> lids(const FiniteVolumeMesh& extruded, const FiniteVolumePatch& patch) {
    std::vector<int> lid(static_cast<std::size_t>(patch.n_faces), -1);
    for (int f = patch.first_face; f < patch.first_face + patch.n_faces; ++f) {
        const int cell = extruded.owner[f];
        if (cell >= patch.n_faces || lid[cell] >= 0) {
            throw_violation(kOrder,
                            "patch " + patch.name + " does not have exactly one face per cell");
        }
        lid[cell] = f;
    }
    return lid;
}

void read_faces(const FiniteVolumeMesh& extruded, plane::Tile& tile) {
    const int above = extruded.n_points() / 2;
    // Find the two lids of each cell.
    const std::vector<int> back = lids(extruded, patch_named(extruded, kBackPatch));
    const std::vector<int> front = lids(extruded, patch_named(extruded, kFrontPatch));
    const int n_cells = last_cell(extruded) + 1;
    if (back.size() != front.size() || static_cast<int>(back.size()) != n_cells) {
        throw_violation(kOrder, "back and front have " + to_string(back.size()) + " and " +
                                    to_string(front.size()) + " faces for " + to_string(n_cells) +
                                    " cells");
    }
    // Read each face from the back lid and compare the front lid with it.
    std::vector<int> face;
    for (std::size_t cell = 0; cell < back.size(); ++cell) {
        checkpoint_each(cell);
        const std::span<const int> points = extruded.faces[back[cell]];
        if (points.size() < 3)
            throw_violation(kPlanes, "a face of the back has fewer than 3 points");
        face.assign(points.begin(), points.end());
        std::reverse(face.begin() + 1, face.end());
        const bool low = std::all_of(face.begin(), face.end(), [&](int p) { return p < above; });
        if (!low || !stands_above(extruded.faces[front[cell]], face, above)) {
            throw_violation(kPlanes,
                            "cell " + to_string(cell) + " is not a prism between back and front");
        }
        tile.faces.add(face);
    }
}

/// The side of the tile under an upright face. It runs from v to w with the face's owner on its
/// left. `from_v` states whether the face's first point is v rather than w.
struct Foot {
    int v;
    int w;
    bool from_v;
};

Foot foot_of(const FiniteVolumeMesh& extruded, int f) {
    const int above = extruded.n_points() / 2;
    if (extruded.faces.size(f) == 4) {
        std::array<int, 4> p{};
        std::copy_n(extruded.faces[f].begin(), 4, p.begin());
        if (p[0] < above && p[2] == p[1] + above && p[3] == p[0] + above) {
            return {p[0], p[1], true};
        }
        if (p[3] < above && p[1] == p[0] + above && p[2] == p[3] + above) {
            return {p[3], p[0], false};
        }
    }
    throw_violation(kPlanes,
                    "face " + to_string(f) + " is not an upright face that begins at the back");
}

/// Records which sides of the tile have a face above them.
class CoveredSides {
   public:
    explicit CoveredSides(const plane::Tile& tile)
        : tile_(tile), covered_(tile.faces.corners.size(), false) {}

    /// @param f  the face above the side, for the message.
    void cover(int cell, int v, int w, int f) {
        int from = tile_.faces[cell].back();
        for (int c = tile_.faces.begin[cell]; c < tile_.faces.begin[cell + 1]; ++c) {
            if (from == v && tile_.faces.corners[c] == w && !covered_[c]) {
                covered_[c] = true;
                return;
            }
            from = tile_.faces.corners[c];
        }
        throw_violation(kOrder, "face " + to_string(f) + " does not lie on a free side of cell " +
                                    to_string(cell) + ", or its normal points inwards");
    }

    void require_all() const {
        const auto missing = std::find(covered_.begin(), covered_.end(), false);
        if (missing == covered_.end()) return;
        throw_violation(kOrder, "a cell is open: no face lies on the side that ends at point " +
                                    to_string(tile_.faces.corners[missing - covered_.begin()]));
    }

   private:
    const plane::Tile& tile_;
    std::vector<bool> covered_;
};

void require_translation(const FiniteVolumePatch& patch, const plane::Lattice& lattice) {
    const auto offset = patch.offset_as<plane::Offset>();
    const plane::Vec2 translation = lattice.translation(offset);
    const double allowed = kTranslationUlps * std::numeric_limits<double>::epsilon() *
                           translation.cwiseAbs().maxCoeff();
    if (patch.name != seam_name(offset) || offset == plane::Offset{} ||
        !((patch.separation.head<2>() - translation).cwiseAbs().maxCoeff() <= allowed)) {
        throw_violation(kSeams, "patch " + patch.name + " states a separation other than " +
                                    offset_in_words(offset));
    }
}

/// Appends the edge pairs under a patch and its partner, seen from the patch with the positive
/// offset.
void read_seam(const FiniteVolumeMesh& extruded, const FiniteVolumePatch& patch,
               plane::Tile& tile) {
    const FiniteVolumePatch& partner = extruded.patches[patch.partner];
    const auto offset = patch.offset_as<plane::Offset>();
    if (partner.partner != &patch - extruded.patches.data() ||
        partner.offset_as<plane::Offset>() != -offset || partner.n_faces != patch.n_faces) {
        throw_violation(
            kSeams, "patches " + patch.name + " and " + partner.name + " do not match each other");
    }
    require_translation(patch, tile.lattice);
    if (offset < plane::Offset{}) return;
    for (int k = 0; k < patch.n_faces; ++k) {
        const Foot here = foot_of(extruded, patch.first_face + k);
        const Foot there = foot_of(extruded, partner.first_face + k);
        if (here.from_v == there.from_v) {
            throw_violation(kSeams, "faces " + to_string(patch.first_face + k) + " and " +
                                        to_string(partner.first_face + k) +
                                        " do not begin at matching points");
        }
        tile.edge_pairs.push_back(
            {.v0 = here.v, .v1 = here.w, .w0 = there.w, .w1 = there.v, .offset = offset});
    }
}

/// Requires that the edges under a patch of a side of the domain lie there exactly.
void require_on_side(const FiniteVolumePatch& patch, const WallSideRow& row,
                     const std::vector<Foot>& feet, const plane::Tile& tile) {
    if (!is_upright(tile.lattice)) {
        throw_violation(kWallPatches, "walls need the period vectors (width, 0) and (0, height)");
    }
    const double line = wall_line(row, tile.lattice);
    for (std::size_t k = 0; k < feet.size(); ++k) {
        if (tile.points[feet[k].v][row.axis] == line && tile.points[feet[k].w][row.axis] == line) {
            continue;
        }
        throw_violation(kWallPatches, "face " + to_string(patch.first_face + static_cast<int>(k)) +
                                          " lies off its patch " + patch.name);
    }
}

/// Appends the edges under a patch of a wall. One with the name of a side of the domain lies there;
/// any other one is a hole.
void read_wall(const FiniteVolumeMesh& extruded, const FiniteVolumePatch& patch,
               plane::Tile& tile) {
    if (patch.partner >= 0) {
        throw_violation(kWallPatches, "patch " + patch.name + " is a wall and has a partner");
    }
    std::vector<Foot> feet;
    for (int f = patch.first_face; f < patch.end_face(); ++f) feet.push_back(foot_of(extruded, f));
    const WallSideRow* const row = find_wall_side(patch.name);
    if (row != nullptr) {
        require_on_side(patch, *row, feet, tile);
    } else {
        tile.holes.push_back(patch.name);
    }
    const plane::WallId wall = row != nullptr
                                   ? plane::WallId::side(row->side)
                                   : plane::WallId::hole(static_cast<int>(tile.holes.size()) - 1);
    for (const Foot& foot : feet) tile.wall_edges.push_back({wall, foot.v, foot.w});
}

/// Returns the walls on which edges lie, and sorts these.
Walls walls_of(plane::Tile& tile) {
    std::sort(tile.wall_edges.begin(), tile.wall_edges.end());
    std::array<bool, kWallSides.size()> found{};
    for (const plane::WallEdge& edge : tile.wall_edges) {
        if (!edge.wall.is_hole()) found[static_cast<std::size_t>(edge.wall.number)] = true;
    }
    for (const WallsRow& row : kWalls) {
        if (std::all_of(kWallSides.begin(), kWallSides.end(), [&](const WallSideRow& side) {
                return found[static_cast<std::size_t>(side.side)] == row.across[side.axis];
            })) {
            return row.walls;
        }
    }
    throw_violation(kWallPatches, "there is a wall without the one opposite to it");
}

}  // namespace

plane::Tile extruded_base(const FiniteVolumeMesh& extruded, const plane::Lattice& lattice,
                          plane::MeshKind kind) {
    // Check indices, patches, order and planes.
    require_face_order(extruded, kOrder);
    require_planes(extruded);
    // Read the faces of the tile.
    plane::Tile tile{.lattice = lattice, .kind = kind};
    for (int v = 0; v < extruded.n_points() / 2; ++v)
        tile.points.emplace_back(extruded.points[v].head<2>());
    read_faces(extruded, tile);
    // Match each upright face with a side of the tile, and read the seam and the walls.
    CoveredSides sides(tile);
    for (int f = 0; f < extruded.n_inner_faces(); ++f) {
        checkpoint_each(f);
        const Foot foot = foot_of(extruded, f);
        sides.cover(extruded.owner[f], foot.v, foot.w, f);
        sides.cover(extruded.neighbour[f], foot.w, foot.v, f);
    }
    for (const FiniteVolumePatch& patch : extruded.patches) {
        const bool is_wall = patch.kind == PatchKind::kWall;
        if (patch.partner < 0 && !is_wall) continue;
        for (int f = patch.first_face; f < patch.end_face(); ++f) {
            const Foot foot = foot_of(extruded, f);
            sides.cover(extruded.owner[f], foot.v, foot.w, f);
        }
        if (is_wall) {
            read_wall(extruded, patch, tile);
        } else {
            read_seam(extruded, patch, tile);
        }
    }
    sides.require_all();
    tile.walls = walls_of(tile);
    return tile;
}

}  // namespace pcvt
