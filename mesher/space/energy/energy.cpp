#include "mesher/space/energy/energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/space/energy/slab_sums.hpp"
#include "mesher/space/energy/tetrahedron_corners.hpp"

namespace pcvt::space {
namespace {

/// Contributions of this many mean cells lose four bits in the sum of a site.
constexpr double kLargest = 16;

constexpr Eigen::Index kNumbers = MovingTetrahedra::kNumbersPerSite;
/// The blocks of sites that one task adds up.
constexpr int kBlocksPerTask = 64;

/// The gradient and the volume of a cell; one load takes all four numbers.
struct alignas(4 * sizeof(double)) CellSums {
    std::array<double, 4> value{};
};

/// Adds the terms of the first n tetrahedra of a block.
/// @param places  of the sums at their corners, four a tetrahedron.
PCVT_TARGET_CLONES void add_terms(const TetrahedronBlock& block, const int* places, int n,
                                  CellSums* sums) {
    for (int first = 0; first < n; first += 4) {
        for (int c = 0; c < 4; ++c) {
            std::array<Quad, 4> terms;
            for (int m = 0; m < 4; ++m) {
                std::memcpy(&terms[m], &block.terms[c][m][first], sizeof terms[m]);
            }
            transpose(terms);
            for (int k = 0; k < std::min(4, n - first); ++k) {
                double* const at = sums[places[4 * (first + k) + c]].value.data();
                Quad sum;
                std::memcpy(&sum, at, sizeof sum);
                sum += terms[k];
                std::memcpy(at, &sum, sizeof sum);
            }
        }
    }
}

/// Computes a block whose first n tetrahedra count.
void compute(TetrahedronBlock& block, int n, const Frame& frame) {
    block.compute(frame);
    for (int k = 0; k < n; ++k) {
        if (!(block.thick[k] > 0)) block.correct(k, frame);
    }
}

void append(std::vector<int>& list, const std::vector<int>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

/// Adds the contribution of tetrahedron k of a block to an energy, times 1 or -1.
void add(const TetrahedronBlock& block, int k, const Tetrahedron& corners, double sign,
         Energy& energy) {
    energy.value += sign * block.value[k];
    for (int c = 0; c < 4; ++c) {
        const SiteId site = corners[c].site;
        for (int axis = 0; axis < 3; ++axis) {
            energy.gradient[kNumbers * site + axis] += sign * block.terms[c][axis][k];
        }
        energy.mass[site] += sign * block.terms[c][3][k];
    }
}

/// Adds the contributions of tetrahedra, times 1 or -1.
/// @returns false if one is too large.
bool add_tetrahedra(std::span<const Tetrahedron> tetrahedra, double sign, const Points& coordinates,
                    const Frame& frame, Energy& energy) {
    const double mean_cell = 1.0 / static_cast<double>(coordinates.cols());
    const double largest_volume = kLargest * mean_cell * frame.volume();
    const double largest_value = kLargest * mean_cell * energy.value;
    TetrahedronBlock block;
    while (!tetrahedra.empty()) {
        const auto part =
            tetrahedra.first(std::min<std::size_t>(tetrahedra.size(), TetrahedronBlock::kSize));
        const int n = static_cast<int>(part.size());
        gather_corners(part, coordinates, block.corner);
        compute(block, n, frame);
        for (int k = 0; k < n; ++k) {
            bool small = std::abs(block.value[k]) <= largest_value;
            for (const auto& terms : block.terms) {
                small = small && std::abs(terms[3][k]) <= largest_volume;
            }
            if (!small) return false;
            add(block, k, part[k], sign, energy);
        }
        tetrahedra = tetrahedra.subspan(part.size());
    }
    return true;
}

}  // namespace

/// One task of the pass: a range of tetrahedra.
struct EnergySums::Slab {
    SlabRange range = {};
    SlabSums<CellSums> sums = {};
    double value = 0;
    Suspects suspects = {};

    void run(const TorusTetrahedra& tetrahedra, const Points& coordinates, const Frame& frame,
             FacetHeights& heights);

   private:
    void add_suspects(int t, const TetrahedronBlock& block, int k);
    void scatter(const TorusTetrahedra& tetrahedra, int at, int n, const TetrahedronBlock& block);
};

void EnergySums::Slab::run(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                           const Frame& frame, FacetHeights& heights) {
    sums.clear(tetrahedra.n_sites());
    value = 0;
    suspects.tetrahedra.clear();
    suspects.facets.clear();
    TetrahedronBlock block;
    for (int at = range.first; at < range.end; at += TetrahedronBlock::kSize) {
        const int n = std::min(TetrahedronBlock::kSize, range.end - at);
        gather_corners(tetrahedra, coordinates, at, n, block.corner);
        compute(block, n, frame);
        scatter(tetrahedra, at, n, block);
        heights.keep(at, block.height);
    }
}

void EnergySums::Slab::scatter(const TorusTetrahedra& tetrahedra, int at, int n,
                               const TetrahedronBlock& block) {
    const auto corners = tetrahedra.corner_sites().subspan(4 * std::size_t(at), 4 * std::size_t(n));
    double part = 0;
    for (int k = 0; k < n; ++k) {
        if (!(block.certain[k] > 0)) add_suspects(at + k, block, k);
        part += block.value[k];
    }
    value += part;
    std::array<int, 4 * TetrahedronBlock::kSize> places;
    for (std::size_t c = 0; c < corners.size(); ++c) places[c] = sums.place(corners[c]);
    add_terms(block, places.data(), n, sums.data());
}

/// Collects the elements of lane k that are not certified without their neighbours.
void EnergySums::Slab::add_suspects(int t, const TetrahedronBlock& block, int k) {
    if (!(block.thick[k] > 0)) suspects.tetrahedra.push_back(t);
    for (int f = 0; f < 4; ++f) {
        if (!(block.height[f][k] > 0)) suspects.facets.push_back(4 * t + f);
    }
}

EnergySums::EnergySums() = default;
EnergySums::~EnergySums() = default;
EnergySums::EnergySums(const EnergySums&) = default;
EnergySums& EnergySums::operator=(const EnergySums&) = default;

Suspects EnergySums::run(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                         const Frame& frame, Workers& workers, Energy& energy) {
    const std::vector<SlabRange> ranges = slabs_of(tetrahedra.n_tetrahedra());
    const auto n_slabs = static_cast<int>(ranges.size());
    slabs_.resize(ranges.size());
    for (int k = 0; k < n_slabs; ++k) slabs_[k].range = ranges[k];
    heights_.resize(tetrahedra.n_tetrahedra());
    workers.for_each(n_slabs,
                     [&](int k) { slabs_[k].run(tetrahedra, coordinates, frame, heights_); });
    workers.for_each(
        n_slabs, [&](int k) { heights_.remove_certain(tetrahedra, slabs_[k].suspects.facets); });
    add_up(tetrahedra.n_sites(), workers, energy);
    Suspects suspects;
    for (const Slab& slab : slabs_) {
        append(suspects.tetrahedra, slab.suspects.tetrahedra);
        append(suspects.facets, slab.suspects.facets);
    }
    return suspects;
}

/// Adds up in the order of the slabs.
void EnergySums::add_up(int n_sites, Workers& workers, Energy& energy) const {
    energy.value = 0;
    for (const Slab& slab : slabs_) energy.value += slab.value;
    energy.gradient.resize(kNumbers * n_sites);
    energy.mass.resize(n_sites);
    using Sums = SlabSums<CellSums>;
    using Block = Eigen::Matrix<double, 4, Sums::kBlock>;
    const auto n_blocks = static_cast<int>(Sums::n_blocks(n_sites));
    workers.for_each((n_blocks + kBlocksPerTask - 1) / kBlocksPerTask, [&](int task) {
        const int end = std::min((task + 1) * kBlocksPerTask, n_blocks);
        for (int b = task * kBlocksPerTask; b < end; ++b) {
            Block sums = Block::Zero();
            for (const Slab& slab : slabs_) {
                const CellSums* const part = slab.sums.block(b);
                if (part != nullptr) sums += Eigen::Map<const Block>(part->value.data());
            }
            const Eigen::Index first = b * Sums::kBlock;
            const Eigen::Index n = std::min<Eigen::Index>(Sums::kBlock, n_sites - first);
            energy.mass.segment(first, n) = sums.row(3).head(n).transpose();
            sums.row(3).setZero();
            energy.gradient.segment(kNumbers * first, kNumbers * n) = sums.leftCols(n).reshaped();
        }
    });
}

bool correct_for_exchange(ExchangedTetrahedra exchanged, const Points& coordinates,
                          const Frame& frame, Energy& energy) {
    cancel_common(exchanged);
    return add_tetrahedra(exchanged.removed, -1, coordinates, frame, energy) &&
           add_tetrahedra(exchanged.added, 1, coordinates, frame, energy);
}

}  // namespace pcvt::space
