#include "io/gltf/glb_mesh_fields.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/forms/space_surface.hpp"
#include "io/gltf/glb_mesh_writer.hpp"
#include "io/gltf/gltf_document.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt {
namespace {

constexpr double kSingle = std::numeric_limits<float>::epsilon();
constexpr double kDouble = std::numeric_limits<double>::epsilon();

space::Vec3 wide(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

/// One face of a part: the fan of triangles round its first vertex.
struct Fan {
    std::vector<space::Vec3> points = {};
    space::Vec3 normal = space::Vec3::Zero();
    /// The sum of the area vectors of its triangles.
    space::Vec3 area = space::Vec3::Zero();
    double perimeter = 0;

    space::Vec3 centre() const {
        space::Vec3 sum = space::Vec3::Zero();
        for (const space::Vec3& p : points) sum += p;
        return sum / double(points.size());
    }
    /// The error of a direction by errors of the corners of this size; infinite for a face without
    /// area.
    double tilt(double error) const {
        const double moved = perimeter + 2 * error * double(points.size());
        return area.norm() > 0 ? error * moved / area.norm()
                               : std::numeric_limits<double>::infinity();
    }
};

std::vector<Fan> fans_of(const GlbPart& part) {
    std::vector<Fan> fans;
    int first = -1;
    for (std::size_t c = 0; c < part.corners.size(); c += 3) {
        const space::Vec3 p = wide(part.corners[c]);
        const space::Vec3 q = wide(part.corners[c + 1]);
        const space::Vec3 r = wide(part.corners[c + 2]);
        if (part.vertices[c] != first) {
            first = part.vertices[c];
            Fan& fan = fans.emplace_back();
            fan.points = {p, q};
            fan.normal = wide(part.normals[first]);
        }
        fans.back().points.push_back(r);
        fans.back().area += (q - p).cross(r - p) / 2;
    }
    for (Fan& fan : fans) {
        for (std::size_t k = 0; k < fan.points.size(); ++k) {
            fan.perimeter += (fan.points[(k + 1) % fan.points.size()] - fan.points[k]).norm();
        }
    }
    return fans;
}

/// The numbers I, J, K of "seam_I_J_K"; zero for another name.
space::Offset offset_in(const std::string& name) {
    space::Offset offset{};
    const char* at = name.data() + std::min(name.size(), std::string_view("seam_").size());
    const char* const end = name.data() + name.size();
    for (int* number : {&offset.i, &offset.j, &offset.k}) {
        const auto [stop, fault] = std::from_chars(at, end, *number);
        if (fault != std::errc()) return {};
        at = std::min(stop + 1, end);
    }
    return offset;
}

/// The surfaces as encode_glb_mesh() takes them; no faces share points.
SurfaceMesh mesh_of(const GlbSurfaces& glb) {
    SurfaceList list{.form = glb.form, .surface = {.lattice = glb.lattice}};
    space::TileSurface& surface = list.surface;
    surface.sites = glb.sites;
    for (int s = 0; s < static_cast<int>(glb.parts.size()); ++s) {
        for (const Fan& fan : fans_of(glb.parts[s])) {
            for (const space::Vec3& p : fan.points) {
                surface.faces.corners.push_back(static_cast<int>(surface.points.size()));
                surface.points.push_back(p);
            }
            surface.faces.close();
            surface.cell.push_back(s);
            if (glb.form == SurfaceForm::kBoundary) {
                surface.offset.push_back(offset_in(glb.parts[s].name));
            }
        }
    }
    return surface_mesh(std::move(list), SeamForm::kNone);
}

double largest_coordinate(const GlbSurfaces& glb) {
    double largest = 0;
    for (const GlbPart& part : glb.parts) {
        for (const auto& corner : part.corners) {
            largest = std::max(largest, wide(corner).cwiseAbs().maxCoeff());
        }
    }
    return largest;
}

void compare_normals(const EncodedFile& file, const GlbPart& part, double largest) {
    const std::vector<Fan> fans = fans_of(part);
    std::size_t v = 0;
    for (const Fan& fan : fans) {
        const double tolerance = 4 * (kSingle + fan.tilt(kSingle * largest));
        for (std::size_t k = 0; k < fan.points.size(); ++k, ++v) {
            const space::Vec3 normal = wide(part.normals[v]);
            if ((normal - fan.area.stableNormalized()).norm() <= tolerance) continue;
            // A face below the rounding has any direction.
            if (tolerance > 1 && normal == fan.normal) continue;
            throw BadFile(file.path + ": a normal of " + part.name +
                          " is not that of its face; write the file again with pcvt");
        }
    }
}

/// The mean of the centres of the faces of a part.
space::Vec3 middle_of(const GlbPart& part) {
    space::Vec3 sum = space::Vec3::Zero();
    const std::vector<Fan> fans = fans_of(part);
    for (const Fan& fan : fans) sum += fan.centre();
    return sum / double(fans.size());
}

/// Each side of the seam plus its translation is the other side.
void compare_seam(const EncodedFile& file, const GlbSurfaces& glb, double largest) {
    std::map<space::Offset, space::Vec3> middles;
    for (const GlbPart& part : glb.parts) middles[offset_in(part.name)] = middle_of(part);
    for (const auto& [offset, middle] : middles) {
        const auto other = middles.find(-offset);
        const space::Vec3 there = middle + glb.lattice.translation(offset);
        if (other != middles.end() && (other->second - there).norm() <= 4 * kSingle * largest) {
            continue;
        }
        throw BadFile(file.path + ": " + seam_name(offset) +
                      " does not meet the other side by its translation; write the file again "
                      "with pcvt");
    }
}

/// The sites of the torus, found by their position.
class SiteImages {
   public:
    SiteImages(const space::Lattice& lattice, const space::Points& sites) : lattice_(lattice) {
        for (const auto& site : sites.colwise()) {
            const space::Vec3 u = lattice.to_lattice(site);
            sorted_.insert({u.x() - std::floor(u.x()), space::Vec3(site)});
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
            auto found = sorted_.lower_bound({at + turn - width, space::Vec3::Zero()});
            for (; found != sorted_.end() && found->first <= at + turn + width; ++found) {
                const space::Vec3 difference = lattice_.to_lattice(point - found->second);
                const space::Vec3 rest = difference - space::Vec3(difference.array().round());
                if (lattice_.to_position(rest).norm() <= distance) return true;
            }
            return false;
        });
    }

   private:
    struct Before {
        bool operator()(const std::pair<double, space::Vec3>& s,
                        const std::pair<double, space::Vec3>& t) const {
            return s.first < t.first;
        }
    };
    static constexpr std::array<double, 3> kTurns{-1, 0, 1};

    const space::Lattice& lattice_;
    std::multiset<std::pair<double, space::Vec3>, Before> sorted_;
};

void compare_sites(const GlbSurfaces& glb, double largest) {
    if (glb.sites.cols() != static_cast<Eigen::Index>(glb.parts.size())) {
        throw_violation(kSiteLaw, "there are " + std::to_string(glb.sites.cols()) + " sites of " +
                                      std::to_string(glb.parts.size()) + " cells");
    }
    const SiteImages images(glb.lattice, glb.sites);
    // Proved corners lie at most this far off the planes between sites.
    const double off =
        space::kBisectorTolerance * portable_cbrt(glb.lattice.volume() / double(glb.parts.size()));
    for (std::size_t s = 0; s < glb.parts.size(); ++s) {
        checkpoint();
        const space::Vec3 site = glb.sites.col(static_cast<Eigen::Index>(s));
        for (const Fan& fan : fans_of(glb.parts[s])) {
            const space::Vec3 arm = fan.centre() - site;
            const double height = arm.dot(fan.normal);
            const double tilt = kSingle + fan.tilt(off);
            const double tolerance = 4 * (kSingle * largest + tilt * arm.norm());
            // The rounding of corners may move a plane to the other side of a site near it.
            if (height > -tolerance && images.any_at(site + 2 * height * fan.normal, tolerance)) {
                continue;
            }
            throw_violation(kSiteLaw, "the site of " + glb.parts[s].name +
                                          ", mirrored in a face of its cell, is no site");
        }
    }
}

}  // namespace

void compare_glb_surfaces(const EncodedFile& file, const GlbSurfaces& glb) {
    const GltfDocument document(file);
    const bool is_own =
        GltfDocument::member(GltfDocument::member(document.root(), "asset"), "generator") == "pcvt";
    const bool is_one_node =
        glb.parts.front().name == "cells" || glb.parts.front().name == "boundary";
    if (!is_own || is_one_node || glb.parts.size() > std::size_t{kMaxCellNodes}) return;
    const EncodedFile own = encode_glb_mesh(mesh_of(glb), file.path).front();
    if (!document.root().same(GltfDocument(own).root())) {
        throw BadFile(file.path +
                      ": another description follows from its triangles; write the file again "
                      "with pcvt");
    }
    const GlbSurfaces expected = decode_glb_surfaces(own);
    const double largest = largest_coordinate(glb);
    for (std::size_t k = 0; k < glb.parts.size(); ++k) {
        if (glb.parts[k].vertices != expected.parts[k].vertices) {
            throw BadFile(file.path + ": the indices of " + glb.parts[k].name +
                          " are no fans; write the file again with pcvt");
        }
        compare_normals(file, glb.parts[k], largest);
    }
    if (glb.form == SurfaceForm::kBoundary) compare_seam(file, glb, largest);
    if (glb.form == SurfaceForm::kCells && glb.sites.cols() > 0) compare_sites(glb, largest);
}

}  // namespace pcvt
