#include "mesher/space/space_energy.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcvt {
namespace {

/// A slab, the task of one worker, has at least this number of tetrahedra.
constexpr int kTetrahedraPerSlab = 50'000;
constexpr int kMostSlabs = 32;
/// Contributions of this many mean cells lose four bits in the sum of a site.
constexpr double kLargest = 16;

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

/// Fills up an incomplete block with tetrahedra that cause no division by zero.
void fill_up(TetrahedronBlock& block, int n) {
    for (int k = n; k < TetrahedronBlock::kSize; ++k) {
        for (int c = 0; c < 9; ++c) block.corner[c / 3][c % 3][k] = c / 3 == c % 3 ? 1 : 0;
    }
}

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
    fill_up(block, n);
}

void gather(std::span<const Tetrahedron> tetrahedra, const Points3& coordinates,
            TetrahedronBlock& block) {
    for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
        const Vec3 origin = image(coordinates, tetrahedra[k][0]).at;
        for (int c = 0; c < 3; ++c) {
            const Vec3 edge = image(coordinates, tetrahedra[k][c + 1]).at - origin;
            for (int axis = 0; axis < 3; ++axis) block.corner[c][axis][k] = edge[axis];
        }
    }
    fill_up(block, static_cast<int>(tetrahedra.size()));
}

/// Computes a block whose first n tetrahedra count.
void compute(TetrahedronBlock& block, int n, const SpaceFrame& frame) {
    block.compute(frame);
    for (int k = 0; k < n; ++k) {
        if (!(block.thick[k] > 0)) block.correct(k, frame);
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
        compute(block, n, frame);
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

/// Removes the tetrahedra that are in both lists from both.
void cancel_common(std::vector<Tetrahedron>& one, std::vector<Tetrahedron>& other) {
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    std::vector<Tetrahedron> only_one;
    std::vector<Tetrahedron> only_other;
    std::set_difference(one.begin(), one.end(), other.begin(), other.end(),
                        std::back_inserter(only_one));
    std::set_difference(other.begin(), other.end(), one.begin(), one.end(),
                        std::back_inserter(only_other));
    one = std::move(only_one);
    other = std::move(only_other);
}

/// Adds the contribution of tetrahedron k of a block to an energy, times 1 or -1.
void add(const TetrahedronBlock& block, int k, const Tetrahedron& corners, double sign,
         SpaceEnergy& energy) {
    energy.value += sign * block.value[k];
    for (int c = 0; c < 4; ++c) {
        const SiteId site = corners[c].site;
        for (int axis = 0; axis < 3; ++axis) {
            energy.gradient[3 * Eigen::Index{site} + axis] += sign * block.gradient[c][axis][k];
        }
        energy.volume[site] += sign * block.volume[c][k];
    }
}

/// Adds the contributions of tetrahedra, times 1 or -1.
/// @returns false if one is too large.
bool add_tetrahedra(std::span<const Tetrahedron> tetrahedra, double sign,
                    const Points3& coordinates, const SpaceFrame& frame, SpaceEnergy& energy) {
    const double mean_cell = 1.0 / static_cast<double>(coordinates.cols());
    const double largest_volume = kLargest * mean_cell * frame.volume();
    const double largest_value = kLargest * mean_cell * energy.value;
    TetrahedronBlock block;
    while (!tetrahedra.empty()) {
        const auto part =
            tetrahedra.first(std::min<std::size_t>(tetrahedra.size(), TetrahedronBlock::kSize));
        const int n = static_cast<int>(part.size());
        gather(part, coordinates, block);
        compute(block, n, frame);
        for (int k = 0; k < n; ++k) {
            bool small = std::abs(block.value[k]) <= largest_value;
            for (const auto& volume : block.volume) {
                small = small && std::abs(volume[k]) <= largest_volume;
            }
            if (!small) return false;
            add(block, k, part[k], sign, energy);
        }
        tetrahedra = tetrahedra.subspan(part.size());
    }
    return true;
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

bool correct_space_energy(ExchangedTetrahedra exchanged, const Points3& coordinates,
                          const SpaceFrame& frame, SpaceEnergy& energy) {
    cancel_common(exchanged.removed, exchanged.added);
    return add_tetrahedra(exchanged.removed, -1, coordinates, frame, energy) &&
           add_tetrahedra(exchanged.added, 1, coordinates, frame, energy);
}

}  // namespace pcvt
