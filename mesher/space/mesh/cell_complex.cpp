#include "mesher/space/mesh/cell_complex.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <tuple>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/mesh/voronoi_corners.hpp"

namespace pcvt::space {
namespace {

/// The corners of the edges of a tetrahedron, and its other corners x and y, so that (p, q, x, y)
/// is positively oriented: x lies before y, counter-clockwise round p -> q.
struct EdgeCorners {
    int p, q, x, y;
};
constexpr std::array<EdgeCorners, 6> kEdges{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

/// An edge of a tetrahedron, turned so that p <= q, in the frame in which p has the offset 0.
struct RingEntry {
    Corner q;
    Corner x;
    Corner y;
    int tetrahedron;
    /// The translation from the tetrahedron's frame.
    Offset frame;
};

bool runs_backwards(const Corner& p, const Corner& q) {
    return std::tie(q.site, q.offset) < std::tie(p.site, p.offset);
}

/// @param e  6 t + the index of an edge of tetrahedron t.
RingEntry ring_entry(const TorusTetrahedra& tetrahedra, int e) {
    const Tetrahedron t = tetrahedra.tetrahedron(e / 6);
    const EdgeCorners& edge = kEdges[e % 6];
    Corner p = t[edge.p];
    RingEntry entry{t[edge.q], t[edge.x], t[edge.y], e / 6, {}};
    if (runs_backwards(p, entry.q)) {
        std::swap(p, entry.q);
        std::swap(entry.x, entry.y);
    }
    entry.frame = -p.offset;
    for (Corner* corner : {&entry.q, &entry.x, &entry.y}) {
        corner->offset = corner->offset + entry.frame;
    }
    return entry;
}

SiteId first_site(const TorusTetrahedra& tetrahedra, int e) {
    const auto sites = tetrahedra.corner_sites();
    const EdgeCorners& edge = kEdges[e % 6];
    return std::min(sites[4 * (e / 6) + edge.p], sites[4 * (e / 6) + edge.q]);
}

/// Orders the entries of one edge so that each begins where the one before ends.
void chain(std::span<RingEntry> ring) {
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
        const auto next = std::find_if(ring.begin() + std::ptrdiff_t(k) + 1, ring.end(),
                                       [&](const RingEntry& r) { return r.x == ring[k].y; });
        if (next == ring.end()) throw InternalError("the tetrahedra of an edge form no ring");
        std::swap(ring[k + 1], *next);
    }
}

/// Adds the face dual to an edge, unless its corners are merged into fewer than three.
void add_face(SiteId p, std::span<const RingEntry> ring, const VoronoiCorners& vertices,
              CellComplex& complex) {
    std::vector<VertexImage>& corners = complex.corners;
    const auto first = static_cast<std::size_t>(complex.begin.back());
    for (const RingEntry& entry : ring) {
        const VertexImage& centre = vertices.of_tetrahedron[entry.tetrahedron];
        const VertexImage corner{centre.vertex, centre.offset + entry.frame};
        if (corners.size() == first || corners.back() != corner) corners.push_back(corner);
    }
    while (corners.size() > first + 1 && corners.back() == corners[first]) corners.pop_back();
    if (corners.size() < first + 3) {
        corners.resize(first);
        return;
    }
    complex.faces.push_back({p, ring[0].q.site, ring[0].q.offset});
    complex.begin.push_back(static_cast<int>(corners.size()));
}

}  // namespace

CellComplex cell_complex(const Sites& sites, const TorusTetrahedra& tetrahedra,
                         const Eigen::VectorXd& weights) {
    VoronoiCorners vertices = voronoi_corners(sites, tetrahedra, weights);
    CellComplex complex{.reduced = sites.reduction().reduced, .n_cells = sites.n_sites()};
    for (SiteId s = 0; s < sites.n_sites(); ++s) complex.sites.push_back(sites.position(s));
    std::vector<RingEntry> entries;
    for_each_bucket(
        6 * tetrahedra.n_tetrahedra(), sites.n_sites(),
        [&](int e) { return first_site(tetrahedra, e); },
        [&](std::span<const int> edges) {
            entries.clear();
            for (const int e : edges) entries.push_back(ring_entry(tetrahedra, e));
            std::sort(entries.begin(), entries.end(), [](const RingEntry& r, const RingEntry& s) {
                return std::tie(r.q, r.tetrahedron, r.frame) <
                       std::tie(s.q, s.tetrahedron, s.frame);
            });
            for (std::size_t begin = 0; begin < entries.size();) {
                std::size_t end = begin;
                while (end < entries.size() && entries[end].q == entries[begin].q) ++end;
                const std::span<RingEntry> ring(&entries[begin], end - begin);
                chain(ring);
                add_face(first_site(tetrahedra, edges[0]), ring, vertices, complex);
                begin = end;
            }
        });
    complex.vertices = std::move(vertices.positions);
    return complex;
}

void PyramidSum::add(std::span<const Vec3> corners, double sign) {
    const Vec3 a = corners[0] - tip_;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const Vec3 b = corners[k] - tip_;
        const Vec3 c = corners[k + 1] - tip_;
        const Vec3 sum = a + b + c;
        const Vec3 n = b.cross(c);
        // Files state volumes, and Eigen's dot() adds in another order on other platforms.
        const double part = sign * (a.x() * n.x() + a.y() * n.y() + a.z() * n.z());
        volume_ += part;
        first_ += part * sum;
        // 1/2 ((a + b + c)^2 + a^2 + b^2 + c^2) is the sum of all products.
        second_ +=
            part / 2 * (sum.squaredNorm() + a.squaredNorm() + b.squaredNorm() + c.squaredNorm());
    }
}

CellBody PyramidSum::body() const {
    const Vec3 mean = first_ / (4 * volume_);
    return {.volume = volume_ / 6,
            .centroid = tip_ + mean,
            .moment = second_ / 60 - volume_ / 6 * mean.squaredNorm()};
}

std::vector<CellBody> cell_bodies(const CellComplex& complex) {
    // Each cell is measured from the first corner of its first face.
    std::vector<std::optional<PyramidSum>> sums(static_cast<std::size_t>(complex.n_cells));
    std::vector<Vec3> corners;
    const auto add = [&](SiteId cell, const Vec3& shift, double sign) {
        for (Vec3& corner : corners) corner += shift;
        if (!sums[cell]) sums[cell].emplace(corners[0]);
        sums[cell]->add(corners, sign);
    };
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const CellFace& face = complex.faces[f];
        corners.clear();
        for (const VertexImage& corner : complex.corners_of(f)) {
            corners.push_back(complex.position(corner));
        }
        add(face.cell, Vec3::Zero(), 1);
        add(face.neighbour, -complex.reduced.translation(face.offset), -1);
    }
    std::vector<CellBody> bodies;
    for (const auto& sum : sums) bodies.push_back(sum ? sum->body() : CellBody{});
    return bodies;
}

}  // namespace pcvt::space
