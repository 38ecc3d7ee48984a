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
#include "io/gltf/gltf_document.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_sites.hpp"

namespace pcvt {
namespace {

using Points = std::vector<space::Vec3>;

constexpr double kSingle = std::numeric_limits<float>::epsilon();
constexpr double kDouble = std::numeric_limits<double>::epsilon();

/// The measures of a face.
struct FaceSize {
    space::Vec3 centre = space::Vec3::Zero();
    /// The sum of the area vectors of its triangles.
    space::Vec3 area = space::Vec3::Zero();
    double perimeter = 0;
    double shortest_edge = std::numeric_limits<double>::infinity();
    int n_corners;

    FaceSize(const Points& points, std::span<const int> face)
        : n_corners(static_cast<int>(face.size())) {
        const space::Vec3& first = points[face.front()];
        space::Vec3 from = points[face.back()];
        for (const int v : face) {
            const space::Vec3& to = points[v];
            centre += to;
            area += (from - first).cross(to - first) / 2;
            perimeter += (to - from).norm();
            shortest_edge = std::min(shortest_edge, (to - from).norm());
            from = to;
        }
        centre /= double(n_corners);
    }
    /// The error of a direction by errors of the corners of this size; infinite for a face without
    /// area.
    double tilt(double error) const {
        const double moved = perimeter + 2 * error * n_corners;
        return area.norm() > 0 ? error * moved / area.norm()
                               : std::numeric_limits<double>::infinity();
    }
};

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
    proof.tolerance = kSingle * largest_coordinate(points, surface.faces) * area;
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

space::Vec3 stated_normal(const GlbSurfaces& glb, int v) {
    const auto& [x, y, z] = glb.normals[v];
    return {x, y, z};
}

void compare_normals(const EncodedFile& file, const GlbSurfaces& glb, double largest) {
    const space::TileSurface& surface = glb.list.surface;
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const FaceSize face(surface.points, surface.faces[f]);
        const space::Vec3 wanted = face.area.stableNormalized();
        const space::Vec3 first = stated_normal(glb, surface.faces[f].front());
        const double tolerance = 4 * (kSingle + face.tilt(kSingle * largest));
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
        if (other != middles.end() && (other->second - there).norm() <= 4 * kSingle * largest) {
            continue;
        }
        throw_bad(file, seam_name(offset) + " does not meet the other side by its translation");
    }
}

/// The sites of the torus, found by their position.
class SiteImages {
   public:
    SiteImages(const space::Lattice& lattice, const space::Points& sites) : lattice_(lattice) {
        for (const auto& site : sites.colwise()) {
            const space::Vec3 u = lattice.to_lattice(site);
            sorted_.emplace(u.x() - std::floor(u.x()), site);
        }
    }

    /// Whether an image of a site lies within `distance` of a point.
    bool any_at(const space::Vec3& point, double distance) const {
        const space::Vec3 u = lattice_.to_lattice(point);
        const double at = u.x() - std::floor(u.x());
        // The first lattice coordinate changes by at most this much.
        const space::Vec3 across = lattice_.b().cross(lattice_.c());
        const double width = distance * across.norm() / lattice_.volume() + 4 * kDouble;
        return std::any_of(kTurns.begin(), kTurns.end(), [&](double turn) {
            auto found = sorted_.lower_bound(at + turn - width);
            for (; found != sorted_.end() && found->first <= at + turn + width; ++found) {
                const space::Vec3 difference = lattice_.to_lattice(point - found->second);
                const space::Vec3 rest = difference - space::Vec3(difference.array().round());
                if (lattice_.to_position(rest).norm() <= distance) return true;
            }
            return false;
        });
    }

   private:
    static constexpr std::array<double, 3> kTurns{-1, 0, 1};

    const space::Lattice& lattice_;
    std::multimap<double, space::Vec3> sorted_;
};

void compare_sites(const GlbSurfaces& glb, double largest) {
    const space::TileSurface& surface = glb.list.surface;
    const std::size_t n_cells = glb.groups.size();
    if (surface.sites.cols() != static_cast<Eigen::Index>(n_cells)) {
        throw_violation(kSiteLaw, "there are " + std::to_string(surface.sites.cols()) +
                                      " sites of " + std::to_string(n_cells) + " cells");
    }
    const SiteImages images(surface.lattice, surface.sites);
    // Proved corners lie at most this far off the planes between sites.
    const double off =
        space::kBisectorTolerance * portable_cbrt(surface.lattice.volume() / double(n_cells));
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const FaceSize face(surface.points, surface.faces[f]);
        const space::Vec3 normal = stated_normal(glb, surface.faces[f].front());
        const space::Vec3 site = surface.sites.col(surface.cell[f]);
        const space::Vec3 arm = face.centre - site;
        const double height = arm.dot(normal);
        const double tilt = kSingle + face.tilt(off);
        const double tolerance = 4 * (kSingle * largest + tilt * arm.norm());
        // The rounding of corners may move a plane to the other side of a site near it.
        if (height > -tolerance && images.any_at(site + 2 * height * normal, tolerance)) continue;
        throw_violation(kSiteLaw, "the site of " + glb.groups[surface.cell[f]].name +
                                      ", mirrored in a face of its cell, is not a site");
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
    return kResolved * kSingle * largest_coordinate(mesh.points, mesh.faces) <= smallest;
}

GlbProof prove_glb_surfaces(const EncodedFile& file, const GlbSurfaces& glb) {
    const GlbProof proof = prove_closed(glb);
    compare_fields(file, glb);
    return proof;
}

}  // namespace pcvt
