#include "mesher/space/grains/grain_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/space/grains/face_triangulation.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

/// The largest circumradius of triangles over the size of the cells.
constexpr double kLargestRadius = 0.75;
/// The sine of 22 degrees, below which the angles of triangles are refined: 20 degrees take 4 %
/// fewer tetrahedra, and leave one in a hundred of them below 27 degrees.
constexpr double kThinSine = 0.374606593415912;
/// A part of an edge is divided only where it is longer than this part of the size at its middle,
/// or the segments at a sharp corner divide each other for ever.
constexpr double kDividedLength = 0.7;
constexpr int kMostDivisions = 12;
/// Only faces that are almost flat, of edges shorter than 1e-6 h, come near to it.
constexpr int kMostFacePoints = 4000;

/// Part `part` of an edge of the cells, from cut `part` - 1 to cut `part`.
using EdgePart = std::pair<int, int>;

/// The boundary of a face with the nodes of its edges, counter-clockwise.
struct FaceBoundary {
    std::vector<Vec3> positions = {};
    /// Images of nodes; nodes of edges have no number yet while these are divided.
    std::vector<NodeImage> images = {};
    /// The part of an edge between each point and the next one.
    std::vector<EdgePart> parts = {};
};

class SurfaceBuilder {
   public:
    SurfaceBuilder(const CellComplex& complex, const std::vector<double>& cell_size,
                   Workers& workers)
        : complex_(complex), cell_size_(cell_size), workers_(workers) {
        surface_.edges = cell_edges(complex, cell_size);
        for (int f = 0; f < complex.n_faces(); ++f) planes_.push_back(face_plane(complex, f));
        for (int v = 0; v < static_cast<int>(complex.vertices.size()); ++v) {
            surface_.nodes.push_back({complex.vertices[v], 0, v});
        }
    }

    GrainSurface build() {
        triangulate();
        number_edge_nodes();
        add_faces();
        return std::move(surface_);
    }

   private:
    Vec3 at_cut(const CellEdge& edge, double cut) const {
        return (1 - cut) * complex_.position(edge.from) + cut * complex_.position(edge.to);
    }

    FaceBoundary boundary(int f) const {
        FaceBoundary all;
        for (int c = complex_.begin[f]; c < complex_.begin[f + 1]; ++c) {
            const EdgeUse& use = surface_.edges.uses[c];
            const CellEdge& edge = surface_.edges.edges[use.edge];
            const int n_cuts = static_cast<int>(edge.cuts.size());
            const Vec3 shift = complex_.reduced.translation(use.offset);
            all.positions.push_back(complex_.position(complex_.corners[c]));
            all.images.push_back(complex_.corners[c]);
            all.parts.emplace_back(use.edge, use.reversed ? n_cuts : 0);
            for (int k = 0; k < n_cuts; ++k) {
                const int cut = use.reversed ? n_cuts - 1 - k : k;
                all.positions.push_back(at_cut(edge, edge.cuts[cut]) + shift);
                const bool numbered = !surface_.edge_nodes.empty();
                all.images.push_back(
                    {numbered ? surface_.edge_nodes[use.edge][cut] : -1, use.offset});
                all.parts.emplace_back(use.edge, use.reversed ? cut : cut + 1);
            }
        }
        return all;
    }

    double face_size(int f) const {
        const CellFace& face = complex_.faces[f];
        return std::min(cell_size_[face.cell], cell_size_[face.neighbour]);
    }

    Point2 in_plane(int f, const Vec3& p) const {
        const FacePlane& plane = planes_[f];
        return {dot_product(p - plane.origin, plane.x), dot_product(p - plane.origin, plane.y)};
    }

    /// The target size at a point of a face.
    double size_at(int f, const Point2& p) const {
        double size = face_size(f);
        for (const VertexImage& corner : complex_.corners_of(f)) {
            const Point2 arm = in_plane(f, complex_.position(corner)) - p;
            size = std::min(size, surface_.edges.vertex_size[corner.vertex] +
                                      kSizeGrowth * std::hypot(arm.x(), arm.y()));
        }
        return size;
    }

    /// Triangulates a face from its boundary.
    /// @returns the parts of edges that shall be divided.
    std::vector<EdgePart> triangulate_face(int f) {
        const FaceBoundary around = boundary(f);
        std::vector<Point2> points;
        for (const Vec3& p : around.positions) points.push_back(in_plane(f, p));
        FaceTriangulation face(std::move(points));
        const std::vector<int> obstacles =
            face.refine({kLargestRadius * face_size(f), kThinSine, kMostFacePoints});
        std::vector<EdgePart> divided;
        for (const int k : obstacles) {
            const Point2& a = face.points()[k];
            const Point2& b = face.points()[(k + 1) % face.n_boundary()];
            const double whole = std::hypot(b.x() - a.x(), b.y() - a.y());
            if (whole > kDividedLength * size_at(f, (a + b) / 2)) {
                divided.push_back(around.parts[k]);
            }
        }
        faces_[f] = std::move(face);
        return divided;
    }

    /// Triangulates all faces, divides the edges at which that stopped, and begins again with the
    /// faces of these edges.
    void triangulate() {
        const int n = complex_.n_faces();
        faces_.assign(n, FaceTriangulation({{0, 0}, {1, 0}, {0, 1}}));
        std::vector<int> waiting;
        for (int f = 0; f < n; ++f) waiting.push_back(f);
        for (int round = 0; round < kMostDivisions && !waiting.empty(); ++round) {
            std::vector<std::vector<EdgePart>> found(waiting.size());
            workers_.for_each(static_cast<int>(waiting.size()),
                              [&](int k) { found[k] = triangulate_face(waiting[k]); });
            std::vector<EdgePart> parts;
            for (const auto& some : found) parts.insert(parts.end(), some.begin(), some.end());
            if (round + 1 < kMostDivisions) waiting = divide(std::move(parts));
        }
    }

    /// Divides parts of edges in their middle.
    /// @returns the faces of these edges.
    std::vector<int> divide(std::vector<EdgePart> parts) {
        std::sort(parts.begin(), parts.end(), std::greater<>());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        std::vector<int> faces;
        // The last part of an edge comes first, so that the numbers of the others hold.
        for (const auto& [e, part] : parts) {
            CellEdge& edge = surface_.edges.edges[e];
            const auto n_cuts = static_cast<int>(edge.cuts.size());
            const double begin = part > 0 ? edge.cuts[part - 1] : 0;
            const double end = part < n_cuts ? edge.cuts[part] : 1;
            edge.cuts.insert(edge.cuts.begin() + part, (begin + end) / 2);
            faces.insert(faces.end(), edge.faces.begin(), edge.faces.end());
        }
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        return faces;
    }

    void number_edge_nodes() {
        const std::vector<CellEdge>& edges = surface_.edges.edges;
        std::vector<std::vector<int>> numbers(edges.size());
        for (std::size_t e = 0; e < edges.size(); ++e) {
            for (const double cut : edges[e].cuts) {
                numbers[e].push_back(static_cast<int>(surface_.nodes.size()));
                surface_.nodes.push_back({at_cut(edges[e], cut), 1, static_cast<int>(e)});
            }
        }
        surface_.edge_nodes = std::move(numbers);
    }

    void add_faces() {
        workers_.for_each(complex_.n_faces(), [&](int f) { faces_[f].improve(); });
        surface_.triangles.resize(faces_.size());
        for (int f = 0; f < complex_.n_faces(); ++f) {
            checkpoint_each(f);
            add_face(f);
            faces_[f] = FaceTriangulation({{0, 0}, {1, 0}, {0, 1}});
        }
    }

    void add_face(int f) {
        const FaceTriangulation& face = faces_[f];
        const FaceBoundary around = boundary(f);
        std::vector<NodeImage> images = around.images;
        const FacePlane& plane = planes_[f];
        for (std::size_t v = around.images.size(); v < face.points().size(); ++v) {
            const Point2& p = face.points()[v];
            const Vec3 position = plane.origin + p.x() * plane.x + p.y() * plane.y +
                                  height(f, around, p) * plane.normal;
            images.push_back({static_cast<int>(surface_.nodes.size()), {}});
            surface_.nodes.push_back({position, 2, f});
        }
        for (const auto& [a, b, c] : face.triangles()) {
            surface_.triangles[f].push_back({images[a], images[b], images[c]});
        }
    }

    /// The height of a point of a face that is not plane: those of the boundary, each weighted with
    /// the inverse cube of its distance.
    double height(int f, const FaceBoundary& around, const Point2& p) const {
        const FacePlane& plane = planes_[f];
        double weights = 0;
        double sum = 0;
        for (const Vec3& q : around.positions) {
            const Point2 arm = in_plane(f, q) - p;
            const double squared = arm.x() * arm.x() + arm.y() * arm.y();
            const double weight = 1 / (squared * std::sqrt(squared));
            weights += weight;
            sum += weight * dot_product(q - plane.origin, plane.normal);
        }
        return sum / weights;
    }

    const CellComplex& complex_;
    const std::vector<double>& cell_size_;
    Workers& workers_;
    std::vector<FacePlane> planes_;
    std::vector<FaceTriangulation> faces_;
    GrainSurface surface_;
};

}  // namespace

FacePlane face_plane(const CellComplex& complex, int face) {
    std::vector<Vec3> corners;
    for (const VertexImage& corner : complex.corners_of(face)) {
        corners.push_back(complex.position(corner));
    }
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : corners) middle += p / static_cast<double>(corners.size());
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        area += cross_product(corners[k] - middle, corners[(k + 1) % corners.size()] - middle);
    }
    const Vec3 normal = unit_vector(area);
    Vec3 longest = Vec3::Zero();
    for (const Vec3& p : corners) {
        const Vec3 arm = p - middle - dot_product(p - middle, normal) * normal;
        if (squared_length(arm) > squared_length(longest)) longest = arm;
    }
    const Vec3 x = unit_vector(longest);
    return {.origin = middle, .x = x, .y = cross_product(normal, x), .normal = normal};
}

GrainSurface grain_surface(const CellComplex& complex, const std::vector<double>& cell_size,
                           Workers& workers) {
    return SurfaceBuilder(complex, cell_size, workers).build();
}

}  // namespace pcvt::space
