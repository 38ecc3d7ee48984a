#include "mesher/space/grains/sharp_features.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

bool is_thin(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::min({degrees_between(b - a, c - a), degrees_between(a - b, c - b),
                     degrees_between(a - c, b - c)}) < kSharpAngle;
}

/// The least extent of a face normal to one of its edges, and the longest edge.
std::pair<double, double> width_and_length(const CellComplex& complex, int f) {
    const std::span<const VertexImage> corners = complex.corners_of(f);
    double width = kUnlimited;
    double longest = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3 a = complex.position(corners[k]);
        const Vec3 along = complex.position(corners[(k + 1) % corners.size()]) - a;
        double extent = 0;
        for (const VertexImage& corner : corners) {
            const Vec3 arm = complex.position(corner) - a;
            extent = std::max(extent, length(cross_product(along, arm)) / length(along));
        }
        width = std::min(width, extent);
        longest = std::max(longest, length(along));
    }
    return {width, longest};
}

class FeatureSearch {
   public:
    FeatureSearch(const CellComplex& complex, const GrainSurface& surface,
                  const std::vector<CellHull>& hulls)
        : complex_(complex), surface_(surface), hulls_(hulls) {
        for (const CellHull& hull : hulls) found_.near.emplace_back(hull.points.size(), 0);
    }

    SharpFeatures run() {
        for (int f = 0; f < complex_.n_faces(); ++f) {
            checkpoint_each(f);
            visit_face(f);
        }
        std::sort(sides_.begin(), sides_.end(), [](const EdgeSide& s, const EdgeSide& t) {
            return std::tie(s.cell, s.edge, s.offset, s.face) <
                   std::tie(t.cell, t.edge, t.offset, t.face);
        });
        for (std::size_t k = 0; k + 1 < sides_.size(); k += 2) visit_edge(sides_[k], sides_[k + 1]);
        for (std::size_t c = 0; c < hulls_.size(); ++c) spread(hulls_[c], found_.near[c]);
        return std::move(found_);
    }

   private:
    /// A face of a cell at an edge.
    struct EdgeSide {
        SiteId cell;
        int edge;
        Offset offset;
        int face;
        Vec3 outward;
        /// From the edge into the face.
        Vec3 inward;
    };

    void mark(SiteId cell, const NodeImage& image) {
        found_.near[cell][hulls_[cell].find(image)] = 1;
    }

    void mark_face(int f) {
        const CellFace& face = complex_.faces[f];
        for (const SurfaceTriangle& triangle : surface_.triangles[f]) {
            for (const NodeImage& image : triangle) {
                mark(face.cell, image);
                mark(face.neighbour, {image.vertex, image.offset - face.offset});
            }
        }
    }

    void visit_face(int f) {
        const CellFace& face = complex_.faces[f];
        const std::span<const VertexImage> corners = complex_.corners_of(f);
        const FacePlane plane = face_plane(complex_, f);
        if (const auto [width, longest] = width_and_length(complex_, f);
            width < kNarrowPart * longest) {
            found_.features.push_back({SharpFeature::Kind::kNarrowFace, face.cell,
                                       complex_.position(corners[0]),
                                       degrees_between({longest, 0, 0}, {longest, width, 0})});
            mark_face(f);
        }
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3 at = complex_.position(corners[k]);
            const Vec3 ahead = complex_.position(corners[(k + 1) % corners.size()]) - at;
            const Vec3 behind =
                complex_.position(corners[(k + corners.size() - 1) % corners.size()]) - at;
            const double angle = degrees_between(ahead, behind);
            if (angle < kSharpAngle) {
                found_.features.push_back({SharpFeature::Kind::kFaceCorner, face.cell, at, angle});
                mark(face.cell, corners[k]);
                mark(face.neighbour, {corners[k].vertex, corners[k].offset - face.offset});
            }
            const EdgeUse& use = surface_.edges.uses[complex_.begin[f] + static_cast<int>(k)];
            const Vec3 inward = cross_product(plane.normal, ahead);
            sides_.push_back({face.cell, use.edge, use.offset, f, plane.normal, inward});
            sides_.push_back(
                {face.neighbour, use.edge, use.offset - face.offset, f, -plane.normal, inward});
        }
    }

    void visit_edge(const EdgeSide& left, const EdgeSide& right) {
        double angle = degrees_between(left.inward, right.inward);
        if (dot_product(left.inward, right.outward) > 0) angle = 360 - angle;
        if (std::min(angle, std::abs(180 - angle)) >= kSharpAngle) return;
        const CellEdge& edge = surface_.edges.edges[left.edge];
        const VertexImage from{edge.from.vertex, edge.from.offset + left.offset};
        const VertexImage to{edge.to.vertex, edge.to.offset + left.offset};
        const Vec3 middle = (complex_.position(from) + complex_.position(to)) / 2;
        found_.features.push_back({SharpFeature::Kind::kCellEdge, left.cell, middle, angle});
        mark(left.cell, from);
        mark(left.cell, to);
        for (const int node : surface_.edge_nodes[left.edge]) mark(left.cell, {node, left.offset});
    }

    /// Marks the corners of thin triangles with a marked corner.
    static void spread(const CellHull& hull, std::vector<char>& near) {
        const std::vector<char> before = near;
        for (const auto& [a, b, c] : hull.triangles) {
            if (before[a] == 0 && before[b] == 0 && before[c] == 0) continue;
            if (is_thin(hull.points[a], hull.points[b], hull.points[c])) {
                near[a] = near[b] = near[c] = 1;
            }
        }
    }

    const CellComplex& complex_;
    const GrainSurface& surface_;
    const std::vector<CellHull>& hulls_;
    SharpFeatures found_;
    std::vector<EdgeSide> sides_;
};

}  // namespace

SharpFeatures sharp_features(const CellComplex& complex, const GrainSurface& surface,
                             const std::vector<CellHull>& hulls) {
    return FeatureSearch(complex, surface, hulls).run();
}

}  // namespace pcvt::space
