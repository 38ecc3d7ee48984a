#include "mesher/finite_volume/cell_flow.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

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
    Dissipation(const plane::Lattice& lattice, const FiniteVolumeMesh& extruded,
                const CellShapes& shapes, const std::vector<plane::Vec2>& velocity)
        : lattice_(lattice), extruded_(extruded), shapes_(shapes), velocity_(velocity) {
        for (int f = 0; f < extruded.n_inner_faces(); ++f) {
            checkpoint_each(f);
            add(f, extruded.neighbour[f], plane::Vec2(0, 0));
        }
        for (const FiniteVolumePatch& patch : extruded.patches) {
            if (patch.kind == PatchKind::kWall) add_wall(patch);
            if (patch.kind != PatchKind::kCyclic) continue;
            if (patch.offset_as<plane::Offset>() < plane::Offset{}) continue;
            const int shift = extruded.patches[patch.partner].first_face - patch.first_face;
            for (int f = patch.first_face; f < patch.end_face(); ++f) {
                add(f, extruded.owner[f + shift], patch.separation.head<2>());
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

    /// @pre the wall is a side of the domain.
    void add_wall(const FiniteVolumePatch& patch) {
        const WallSideRow& row = *find_wall_side(patch.name);
        const double line = wall_line(row, lattice_);
        for (int f = patch.first_face; f < patch.end_face(); ++f) {
            const int owner = extruded_.owner[f];
            const double distance = std::abs(line - shapes_.centroids[owner][row.axis]);
            sum_ += length(f) / distance * velocity_[owner].squaredNorm();
        }
    }

    const plane::Lattice& lattice_;
    const FiniteVolumeMesh& extruded_;
    const CellShapes& shapes_;
    const std::vector<plane::Vec2>& velocity_;
    double sum_ = 0;
};

/// Whether the cells hold too little of the flow, or damp it too little.
bool are_too_large(const DecayingFlow& flow, const plane::Tile& tile,
                   const FiniteVolumeMesh& extruded, const CellShapes& shapes,
                   const std::vector<plane::Vec2>& velocity) {
    double energy = 0;
    for (std::size_t c = 0; c < shapes.areas.size(); ++c) {
        energy += shapes.areas[c] * velocity[c].squaredNorm();
    }
    const double dissipation = Dissipation(tile.lattice, extruded, shapes, velocity).sum();
    const double exact_energy = tile.lattice.area() * flow.mean_square_speed();
    return !(energy > CellFlow::kLeastEnergy * exact_energy) ||
           !(dissipation > CellFlow::kLeastDamping * flow.rate() * energy);
}

/// Half the sum of the fluxes through the faces of a cell over its volume, the largest one.
double largest_exchange(const BeltramiFlow& flow, const space::PolyhedralMesh& mesh,
                        const std::vector<space::CellBody>& bodies) {
    std::vector<double> fluxes(bodies.size(), 0);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        const auto corners = mesh.faces[f];
        const space::Vec3 first = mesh.points[corners[0]];
        space::Vec3 area = space::Vec3::Zero();
        space::Vec3 mean = space::Vec3::Zero();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const space::Vec3 here = mesh.points[corners[k]] - first;
            area += here.cross(mesh.points[corners[(k + 1) % corners.size()]] - first) / 2;
            mean += here / static_cast<double>(corners.size());
        }
        const double flux = std::abs(flow.velocity(first + mean).dot(area));
        fluxes[mesh.owner[f]] += flux;
        if (f < mesh.n_inner_faces()) fluxes[mesh.neighbour[f]] += flux;
    }
    double largest = 0;
    for (std::size_t s = 0; s < bodies.size(); ++s) {
        largest = std::max(largest, fluxes[s] / 2 / bodies[s].volume);
    }
    return largest;
}

}  // namespace

CellFlow cell_flow(const DecayingFlow& flow, const plane::Tile& tile,
                   const FiniteVolumeMesh& extruded) {
    // Sample the flow and subtract its mean.
    const CellShapes shapes = cell_shapes(tile);
    CellFlow cells{.courant_rate = largest_exchange(flow, tile, shapes.areas),
                   .rate = flow.rate(),
                   .turn_time = flow.turn_time(),
                   .keeps_shape = flow.keeps_shape()};
    std::vector<plane::Vec2> velocity;
    for (const plane::Vec2& p : shapes.centroids) {
        velocity.push_back(flow.velocity(p));
        cells.tracer.push_back(flow.stream(p) / flow.largest_stream());
    }
    if (tile.walls == Walls::kNone) subtract_mean(shapes.areas, plane::Vec2(0, 0), velocity);
    subtract_mean(shapes.areas, 0.0, cells.tracer);
    // Compare the damping on the cells with the exact rate.
    cells.has_holes = !tile.holes.empty();
    cells.at_rest = cells.has_holes || are_too_large(flow, tile, extruded, shapes, velocity);
    if (cells.at_rest) {
        std::fill(velocity.begin(), velocity.end(), plane::Vec2(0, 0));
        std::fill(cells.tracer.begin(), cells.tracer.end(), 0.0);
    }
    for (const plane::Vec2& u : velocity) cells.velocity.emplace_back(u.x(), u.y(), 0);
    return cells;
}

CellFlow cell_flow(const BeltramiFlow& flow, const space::PolyhedralMesh& mesh) {
    const std::vector<space::CellBody> bodies = cell_bodies(mesh);
    CellFlow cells{.courant_rate = largest_exchange(flow, mesh, bodies),
                   .rate = flow.rate(),
                   .turn_time = flow.turn_time()};
    cells.velocity.reserve(bodies.size());
    for (const space::CellBody& body : bodies) {
        cells.velocity.push_back(flow.velocity(body.centroid));
    }
    return cells;
}

}  // namespace pcvt
