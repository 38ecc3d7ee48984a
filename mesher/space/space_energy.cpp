#include "mesher/space/space_energy.hpp"

#include <algorithm>

namespace pcvt {
namespace {

/// A slab, the task of one worker, has at least this number of tetrahedra.
constexpr int kTetrahedraPerSlab = 50'000;
constexpr int kMostSlabs = 32;

/// One task of the pass: a range of tetrahedra and the sums at the sites of their corners.
struct Slab {
    int first;
    int end;
    /// The range of sites at which the tetrahedra have corners, and the sums at these: gradient and
    /// volume, four numbers a site.
    SiteId first_site = 0;
    std::vector<double> sums = {};
    double value = 0;
    SpaceSuspects suspects = {};

    void find_sites(const TorusTetrahedra& tetrahedra);
    void run(const TorusTetrahedra& tetrahedra, const Points3& coordinates,
             const SpaceFrame& frame);

   private:
    void add_suspects(int t, const TetrahedronBlock& block, int k);
    void scatter(const TorusTetrahedra& tetrahedra, int at, int n, const TetrahedronBlock& block);
};

void gather(const TorusTetrahedra& tetrahedra, const Points3& coordinates, int at, int n,
            TetrahedronBlock& block) {
    const SiteId* site = tetrahedra.corner_sites().data() + 4 * std::size_t(at);
    const TetrahedronOffsets* offsets = tetrahedra.corner_offsets().data() + at;
    const double* const u = coordinates.data();
    for (int k = 0; k < n; ++k, site += 4) {
        const double* const origin = u + 3 * std::size_t(site[0]);
        for (int c = 0; c < 3; ++c) {
            const double* const corner = u + 3 * std::size_t(site[c + 1]);
            for (int axis = 0; axis < 3; ++axis) {
                block.corner[c][axis][k] = corner[axis] - origin[axis];
            }
        }
        if (offsets[k].all_zero()) continue;
        for (int c = 0; c < 9; ++c) block.corner[c / 3][c % 3][k] += offsets[k].relative[c];
    }
    // Fill up an incomplete block with tetrahedra that cause no division by zero.
    for (int k = n; k < TetrahedronBlock::kSize; ++k) {
        for (int c = 0; c < 9; ++c) block.corner[c / 3][c % 3][k] = c / 3 == c % 3 ? 1 : 0;
    }
}

void Slab::find_sites(const TorusTetrahedra& tetrahedra) {
    const auto corners =
        tetrahedra.corner_sites().subspan(4 * std::size_t(first), 4 * std::size_t(end - first));
    const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
    first_site = *least;
    sums.assign(4 * std::size_t(*greatest - *least + 1), 0);
}

void Slab::run(const TorusTetrahedra& tetrahedra, const Points3& coordinates,
               const SpaceFrame& frame) {
    find_sites(tetrahedra);
    TetrahedronBlock block;
    for (int at = first; at < end; at += TetrahedronBlock::kSize) {
        const int n = std::min(TetrahedronBlock::kSize, end - at);
        gather(tetrahedra, coordinates, at, n, block);
        block.compute(frame);
        for (int k = 0; k < n; ++k) {
            if (!(block.thick[k] > 0)) block.correct(k, frame);
        }
        scatter(tetrahedra, at, n, block);
    }
}

void Slab::scatter(const TorusTetrahedra& tetrahedra, int at, int n,
                   const TetrahedronBlock& block) {
    const SiteId* site = tetrahedra.corner_sites().data() + 4 * std::size_t(at);
    double part = 0;
    for (int k = 0; k < n; ++k, site += 4) {
        if (!(block.certain[k] > 0)) add_suspects(at + k, block, k);
        part += block.value[k];
        for (int c = 0; c < 4; ++c) {
            double* const sum = sums.data() + 4 * std::size_t(site[c] - first_site);
            sum[0] += block.gradient[c][0][k];
            sum[1] += block.gradient[c][1][k];
            sum[2] += block.gradient[c][2][k];
            sum[3] += block.volume[c][k];
        }
    }
    value += part;
}

/// Collects the elements of lane k that the block could not certify.
void Slab::add_suspects(int t, const TetrahedronBlock& block, int k) {
    if (!(block.thick[k] > 0)) suspects.tetrahedra.push_back(t);
    for (int f = 0; f < 4; ++f) {
        if (!(block.inside[f][k] > 0)) suspects.facets.push_back(4 * t + f);
    }
}

void add(const Slab& slab, SpaceEnergy& energy) {
    const auto n = static_cast<SiteId>(slab.sums.size() / 4);
    for (SiteId s = 0; s < n; ++s) {
        const double* const sum = slab.sums.data() + 4 * std::size_t(s);
        const Eigen::Index site = slab.first_site + s;
        for (int axis = 0; axis < 3; ++axis) energy.gradient[3 * site + axis] += sum[axis];
        energy.volume[site] += sum[3];
    }
    energy.value += slab.value;
}

void append(std::vector<int>& list, const std::vector<int>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

SpaceSuspects evaluate_space_energy(const TorusTetrahedra& tetrahedra, const Points3& coordinates,
                                    const SpaceFrame& frame, Workers& workers,
                                    SpaceEnergy& energy) {
    const int n_all = tetrahedra.n_tetrahedra();
    const int n_slabs = std::clamp(n_all / kTetrahedraPerSlab, 1, kMostSlabs);
    std::vector<Slab> slabs;
    for (int k = 0; k < n_slabs; ++k) {
        const auto limit = [&](int s) {
            return static_cast<int>(std::int64_t{n_all} * s / n_slabs);
        };
        slabs.push_back({.first = limit(k), .end = limit(k + 1)});
    }
    workers.for_each(n_slabs, [&](int k) { slabs[k].run(tetrahedra, coordinates, frame); });
    // Add up in the order of the slabs.
    energy.value = 0;
    energy.gradient.setZero(3 * coordinates.cols());
    energy.volume.setZero(coordinates.cols());
    SpaceSuspects suspects;
    for (const Slab& slab : slabs) {
        add(slab, energy);
        append(suspects.tetrahedra, slab.suspects.tetrahedra);
        append(suspects.facets, slab.suspects.facets);
    }
    return suspects;
}

}  // namespace pcvt
