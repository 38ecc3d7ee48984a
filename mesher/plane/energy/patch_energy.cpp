#include "mesher/plane/energy/patch_energy.hpp"

#include <algorithm>

namespace pcvt::plane {

PatchPass::PatchPass(DelaunayPatch& patch, Workers& /*workers*/)
    : patch_(patch), sums_(static_cast<std::size_t>(patch.coordinates().cols())) {}

/// Adds up the terms of all triangles, and finds the halfedges whose edges are not certified.
/// @returns false if a triangle is not certified to be counter-clockwise.
bool PatchPass::run() {
    const TorusTriangulation& t = patch_.triangulation();
    value_ = 0;
    std::fill(sums_.begin(), sums_.end(), std::array<double, 3>{});
    suspects_.clear();
    TriangleBlock block;
    for (int first = 0; first < t.n_triangles(); first += TriangleBlock::kSize) {
        const int n = std::min(TriangleBlock::kSize, t.n_triangles() - first);
        block.gather(t, patch_.coordinates(), first, n);
        block.compute(patch_.frame());
        for (int k = 0; k < n; ++k) {
            if (!(block.thick[k] > 0)) return false;
            if (block.acute[k] > 0) continue;
            const int h = block.opposite_to_largest_angle(first + k, k);
            if (!patch_.is_certainly_delaunay(h)) suspects_.push_back(h);
        }
        add_terms(first, n, block);
    }
    return true;
}

void PatchPass::add_terms(int first, int n, const TriangleBlock& block) {
    const SiteId* site =
        patch_.triangulation().corner_sites().data() + 3 * static_cast<std::size_t>(first);
    const auto add = [this](SiteId s, double gx, double gy, double mass) {
        std::array<double, 3>& sums = sums_[s];
        sums[0] += gx;
        sums[1] += gy;
        sums[2] += mass;
    };
    for (int k = 0; k < n; ++k, site += 3) {
        value_ += block.value[k];
        add(site[0], block.gx0[k], block.gy0[k], block.m0[k]);
        add(site[1], block.gx1[k], block.gy1[k], block.m1[k]);
        add(site[2], block.gx2[k], block.gy2[k], block.m2[k]);
    }
}

bool PatchPass::evaluate(Energy& energy) {
    do {
        if (!run()) return false;
    } while (patch_.flip(suspects_) > 0);
    energy.value = value_;
    energy.gradient.resize(2 * patch_.n_sites());
    energy.mass.resize(patch_.n_sites());
    for (int s = 0; s < patch_.n_sites(); ++s) {
        energy.gradient[2 * s] = sums_[s][0];
        energy.gradient[2 * s + 1] = sums_[s][1];
        energy.mass[s] = sums_[s][2];
    }
    return true;
}

}  // namespace pcvt::plane
