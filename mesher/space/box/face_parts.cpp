#include "mesher/space/box/face_parts.hpp"

#include <cstddef>

namespace pcvt::space {
namespace {

/// A face and a plane.
class DividedFace {
   public:
    explicit DividedFace(std::span<const SidedCorner> corners) : corners_(corners) {
        int side_before = 0;
        for (const SidedCorner& corner : corners) {
            if (corner.side != 0) side_before = corner.side;
        }
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const int side = corners[k].side;
            if (side == 0) {
                on_.push_back(corners[k].image);
                n_chains_ += before(k) != 0 ? 1 : 0;
                continue;
            }
            n_changes_ += side != side_before ? 1 : 0;
            side_before = side;
            (side < 0 ? has_below_ : has_above_) = true;
        }
    }

    FaceParts parts(const std::function<bool(std::span<const VertexImage>)>& is_flat) const {
        FaceParts parts;
        const bool is_cut = has_below_ && has_above_;
        parts.is_sound = is_cut ? n_chains_ == 2 && n_changes_ == 2 : n_chains_ <= 1;
        const bool lies_inside = !has_below_ && !has_above_;
        const bool has_flat_part = !lies_inside && on_.size() > 2 && is_flat(on_);
        if (lies_inside || has_flat_part) parts.inside = on_;
        // A chain of corners on the plane belongs to one part, if it does not bound a flat one.
        if (has_below_) parts.below = part(-1, is_cut || has_flat_part);
        if (has_above_) parts.above = part(1, has_flat_part);
        return parts;
    }

   private:
    int before(std::size_t k) const { return corners_[k == 0 ? corners_.size() - 1 : k - 1].side; }
    int after(std::size_t k) const { return corners_[k + 1 == corners_.size() ? 0 : k + 1].side; }

    /// The corners on a side and those on the plane, of these perhaps only the ones beside a corner
    /// on that side.
    std::vector<VertexImage> part(int side, bool only_ends) const {
        std::vector<VertexImage> part;
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            const int here = corners_[k].side;
            const bool is_end = before(k) == side || after(k) == side;
            if (here == side || (here == 0 && (is_end || !only_ends))) {
                part.push_back(corners_[k].image);
            }
        }
        return part;
    }

    std::span<const SidedCorner> corners_;
    std::vector<VertexImage> on_;
    /// The chains of corners on the plane, and how often the face changes its side.
    int n_chains_ = 0;
    int n_changes_ = 0;
    bool has_below_ = false;
    bool has_above_ = false;
};

}  // namespace

FaceParts face_parts(std::span<const SidedCorner> corners,
                     const std::function<bool(std::span<const VertexImage>)>& is_flat) {
    return DividedFace(corners).parts(is_flat);
}

}  // namespace pcvt::space
