#include "mesher/plane/proof/face_images.hpp"

#include <string>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/torus/offset_disjoint_sets.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

/// Some faces of one site, joined by edges.
struct Part {
    /// The image of the first face to which more than half of the area belongs, and how much more.
    Offset image = {};
    double lead = 0;
    bool goes_round = false;
};

class FaceImageSearch {
   public:
    FaceImageSearch(const Tile& tile, const GluedFaces& faces, const SiteImages& images,
                    const FaceImageOptions& options)
        : tile_(tile),
          faces_(faces),
          images_(images),
          options_(options),
          part_(static_cast<std::size_t>(faces.n_faces())) {
        found_.is_unclear.resize(part_.size(), false);
    }

    GluedImages find() {
        join_faces();
        find_images();
        require_first_faces();
        return std::move(found_);
    }

   private:
    SiteId site(int f) const { return tile_.face_site[faces_.file_face[f]]; }
    int face_across(int h) const { return faces_.face_of[faces_.opposite[h]]; }
    /// The image that the face across h names, as the face of h sees it.
    Offset seen_across(int h, Offset image) const {
        return image - images_.of_tile(faces_.across[h]);
    }

    Vec2 middle_of(int f) const {
        Vec2 sum(0, 0);
        for (const int v : faces_[f]) sum += tile_.points[v];
        return sum / faces_.size(f);
    }

    /// Whether a translation leads from a cell's half at a wall to the half beyond the wall; also
    /// (0, 0).
    bool is_cut_only_by_walls(Offset across) const {
        return (across.i == 0 || has_walls_across(options_.walls, 0)) &&
               (across.j == 0 || has_walls_across(options_.walls, 1));
    }
    /// Joins the faces of each site across the edges between them. A whole cell has no seam inside.
    void join_faces() {
        OffsetDisjointSets<Offset> joined(faces_.n_faces());
        const auto within = [&](int h) {
            return faces_.opposite[h] > h && site(faces_.face_of[h]) == site(face_across(h)) &&
                   (options_.is_box || is_cut_only_by_walls(faces_.across[h]));
        };
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (within(h)) joined.join(faces_.face_of[h], face_across(h), seen_across(h, {}));
        }
        for (int f = 0; f < faces_.n_faces(); ++f) part_[f] = joined.root(f);
        parts_.resize(part_.size());
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (!within(h)) continue;
            const auto& here = part_[faces_.face_of[h]];
            const auto& there = part_[face_across(h)];
            if (here.offset != seen_across(h, there.offset)) parts_[here.orbit].goes_round = true;
        }
    }

    /// @returns for each site, whether its cells touch each other.
    std::vector<bool> sites_that_touch() const {
        const auto n = static_cast<std::size_t>(images_.n_sites());
        std::vector<int> n_parts(n, 0);
        std::vector<bool> touches(n, false);
        for (int f = 0; f < faces_.n_faces(); ++f) {
            if (part_[f].orbit != f) continue;
            ++n_parts[site(f)];
            if (parts_[f].goes_round) touches[site(f)] = true;
        }
        for (std::size_t s = 0; s < n; ++s) {
            if (n_parts[s] > images_.copies()) {
                throw_violation(kSiteLaw, "the faces of site " + to_string(s) + " form " +
                                              to_string(n_parts[s]) + " parts, more than the " +
                                              to_string(images_.copies()) + " periods of the tile");
            }
            if (n_parts[s] < images_.copies()) touches[s] = true;
        }
        return touches;
    }

    void find_images() {
        const std::vector<bool> touches = sites_that_touch();
        found_.image.resize(part_.size());
        for (int f = 0; f < faces_.n_faces(); ++f) {
            checkpoint_each(f);
            if (touches[site(f)]) {
                choose_side(f);
            } else {
                vote(f);
            }
        }
        for (int f = 0; f < faces_.n_faces(); ++f) {
            if (touches[site(f)]) continue;
            found_.image[f] = parts_[part_[f].orbit].image + part_[f].offset;
        }
        require_each_image();
    }

    /// The side of the corner of a face, or of its middle, that is farthest from all bisectors.
    void choose_side(int f) {
        double deepest = -1;
        const auto compare = [&](const Vec2& p) {
            const SiteImages::Side side = images_.side_of(site(f), p);
            if (!(side.depth > deepest)) return;
            deepest = side.depth;
            found_.image[f] = side.offset;
        };
        compare(middle_of(f));
        for (const int v : faces_[f]) compare(tile_.points[v]);
        found_.is_unclear[f] = deepest < options_.reach;
    }

    /// Counts the area of a face for the nearest image of its site (Boyer and Moore's majority).
    void vote(int f) {
        Part& part = parts_[part_[f].orbit];
        const Offset image = images_.nearest(site(f), middle_of(f)) - part_[f].offset;
        const double area = polygon_area(face_polygon(tile_.points, faces_[f]));
        if (part.image == image) {
            part.lead += area;
            return;
        }
        part.lead -= area;
        if (part.lead >= 0) return;
        part.image = image;
        part.lead = -part.lead;
    }

    /// An unclear face may be that of any image of its site.
    void require_each_image() const {
        const auto n_copies = static_cast<std::size_t>(images_.copies());
        std::vector<bool> found(static_cast<std::size_t>(images_.n_sites()) * n_copies, false);
        std::vector<bool> is_unclear(static_cast<std::size_t>(images_.n_sites()), false);
        for (int f = 0; f < faces_.n_faces(); ++f) {
            found[std::size_t(site(f)) * n_copies + images_.copy_of(found_.image[f])] = true;
            if (found_.is_unclear[f]) is_unclear[site(f)] = true;
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (found[k] || is_unclear[k / n_copies]) continue;
            throw_violation(kSiteLaw, "site " + to_string(k / n_copies) +
                                          " has no cell in one of the periods of the tile");
        }
    }

    /// Law (4).
    void require_first_faces() const {
        std::vector<bool> seen(static_cast<std::size_t>(images_.n_sites()), false);
        for (int f = 0; f < faces_.n_faces(); ++f) {
            if (seen[site(f)]) continue;
            seen[site(f)] = true;
            if (found_.image[f] == Offset{} || found_.is_unclear[f]) continue;
            throw_violation(kSiteLaw, "face " + to_string(faces_.file_face[f]) +
                                          ", the first of site " + to_string(site(f)) +
                                          ", belongs to another image of the site");
        }
    }

    const Tile& tile_;
    const GluedFaces& faces_;
    const SiteImages& images_;
    FaceImageOptions options_;
    /// For each face, the first face of its part, and the image of its site where that face has
    /// (0, 0).
    std::vector<OffsetDisjointSets<Offset>::Root> part_;
    /// For each face that is the first of its part.
    std::vector<Part> parts_;
    GluedImages found_;
};

}  // namespace

GluedImages find_face_images(const Tile& tile, const GluedFaces& faces, const SiteImages& images,
                             const FaceImageOptions& options) {
    return FaceImageSearch(tile, faces, images, options).find();
}

}  // namespace pcvt::plane
