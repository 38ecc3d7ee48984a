#include "mesher/space/mesh/seam_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

/// The boundary faces by the lattice coordinates of their mean corners, wrapped, in boxes.
class FaceBoxes {
   public:
    FaceBoxes(const PolyhedralMesh& mesh, double tolerance) : mesh_(mesh) {
        const int n = mesh.n_faces() - mesh.n_inner_faces();
        n_boxes_ = std::max(1, static_cast<int>(portable_cbrt(double(n))));
        // The means of partners differ by less than the boxes are wide.
        margin_ = 4 * tolerance / mesh.lattice.heights().minCoeff();
        for (int f = mesh.n_inner_faces(); f < mesh.n_faces(); ++f) {
            checkpoint_each(f);
            Vec3 mean = Vec3::Zero();
            for (const int v : mesh.faces[f]) mean += mesh.points[v];
            means_.push_back(mesh.lattice.to_lattice(mean / mesh.faces.size(f)));
            boxes_.emplace_back(box_of(means_.back(), Vec3::Zero()), f);
        }
        std::sort(boxes_.begin(), boxes_.end());
    }

    const Vec3& mean(int f) const { return means_[f - mesh_.n_inner_faces()]; }

    /// Calls visit(face) for the faces whose wrapped means may equal that of a face.
    template <class Visit>
    void visit_near(int f, const Visit& visit) const {
        std::vector<int> seen;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 step(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            const int box = box_of(mean(f), margin_ * step);
            if (std::find(seen.begin(), seen.end(), box) != seen.end()) continue;
            seen.push_back(box);
            auto found = std::lower_bound(boxes_.begin(), boxes_.end(), std::pair(box, -1));
            for (; found != boxes_.end() && found->first == box; ++found) visit(found->second);
        }
    }

   private:
    int box_of(const Vec3& mean, const Vec3& step) const {
        int box = 0;
        for (int k = 0; k < 3; ++k) {
            const double u = mean[k] + step[k];
            const int index = static_cast<int>((u - std::floor(u)) * n_boxes_);
            box = box * n_boxes_ + std::min(index, n_boxes_ - 1);
        }
        return box;
    }

    const PolyhedralMesh& mesh_;
    int n_boxes_ = 1;
    double margin_ = 0;
    std::vector<Vec3> means_;
    std::vector<std::pair<int, int>> boxes_;
};

/// Returns the pair of two faces if the second is a translation of the first.
std::optional<FacePair> matched(const PolyhedralMesh& mesh, int f, int g, const Vec3& gap,
                                double tolerance) {
    const auto here = mesh.faces[f];
    const auto there = mesh.faces[g];
    if (here.size() != there.size()) return std::nullopt;
    const Offset offset{int(std::lround(gap.x())), int(std::lround(gap.y())),
                        int(std::lround(gap.z()))};
    if (offset == Offset{}) return std::nullopt;
    const Vec3 translation = mesh.lattice.translation(offset);
    const int n = static_cast<int>(here.size());
    const auto answers = [&](int start) {
        for (int k = 0; k < n; ++k) {
            const Vec3& v = mesh.points[here[k]];
            const Vec3& w = mesh.points[there[(start - k + n) % n]];
            if (!((v + translation - w).cwiseAbs().maxCoeff() <= tolerance)) return false;
        }
        return true;
    };
    for (int start = 0; start < n; ++start) {
        if (answers(start)) return FacePair{f, g, offset, start};
    }
    return std::nullopt;
}

}  // namespace

std::vector<FacePair> seam_pairs(const PolyhedralMesh& mesh, double tolerance) {
    const FaceBoxes boxes(mesh, tolerance);
    std::vector<FacePair> pairs;
    for (int f = mesh.n_inner_faces(); f < mesh.n_faces(); ++f) {
        checkpoint_each(f, 64);
        int n_found = 0;
        boxes.visit_near(f, [&](int g) {
            const auto pair = matched(mesh, f, g, boxes.mean(g) - boxes.mean(f), tolerance);
            if (!pair) return;
            ++n_found;
            if (pair->offset > Offset{}) pairs.push_back(*pair);
        });
        if (n_found == 1) continue;
        throw_violation("(3), seam", "face " + std::to_string(f) + " has " +
                                         (n_found == 0 ? "no partner" : "several partners"));
    }
    return pairs;
}

}  // namespace pcvt::space
