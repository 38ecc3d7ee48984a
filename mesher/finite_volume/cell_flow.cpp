#include "mesher/finite_volume/cell_flow.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/tile/face_polygon.hpp"

namespace pcvt {
namespace {

struct CellShapes {
    std::vector<plane::Vec2> centroids;
    std::vector<double> areas;
};

CellShapes cell_shapes(const plane::Tile& tile) {
    CellShapes shapes;
    plane::Polygon polygon;
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        plane::face_polygon(tile.points, tile.faces[f], polygon);
        shapes.centroids.push_back(plane::polygon_centroid(polygon));
        shapes.areas.push_back(plane::polygon_area(polygon));
    }
    return shapes;
}

template <class Value>
void subtract_mean(const std::vector<double>& areas, Value zero, std::vector<Value>& values) {
    Value sum = zero;
    double area = 0;
    for (std::size_t c = 0; c < values.size(); ++c) {
        sum += areas[c] * values[c];
        area += areas[c];
    }
    for (Value& value : values) value -= sum / area;
}

double largest_exchange(const DecayingFlow& flow, const plane::Tile& tile,
                        const std::vector<double>& areas) {
    double largest = 0;
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        double flux = 0;
        double from = flow.stream(tile.points[tile.faces[f].back()]);
        for (const int v : tile.faces[f]) {
            const double to = flow.stream(tile.points[v]);
            flux += std::abs(to - from);
            from = to;
        }
        largest = std::max(largest, flux / (2 * areas[f]));
    }
    return largest;
}

/// The viscous dissipation of velocities on cells, by differences between neighbours.
class Dissipation {
   public:
    Dissipation(const ExtrudedMesh& extruded, const CellShapes& shapes,
                const std::vector<plane::Vec2>& velocity)
        : extruded_(extruded), shapes_(shapes), velocity_(velocity) {
        for (int f = 0; f < extruded.n_inner_faces(); ++f) {
            checkpoint_each(f);
            add(f, extruded.neighbour[f], plane::Vec2(0, 0));
        }
        for (const ExtrudedPatch& patch : extruded.patches) {
            if (patch.wall) add_wall(patch);
            if (patch.offset < plane::Offset{} || patch.partner < 0) continue;
            const int shift = extruded.patches[patch.partner].first_face - patch.first_face;
            for (int f = patch.first_face; f < patch.first_face + patch.n_faces; ++f) {
                add(f, extruded.owner[f + shift], patch.separation);
            }
        }
    }

    /// Returns the sum over the upright faces of length |u - u'|^2 / distance of the centroids, on
    /// walls length |u|^2 / distance of the centroid; the sum of area |u|^2 times the rate
    /// approximates it.
    double sum() const { return sum_; }

   private:
    /// The first two points of an upright face lie at the back.
    double length(int f) const {
        const std::span<const int> face = extruded_.faces[f];
        return (extruded_.points[face[1]] - extruded_.points[face[0]]).norm();
    }

    /// Adds the face f towards `cell`, whose image less `separation` lies in front of it.
    void add(int f, int cell, const plane::Vec2& separation) {
        const int owner = extruded_.owner[f];
        const plane::Vec2 across = shapes_.centroids[cell] - separation - shapes_.centroids[owner];
        sum_ += length(f) / across.norm() * (velocity_[cell] - velocity_[owner]).squaredNorm();
    }

    void add_wall(const ExtrudedPatch& patch) {
        const WallSide side = patch.wall->side();
        const int axis = wall_side_row(side).axis;
        const double line = wall_line(side, extruded_.lattice);
        for (int f = patch.first_face; f < patch.first_face + patch.n_faces; ++f) {
            const int owner = extruded_.owner[f];
            const double distance = std::abs(line - shapes_.centroids[owner][axis]);
            sum_ += length(f) / distance * velocity_[owner].squaredNorm();
        }
    }

    const ExtrudedMesh& extruded_;
    const CellShapes& shapes_;
    const std::vector<plane::Vec2>& velocity_;
    double sum_ = 0;
};

/// Whether the cells hold too little of the flow, or damp it too little.
bool are_too_large(const DecayingFlow& flow, const plane::Tile& tile, const ExtrudedMesh& extruded,
                   const CellShapes& shapes, const std::vector<plane::Vec2>& velocity) {
    double energy = 0;
    for (std::size_t c = 0; c < shapes.areas.size(); ++c) {
        energy += shapes.areas[c] * velocity[c].squaredNorm();
    }
    const double dissipation = Dissipation(extruded, shapes, velocity).sum();
    const double exact_energy = tile.lattice.area() * flow.mean_square_speed();
    return !(energy > CellFlow::kLeastEnergy * exact_energy) ||
           !(dissipation > CellFlow::kLeastDamping * flow.rate() * energy);
}

}  // namespace

CellFlow cell_flow(const DecayingFlow& flow, const plane::Tile& tile,
                   const ExtrudedMesh& extruded) {
    // Sample the flow and subtract its mean.
    const CellShapes shapes = cell_shapes(tile);
    CellFlow cells{.courant_rate = largest_exchange(flow, tile, shapes.areas)};
    for (const plane::Vec2& p : shapes.centroids) {
        cells.velocity.push_back(flow.velocity(p));
        cells.tracer.push_back(flow.stream(p) / flow.largest_stream());
    }
    if (tile.walls == Walls::kNone) subtract_mean(shapes.areas, plane::Vec2(0, 0), cells.velocity);
    subtract_mean(shapes.areas, 0.0, cells.tracer);
    // Compare the damping on the cells with the exact rate.
    cells.has_holes = !tile.holes.empty();
    cells.at_rest = cells.has_holes || are_too_large(flow, tile, extruded, shapes, cells.velocity);
    if (cells.at_rest) {
        std::fill(cells.velocity.begin(), cells.velocity.end(), plane::Vec2(0, 0));
        std::fill(cells.tracer.begin(), cells.tracer.end(), 0.0);
    }
    return cells;
}

}  // namespace pcvt
