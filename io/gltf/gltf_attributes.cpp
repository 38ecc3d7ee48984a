#include "io/gltf/gltf_attributes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {
namespace {

/// Texture coordinates are compared within this many ulps of the largest, and of positions.
constexpr double kTextureUlps = 4;
/// Lines this many ulps of the largest coordinate long may be missing.
constexpr double kShortUlps = 64;

[[noreturn]] void throw_bad(const GltfDocument& document, const std::string& complaint) {
    document.throw_bad_file(complaint + "; write the file again with pcvt");
}

std::vector<float> attribute(const GltfDocument& document, const Json& primitive,
                             const std::string& key, std::size_t width, std::size_t n) {
    const Json& attributes = GltfDocument::member(primitive, "attributes");
    std::vector<float> numbers = document.floats(document.count_in(attributes, key), width);
    if (numbers.size() == n * width) return numbers;
    throw_bad(document, "there is not one " + key + " for each vertex");
}

/// Whether two primitives name the same accessors.
bool same_accessors(const Json& attributes, const Json& others) {
    if (attributes.size() != others.size()) return false;
    for (const JsonMember& member : attributes.members()) {
        const Json* other = others.find(member.name);
        if (other == nullptr || !(*other == member.value.get<std::size_t>())) return false;
    }
    return true;
}

void require_flat(const GltfDocument& document, const Json& primitive, const plane::Tile& tile) {
    const auto points = attribute(document, primitive, "POSITION", 3, tile.points.size());
    const auto normals = attribute(document, primitive, "NORMAL", 3, tile.points.size());
    for (std::size_t v = 0; v < tile.points.size(); ++v) {
        checkpoint_each(v);
        const float* normal = &normals[3 * v];
        if (points[3 * v + 2] == 0 && normal[0] == 0 && normal[1] == 0 && normal[2] == 1) continue;
        throw_bad(document,
                  "vertex " + std::to_string(v) + " has z or a normal that is not upright");
    }
}

/// Returns how far the coordinates u and v in a file may be from those of its rounded vertices.
plane::Vec2 texture_rounding(const plane::Tile& tile,
                             const std::vector<plane::TextureCoordinate>& wanted) {
    constexpr double kEpsilon = std::numeric_limits<float>::epsilon();
    float largest = 1;
    for (const auto& [u, v] : wanted) largest = std::max({largest, std::abs(u), std::abs(v)});
    plane::Vec2 place = plane::Vec2::Zero();
    for (const plane::Vec2& p : tile.points) place = place.cwiseMax(p.cwiseAbs());
    // The inverse lattice maps the rounding of positions to that of lattice coordinates.
    const plane::Vec2 by_x = tile.lattice.to_lattice(plane::Vec2(place.x(), 0)).cwiseAbs();
    const plane::Vec2 by_y = tile.lattice.to_lattice(plane::Vec2(0, place.y())).cwiseAbs();
    return kTextureUlps * kEpsilon * (plane::Vec2::Constant(largest) + by_x + by_y);
}

void require_texture(const GltfDocument& document, const Json& primitive, const plane::Tile& tile) {
    const auto numbers = attribute(document, primitive, "TEXCOORD_0", 2, tile.points.size());
    const std::vector<plane::TextureCoordinate> wanted = texture_coordinates(tile);
    const plane::Vec2 allowed = texture_rounding(tile, wanted);
    for (std::size_t v = 0; v < wanted.size(); ++v) {
        checkpoint_each(v);
        if (std::abs(double(numbers[2 * v]) - wanted[v][0]) <= allowed.x() &&
            std::abs(1 - double(numbers[2 * v + 1]) - wanted[v][1]) <= allowed.y()) {
            continue;
        }
        throw_bad(document, "the texture coordinates of vertex " + std::to_string(v) +
                                " are not its lattice coordinates");
    }
}

void require_colours(const GltfDocument& document, const Json& primitive, const plane::Tile& tile) {
    const auto colours = attribute(document, primitive, "COLOR_0", 3, tile.points.size());
    std::vector<int> first(tile.points.size(), -1);
    for (int v = 0; v < tile.n_vertices(); ++v) {
        checkpoint_each(v);
        const float* colour = &colours[3 * std::size_t(v)];
        const SiteId site = tile.vertex_site.empty() ? v : tile.vertex_site[v];
        const bool known = site >= 0 && site < tile.n_vertices();
        const bool in_range =
            std::all_of(colour, colour + 3, [](float x) { return x >= 0 && x <= 1; });
        if (known && first[site] < 0) first[site] = v;
        if (known && in_range &&
            std::equal(colour, colour + 3, &colours[3 * std::size_t(first[site])])) {
            continue;
        }
        throw_bad(document, "vertex " + std::to_string(v) + " has a colour that its site has not");
    }
}

/// The lines of the outlines, each from its lower to its higher end, and those that sides of faces
/// have met.
class Outlines {
   public:
    /// @param ends  in pairs, of sorted lines.
    Outlines(const std::vector<int>& ends, std::size_t n_vertices)
        : ends_(ends), begin_(n_vertices + 1, 0), is_met_(ends.size() / 2, false) {
        for (std::size_t k = 0; k < ends.size(); k += 2) ++begin_[std::size_t(ends[k]) + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    }

    /// Meets the line between two vertices, if there is one.
    void meet(int v, int w) {
        const auto [low, high] = std::minmax(v, w);
        for (std::size_t k = begin_[low]; k < begin_[std::size_t(low) + 1]; ++k) {
            if (ends_[2 * k + 1] != high) continue;
            is_met_[k] = true;
            return;
        }
        ++n_missing_;
    }

    /// Whether the lines are the sides that were met.
    bool agree() const {
        return n_missing_ == 0 && std::find(is_met_.begin(), is_met_.end(), false) == is_met_.end();
    }

   private:
    const std::vector<int>& ends_;
    /// The lines whose lower end is vertex v begin at begin_[v].
    std::vector<std::size_t> begin_;
    std::vector<bool> is_met_;
    std::size_t n_missing_ = 0;
};

/// Meets the sides of the faces that the triangles make up, without those inside of a fan, and
/// those of no length.
void meet_sides(const plane::Tile& tile, Outlines& outlines) {
    const auto is_joined = [&](int f) {
        if (f <= 0 || f >= tile.n_faces() || tile.kind != plane::MeshKind::kVoronoi) return false;
        const auto before = tile.faces[f - 1];
        const auto face = tile.faces[f];
        return tile.face_site[f] == tile.face_site[f - 1] && face[0] == before[0] &&
               face[1] == before[2];
    };
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        const auto face = tile.faces[f];
        const auto meet = [&](int v, int w) {
            if (tile.points[v] != tile.points[w]) outlines.meet(v, w);
        };
        if (!is_joined(f)) meet(face[0], face[1]);
        meet(face[1], face[2]);
        if (!is_joined(f + 1)) meet(face[2], face[0]);
    }
}

/// Whether float32 brings two vertices so close together that triangles or lines are left out.
bool has_short_sides(const plane::Tile& tile) {
    double largest = 0;
    for (const plane::Vec2& p : tile.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    const double least = kShortUlps * double(std::numeric_limits<float>::epsilon()) * largest;
    std::vector<plane::Vec2> points = tile.points;
    std::sort(points.begin(), points.end(), [](const plane::Vec2& p, const plane::Vec2& q) {
        return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
    });
    if (std::adjacent_find(points.begin(), points.end()) != points.end()) return true;
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        plane::Vec2 from = tile.points[tile.faces[f].back()];
        for (const int v : tile.faces[f]) {
            if ((tile.points[v] - from).norm() <= least) return true;
            from = tile.points[v];
        }
    }
    return false;
}

void require_outlines(const GltfDocument& document, const Json& primitive,
                      const plane::Tile& tile) {
    const auto points = attribute(document, primitive, "POSITION", 3, tile.points.size());
    for (std::size_t v = 0; v < tile.points.size(); ++v) {
        checkpoint_each(v);
        const float* p = &points[3 * v];
        if (p[0] == tile.points[v].x() && p[1] == tile.points[v].y() && p[2] == points[2] &&
            p[2] > 0) {
            continue;
        }
        throw_bad(document, "the outlines do not lie above vertex " + std::to_string(v));
    }
    const std::vector<int> ends =
        document.indices(document.count_in(primitive, "indices"), tile.points.size());
    bool rises = ends.size() % 2 == 0;
    for (std::size_t k = 0; rises && k < ends.size(); k += 2) {
        rises = ends[k] < ends[k + 1] &&
                (k == 0 || std::tie(ends[k - 2], ends[k - 1]) < std::tie(ends[k], ends[k + 1]));
    }
    if (rises) {
        Outlines outlines(ends, tile.points.size());
        meet_sides(tile, outlines);
        if (outlines.agree() || has_short_sides(tile)) return;
    }
    throw_bad(document, "the outlines are not the edges of the faces");
}

}  // namespace

void require_own_attributes(const GltfDocument& document, const plane::Tile& tile) {
    const std::size_t n_meshes = GltfDocument::member(document.root(), "meshes").size();
    const auto first_primitive = [&](std::size_t mesh) -> const Json& {
        return GltfDocument::member(document.entry("meshes", mesh), "primitives")[0];
    };
    const Json& surface = first_primitive(0);
    const Json& attributes = GltfDocument::member(surface, "attributes");
    for (std::size_t m = 0; m + 1 < n_meshes; ++m) {
        for (const Json& primitive :
             GltfDocument::member(document.entry("meshes", m), "primitives")) {
            if (same_accessors(GltfDocument::member(primitive, "attributes"), attributes)) continue;
            throw_bad(document, "the triangles do not share their vertices");
        }
    }
    require_flat(document, surface, tile);
    require_texture(document, surface, tile);
    if (attributes.contains("COLOR_0")) require_colours(document, surface, tile);
    require_outlines(document, first_primitive(n_meshes - 1), tile);
}

}  // namespace pcvt
