#include "mesher/space/power/power_cells.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/energy/slab_sums.hpp"
#include "mesher/space/power/power_terms.hpp"

namespace pcvt::space {
namespace {

constexpr int kNumbersOfGradient = 4;
/// The blocks of sites that one task adds up.
constexpr int kSiteBlocksPerTask = 64;
/// Contributions of this many mean cells lose too many bits in the sum of a site.
constexpr double kLargestVolume = 2;

void gather_weights(const SiteId* site, const Eigen::VectorXd& weights, int n, PowerBlock& block) {
    for (int k = 0; k < n; ++k, site += 4) {
        for (int c = 0; c < 4; ++c) block.weight[c][k] = weights[site[c]];
    }
    for (int k = n; k < PowerBlock::kSize; ++k) {
        for (int c = 0; c < 4; ++c) block.weight[c][k] = 0;
    }
}

/// Computes a block whose first n tetrahedra count.
template <bool with_moments>
void compute_first(PowerBlock& block, int n, const Frame& frame) {
    if constexpr (with_moments) {
        block.compute_moments(frame);
    } else {
        block.compute(frame);
    }
    for (int k = 0; k < n; ++k) {
        if (!(block.thick[k] > 0)) block.correct(k, frame);
    }
}

/// Calls visit(block, first, n) for the blocks of a slab, in order.
template <bool with_moments, class Visit>
void for_each_block(const WeightedTetrahedra& weighted, const SlabRange& slab, const Visit& visit) {
    PowerBlock block;
    for (int at = slab.first; at < slab.end; at += PowerBlock::kSize) {
        const int n = std::min(PowerBlock::kSize, slab.end - at);
        gather_corners(weighted.tetrahedra, weighted.coordinates, at, n, block.corner);
        gather_weights(weighted.tetrahedra.corner_sites().data() + 4 * std::size_t(at),
                       weighted.weights, n, block);
        compute_first<with_moments>(block, n, weighted.frame);
        visit(block, at, n);
    }
}

/// Adds up blocks of sites, in the order of the slabs: adds slab sums to `total` and calls
/// take(first site, n, total) for each block.
template <class Sum, class Slabs, class Take>
void add_up_slabs(const Slabs& slabs, int n_sites, Workers& workers, const Take& take) {
    using Sums = SlabSums<Sum>;
    const auto n_blocks = static_cast<int>(Sums::n_blocks(n_sites));
    workers.for_each((n_blocks + kSiteBlocksPerTask - 1) / kSiteBlocksPerTask, [&](int task) {
        const int end = std::min((task + 1) * kSiteBlocksPerTask, n_blocks);
        for (int b = task * kSiteBlocksPerTask; b < end; ++b) {
            std::array<Sum, Sums::kBlock> total{};
            for (const auto& slab : slabs) {
                const Sum* const part = slab.sums.block(static_cast<std::size_t>(b));
                if (part == nullptr) continue;
                for (int k = 0; k < Sums::kBlock; ++k) total[k] += part[k];
            }
            const int first = b * Sums::kBlock;
            take(first, std::min(Sums::kBlock, n_sites - first), total);
        }
    });
}

/// The gradient and the volume of a cell.
struct CellMoments {
    std::array<double, 4> value{};

    CellMoments& operator+=(const CellMoments& other) {
        for (int k = 0; k < 4; ++k) value[k] += other.value[k];
        return *this;
    }
};

struct MomentSlab {
    SlabRange range;
    SlabSums<CellMoments> sums = {};
    double energy = 0;
};

void run_slab(const WeightedTetrahedra& weighted, MomentSlab& slab) {
    slab.sums.clear(weighted.tetrahedra.n_sites());
    const SiteId* const sites = weighted.tetrahedra.corner_sites().data();
    for_each_block<true>(weighted, slab.range, [&](const PowerBlock& block, int first, int n) {
        const SiteId* site = sites + 4 * std::size_t(first);
        for (int k = 0; k < n; ++k, site += 4) {
            slab.energy += block.value[k];
            for (int c = 0; c < 4; ++c) {
                const int place = slab.sums.place(site[c]);
                slab.sums.data()[place] += {{block.gradient[c][0][k], block.gradient[c][1][k],
                                             block.gradient[c][2][k], block.volume[c][k]}};
            }
        }
    });
}

template <class Slab>
std::vector<Slab> slabs_for(const WeightedTetrahedra& weighted) {
    std::vector<Slab> slabs;
    for (const SlabRange& range : slabs_of(weighted.tetrahedra.n_tetrahedra())) {
        slabs.push_back({range});
    }
    return slabs;
}

}  // namespace

/// The volumes and the suspects of one task.
struct VolumeSums::Slab {
    SlabRange range = {};
    SlabSums<double> sums = {};
    std::vector<int> suspects = {};

    void run(const WeightedTetrahedra& weighted, FacetHeights& heights);
};

void VolumeSums::Slab::run(const WeightedTetrahedra& weighted, FacetHeights& heights) {
    sums.clear(weighted.tetrahedra.n_sites());
    suspects.clear();
    const SiteId* const sites = weighted.tetrahedra.corner_sites().data();
    for_each_block<false>(weighted, range, [&](const PowerBlock& block, int first, int n) {
        heights.keep(first, block.height);
        const SiteId* site = sites + 4 * std::size_t(first);
        for (int k = 0; k < n; ++k, site += 4) {
            for (int c = 0; c < 4; ++c) {
                const int place = sums.place(site[c]);
                sums.data()[place] += block.volume[c][k];
            }
            if (block.certain[k] > 0) continue;
            for (int c = 0; c < 4; ++c) {
                if (!(block.height[c][k] > 0)) suspects.push_back(4 * (first + k) + c);
            }
        }
    });
}

VolumeSums::VolumeSums() = default;
VolumeSums::~VolumeSums() = default;
VolumeSums::VolumeSums(VolumeSums&&) noexcept = default;
VolumeSums& VolumeSums::operator=(VolumeSums&&) noexcept = default;

std::vector<int> VolumeSums::run(const WeightedTetrahedra& weighted, Workers& workers,
                                 Eigen::VectorXd& volumes) {
    const std::vector<SlabRange> ranges = slabs_of(weighted.tetrahedra.n_tetrahedra());
    const auto n_slabs = static_cast<int>(ranges.size());
    slabs_.resize(ranges.size());
    for (int k = 0; k < n_slabs; ++k) slabs_[k].range = ranges[k];
    heights_.resize(weighted.tetrahedra.n_tetrahedra());
    workers.for_each(n_slabs, [&](int k) { slabs_[k].run(weighted, heights_); });
    workers.for_each(
        n_slabs, [&](int k) { heights_.remove_certain(weighted.tetrahedra, slabs_[k].suspects); });
    const int n_sites = weighted.tetrahedra.n_sites();
    volumes.resize(n_sites);
    add_up_slabs<double>(slabs_, n_sites, workers, [&](int first, int n, const auto& total) {
        std::copy_n(total.begin(), n, volumes.data() + first);
    });
    std::vector<int> suspects;
    for (const Slab& slab : slabs_) {
        suspects.insert(suspects.end(), slab.suspects.begin(), slab.suspects.end());
    }
    return suspects;
}

namespace {

/// Adds the volumes of tetrahedra, times 1 or -1.
/// @returns false if one is too large.
bool add_volumes(std::span<const Tetrahedron> tetrahedra, double sign,
                 const WeightedTetrahedra& weighted, Eigen::VectorXd& volumes) {
    const double most =
        kLargestVolume * weighted.frame.volume() / static_cast<double>(volumes.size());
    PowerBlock block;
    while (!tetrahedra.empty()) {
        const auto part =
            tetrahedra.first(std::min<std::size_t>(tetrahedra.size(), PowerBlock::kSize));
        const int n = static_cast<int>(part.size());
        std::array<SiteId, std::size_t{4} * PowerBlock::kSize> sites{};
        for (int k = 0; k < n; ++k) {
            for (int c = 0; c < 4; ++c) sites[4 * k + c] = part[k][c].site;
        }
        gather_corners(part, weighted.coordinates, block.corner);
        gather_weights(sites.data(), weighted.weights, n, block);
        compute_first<false>(block, n, weighted.frame);
        for (int k = 0; k < 4 * n; ++k) {
            const double volume = block.volume[k % 4][k / 4];
            if (!(std::abs(volume) <= most)) return false;
            volumes[sites[k]] += sign * volume;
        }
        tetrahedra = tetrahedra.subspan(part.size());
    }
    return true;
}

}  // namespace

bool correct_volumes(ExchangedTetrahedra exchanged, const WeightedTetrahedra& weighted,
                     Eigen::VectorXd& volumes) {
    cancel_common(exchanged);
    return add_volumes(exchanged.removed, -1, weighted, volumes) &&
           add_volumes(exchanged.added, 1, weighted, volumes);
}

void measure_cells(const WeightedTetrahedra& regular, Workers& workers, Energy& cells) {
    auto slabs = slabs_for<MomentSlab>(regular);
    workers.for_each(static_cast<int>(slabs.size()), [&](int k) { run_slab(regular, slabs[k]); });
    const int n_sites = regular.tetrahedra.n_sites();
    cells.value = 0;
    for (const MomentSlab& slab : slabs) cells.value += slab.energy;
    cells.gradient.setZero(kNumbersOfGradient * Eigen::Index{n_sites});
    cells.mass.resize(n_sites);
    add_up_slabs<CellMoments>(slabs, n_sites, workers, [&](int first, int n, const auto& total) {
        for (int k = 0; k < n; ++k) {
            const Eigen::Index s = first + k;
            for (int axis = 0; axis < 3; ++axis) {
                cells.gradient[kNumbersOfGradient * s + axis] = total[k].value[axis];
            }
            cells.mass[s] = total[k].value[3];
        }
    });
}

namespace {

/// A contribution to the conductance between a site and one with a greater number.
struct Contribution {
    SiteId to;
    double conductance;
};

/// The sums of contributions by pair of sites: those of row i are the neighbours above i.
struct UpperGraph {
    std::vector<int> row_begin{0};
    std::vector<Contribution> entries;
};

/// The contributions of all tetrahedra: those of row i from begin[i] to begin[i + 1].
struct Contributions {
    std::vector<int> begin;
    std::vector<Contribution> sorted;
};

Contributions all_contributions(const WeightedTetrahedra& regular) {
    const TorusTetrahedra& t = regular.tetrahedra;
    const SiteId* const sites = t.corner_sites().data();
    // The counts are shifted by two entries: after the scatter begin[k] is the beginning of row k.
    Contributions all{std::vector<int>(static_cast<std::size_t>(t.n_sites()) + 2, 0), {}};
    for (int k = 0; k < t.n_tetrahedra(); ++k) {
        checkpoint_each(k, 1 << 14);
        for (const auto& [i, j] : PowerBlock::kEdges) {
            ++all.begin[std::min(sites[4 * k + i], sites[4 * k + j]) + 2];
        }
    }
    for (std::size_t s = 2; s < all.begin.size(); ++s) all.begin[s] += all.begin[s - 1];
    all.sorted.resize(6 * std::size_t(t.n_tetrahedra()));
    int* const next = all.begin.data() + 1;
    for (const SlabRange& slab : slabs_of(t.n_tetrahedra())) {
        checkpoint();
        for_each_block<false>(regular, slab, [&](const PowerBlock& block, int first, int n) {
            const SiteId* site = sites + 4 * std::size_t(first);
            for (int k = 0; k < n; ++k, site += 4) {
                for (int e = 0; e < 6; ++e) {
                    const auto [i, j] = PowerBlock::kEdges[e];
                    const auto [low, high] = std::minmax(site[i], site[j]);
                    all.sorted[next[low]++] = {high, block.conductance[e][k]};
                }
            }
        });
    }
    return all;
}

/// Merges the contributions before they are rounded: single ones may be negative.
UpperGraph merged_contributions(int n_sites, const Contributions& all) {
    UpperGraph upper;
    upper.entries.reserve(8 * static_cast<std::size_t>(n_sites));
    std::vector<int> place(static_cast<std::size_t>(n_sites), -1);
    for (SiteId s = 0; s < n_sites; ++s) {
        checkpoint_each(s);
        const int row = upper.row_begin.back();
        for (int k = all.begin[s]; k < all.begin[s + 1]; ++k) {
            const auto [to, part] = all.sorted[k];
            if (to == s) continue;
            if (place[to] < row) {
                place[to] = static_cast<int>(upper.entries.size());
                upper.entries.push_back({to, 0});
            }
            upper.entries[place[to]].conductance += part;
        }
        upper.row_begin.push_back(static_cast<int>(upper.entries.size()));
    }
    return upper;
}

}  // namespace

CellGraph cell_graph(const WeightedTetrahedra& regular) {
    const int n_sites = regular.tetrahedra.n_sites();
    const UpperGraph upper = merged_contributions(n_sites, all_contributions(regular));
    CellGraph graph;
    graph.row_begin.assign(static_cast<std::size_t>(n_sites) + 2, 0);
    std::vector<int>& begin = graph.row_begin;
    for (SiteId s = 0; s < n_sites; ++s) {
        begin[s + 2] += upper.row_begin[s + 1] - upper.row_begin[s];
        for (int k = upper.row_begin[s]; k < upper.row_begin[s + 1]; ++k) {
            ++begin[upper.entries[k].to + 2];
        }
    }
    for (std::size_t s = 2; s < begin.size(); ++s) begin[s] += begin[s - 1];
    graph.neighbour.resize(static_cast<std::size_t>(begin.back()));
    graph.conductance.resize(graph.neighbour.size());
    for (SiteId s = 0; s < n_sites; ++s) {
        checkpoint_each(s);
        for (int k = upper.row_begin[s]; k < upper.row_begin[s + 1]; ++k) {
            const auto [to, sum] = upper.entries[k];
            const double conductance = std::max(0.0, sum);
            for (const auto& [from, at] : {std::pair{s, to}, std::pair{to, s}}) {
                const int place = begin[from + 1]++;
                graph.neighbour[place] = at;
                graph.conductance[place] = conductance;
            }
        }
    }
    graph.row_begin.pop_back();
    return graph;
}

}  // namespace pcvt::space
