#include "io/gltf/space_gltf_proof.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/gltf/glb_faces.hpp"
#include "io/gltf/glb_sites.hpp"
#include "io/gltf/gltf_document.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_sites.hpp"

namespace pcvt {
namespace {

using Points = std::vector<space::Vec3>;

double largest_coordinate(const Points& points, const Faces& faces) {
    double largest = 0;
    for (const int v : faces.corners) largest = std::max(largest, points[v].cwiseAbs().maxCoeff());
    return largest;
}

/// An edge from its lower end to its higher one, and its sense: 1, or -1 for the reverse.
struct SurfaceEdge {
    std::array<double, 3> low;
    std::array<double, 3> high;
    int sense;
};

void append_edges(const Points& points, std::span<const int> face,
                  std::vector<SurfaceEdge>& edges) {
    const auto position = [&](int v) {
        return std::array{points[v].x(), points[v].y(), points[v].z()};
    };
    auto from = position(face.back());
    for (const int v : face) {
        const auto to = position(v);
        // Rounding may bring two corners together.
        if (from < to) edges.push_back({from, to, 1});
        if (to < from) edges.push_back({to, from, -1});
        from = to;
    }
}

void require_closed(std::vector<SurfaceEdge> edges, const std::string& name) {
    std::sort(edges.begin(), edges.end(), [](const SurfaceEdge& s, const SurfaceEdge& t) {
        return std::tie(s.low, s.high) < std::tie(t.low, t.high);
    });
    for (std::size_t k = 0; k < edges.size();) {
        checkpoint_each(static_cast<long>(k));
        int sum = 0;
        std::size_t end = k;
        while (end < edges.size() && edges[end].low == edges[k].low &&
               edges[end].high == edges[k].high) {
            sum += edges[end++].sense;
        }
        if (sum != 0) throw_violation("(1), closed surfaces", name + " does not close");
        k = end;
    }
}

/// The volume and the area of triangles; the volume is that of the cones over them at a point.
struct Extent {
    double volume = 0;
    double area = 0;

    void add_face(const Points& points, std::span<const int> face, const space::Vec3& origin) {
        const space::Vec3 p = points[face[0]] - origin;
        for (std::size_t k = 2; k < face.size(); ++k) {
            const space::Vec3 q = points[face[k - 1]] - origin;
            const space::Vec3 r = points[face[k]] - origin;
            volume += p.cross(q).dot(r) / 6;
            area += (q - p).cross(r - p).norm() / 2;
        }
    }
};

GlbProof prove_closed(const GlbSurfaces& glb) {
    const space::TileSurface& surface = glb.list.surface;
    const Points& points = surface.points;
    const bool is_boundary = glb.list.form == SurfaceForm::kBoundary;
    const space::Vec3 origin = points[surface.faces.corners.front()];
    GlbProof proof{.n_parts = static_cast<int>(glb.groups.size())};
    std::vector<SurfaceEdge> edges;
    double area = 0;
    for (std::size_t g = 0; g < glb.groups.size(); ++g) {
        Extent extent;
        for (int f = glb.groups[g].first_face; f < glb.group_end(g); ++f) {
            proof.n_triangles += surface.faces.size(f) - 2;
            append_edges(points, surface.faces[f], edges);
            extent.add_face(points, surface.faces[f], origin);
        }
        proof.volume += extent.volume;
        area += extent.area;
        if (is_boundary) continue;
        const std::string& name = glb.groups[g].name;
        require_closed(std::exchange(edges, {}), name);
        if (!(extent.volume > 0)) {
            throw_violation("(2), volumes", name + " has no positive volume");
        }
    }
    if (is_boundary) require_closed(std::move(edges), "the boundary");
    // A corner moves by at most half an ulp along each axis.
    proof.tolerance = kSingleEpsilon * largest_coordinate(points, surface.faces) * area;
    const double wanted = surface.lattice.volume();
    if (!(std::abs(proof.volume - wanted) <= proof.tolerance)) {
        throw_violation("(2), volumes", "they sum to " + std::to_string(proof.volume) + ", not " +
                                            std::to_string(wanted));
    }
    return proof;
}

[[noreturn]] void throw_bad(const EncodedFile& file, const std::string& complaint) {
    throw BadFile(file.path + ": " + complaint + "; write the file again with pcvt");
}

/// Each face has the vertices that the writer gives it.
void compare_indices(const EncodedFile& file, const GlbSurfaces& glb, const GlbSurfaces& expected) {
    for (std::size_t g = 0; g < glb.groups.size(); ++g) {
        for (int f = glb.groups[g].first_face; f < glb.group_end(g); ++f) {
            const auto found = glb.list.surface.faces[f];
            const auto wanted = expected.list.surface.faces[f];
            if (std::equal(found.begin(), found.end(), wanted.begin(), wanted.end())) continue;
            throw_bad(file, "the indices of " + glb.groups[g].name + " are not fans");
        }
    }
}

void compare_normals(const EncodedFile& file, const GlbSurfaces& glb, double largest) {
    const space::TileSurface& surface = glb.list.surface;
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const FaceSize face(surface.points, surface.faces[f]);
        const space::Vec3 wanted = face.area.stableNormalized();
        const space::Vec3 first = stated_normal(glb, surface.faces[f].front());
        const double tolerance = 4 * (kSingleEpsilon + face.tilt(kSingleEpsilon * largest));
        for (const int v : surface.faces[f]) {
            const space::Vec3 normal = stated_normal(glb, v);
            if ((normal - wanted).norm() <= tolerance) continue;
            // A face below the rounding has any direction.
            if (tolerance > 1 && normal == first) continue;
            throw_bad(file, "a normal of " + glb.groups[surface.cell[f]].name +
                                " is not that of its face");
        }
    }
}

/// Each side of the seam plus its translation is the other side.
void compare_seam(const EncodedFile& file, const GlbSurfaces& glb, double largest) {
    const space::TileSurface& surface = glb.list.surface;
    // The means of the centres of the faces.
    std::map<space::Offset, space::Vec3> middles;
    for (std::size_t g = 0; g < glb.groups.size(); ++g) {
        const int first = glb.groups[g].first_face;
        space::Vec3 sum = space::Vec3::Zero();
        for (int f = first; f < glb.group_end(g); ++f) {
            sum += FaceSize(surface.points, surface.faces[f]).centre;
        }
        middles[surface.offset[first]] = sum / double(glb.group_end(g) - first);
    }
    for (const auto& [offset, middle] : middles) {
        const auto other = middles.find(-offset);
        const space::Vec3 there = middle + surface.lattice.translation(offset);
        if (other != middles.end() &&
            (other->second - there).norm() <= 4 * kSingleEpsilon * largest) {
            continue;
        }
        throw_bad(file, seam_name(offset) + " does not meet the other side by its translation");
    }
}

void compare_fields(const EncodedFile& file, const GlbSurfaces& glb) {
    const GltfDocument document(file);
    const std::string& name = glb.groups.front().name;
    const bool is_one_node = name == "cells" || name == "boundary";
    if (!document.is_own() || is_one_node || glb.groups.size() > std::size_t{kMaxCellNodes}) return;
    const EncodedFile own = encode_glb_surfaces(glb.list, file.path).front();
    if (!document.root().same(GltfDocument(own).root())) {
        throw_bad(file, "another description follows from its triangles");
    }
    const double largest = largest_coordinate(glb.list.surface.points, glb.list.surface.faces);
    compare_indices(file, glb, decode_glb_surfaces(own));
    compare_normals(file, glb, largest);
    if (glb.list.form == SurfaceForm::kBoundary) {
        compare_seam(file, glb, largest);
    } else if (glb.list.surface.sites.cols() > 0) {
        compare_sites(glb, largest);
    }
}

/// Whether a face of a file has, in single precision, the corners of a face of a mesh.
bool same_corners(const space::TileSurface& surface, const SurfaceMesh& mesh, int f) {
    const auto found = surface.faces[f];
    const auto wanted = mesh.faces[f];
    return std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), [&](int v, int w) {
        return surface.points[v].cast<float>() == mesh.points[w].cast<float>();
    });
}

}  // namespace

void require_same_surfaces(const GlbSurfaces& glb, const GltfSurface& surface) {
    const space::TileSurface& found = glb.list.surface;
    const SurfaceMesh& mesh = surface.mesh;
    bool same = found.n_faces() == mesh.faces.n_faces();
    std::size_t g = 0;
    for (int f = 0; same && f < found.n_faces(); ++f) {
        checkpoint_each(f);
        same = same_corners(found, mesh, f);
        while (mesh.group_end(g) <= f) ++g;
        if (same && glb.groups[found.cell[f]].name != mesh.groups[g].name) {
            throw NotATile("the nodes are not the parts of the surface");
        }
    }
    if (!same) throw NotATile("the triangles are not those of the faces");
}

bool fits_single_precision(const SurfaceMesh& mesh) {
    constexpr double kResolved = 4e3;
    double smallest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        checkpoint_each(f);
        const FaceSize face(mesh.points, mesh.faces[f]);
        // A face is nowhere longer than half of its perimeter.
        smallest =
            std::min({smallest, face.shortest_edge, face.area.norm() / (face.perimeter / 2)});
    }
    return kResolved * kSingleEpsilon * largest_coordinate(mesh.points, mesh.faces) <= smallest;
}

GlbProof prove_glb_surfaces(const EncodedFile& file, const GlbSurfaces& glb) {
    const GlbProof proof = prove_closed(glb);
    compare_fields(file, glb);
    return proof;
}

}  // namespace pcvt
