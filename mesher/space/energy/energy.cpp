#include "mesher/space/energy/energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "mesher/base/prefetch.hpp"
#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"

namespace pcvt::space {
namespace {

/// A slab, the task of one worker, has at least this number of tetrahedra.
constexpr int kTetrahedraPerSlab = 50'000;
constexpr int kMostSlabs = 32;
/// Contributions of this many mean cells lose four bits in the sum of a site.
constexpr double kLargest = 16;

/// The rounding of two heights and of their sum to single precision, relative to both; rounded up.
constexpr float kSumError = 0x1p-22F;
/// The number of suspects by which the prefetch of their heights is ahead.
constexpr std::size_t kSuspectsFetched = 8;
constexpr Eigen::Index kNumbers = MovingTetrahedra::kNumbersPerSite;
/// The blocks of sites that one task adds up.
constexpr int kBlocksPerTask = 64;

/// Where the height above facet f is kept: the rows of each block of tetrahedra follow each other.
std::size_t height_place(int f) {
    constexpr int kSize = TetrahedronBlock::kSize;
    const int t = f / 4;
    return 4 * std::size_t(t - t % kSize) + (f % 4) * kSize + t % kSize;
}

/// The gradient and the volume of a cell; one load takes all four numbers.
struct alignas(4 * sizeof(double)) CellSums {
    std::array<double, 4> value{};
};

/// The sums over the tetrahedra of a slab, in blocks of sites that are made where they are needed:
/// the tetrahedra have few of all sites as corners.
class SlabSums {
   public:
    static constexpr int kBlock = 64;
    using Block = Eigen::Matrix<double, 4, kBlock>;

    void clear(int n_sites) {
        place_.assign(n_blocks(n_sites), -1);
        sums_.clear();
    }
    static std::size_t n_blocks(int n_sites) {
        return static_cast<std::size_t>((n_sites + kBlock - 1) / kBlock);
    }
    /// The number in data() of a site's sums, which are made if there are none.
    int place(SiteId site) {
        int& place = place_[unsigned(site) / kBlock];
        if (place < 0) {
            place = static_cast<int>(sums_.size());
            sums_.resize(sums_.size() + kBlock);
        }
        return place + int(unsigned(site) % kBlock);
    }
    CellSums* data() { return sums_.data(); }
    /// Adds block b of the sites to others.
    void add_block_to(std::size_t b, Block& others) const {
        if (place_[b] >= 0) others += Eigen::Map<const Block>(sums_[place_[b]].value.data());
    }

   private:
    /// Where the sums of each block begin, or -1.
    std::vector<int> place_;
    std::vector<CellSums> sums_;
};

/// Fills up an incomplete block with tetrahedra that cause no division by zero.
void fill_up(TetrahedronBlock& block, int n) {
    for (int k = n; k < TetrahedronBlock::kSize; ++k) {
        for (int c = 0; c < 9; ++c) block.corner[c / 3][c % 3][k] = c / 3 == c % 3 ? 1 : 0;
    }
}

void gather(const TorusTetrahedra& tetrahedra, const Points& coordinates, int at, int n,
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

void gather(std::span<const Tetrahedron> tetrahedra, const Points& coordinates,
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

void keep_heights(const TetrahedronBlock& block, float* to) {
    for (const TetrahedronBlock::Row& row : block.height) {
        for (const double height : row) *to++ = static_cast<float>(height);
    }
}

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
        gather(part, coordinates, block);
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
    int first = 0;
    int end = 0;
    SlabSums sums = {};
    double value = 0;
    Suspects suspects = {};

    void run(const TorusTetrahedra& tetrahedra, const Points& coordinates, const Frame& frame,
             std::vector<float>& heights);
    void certify(const TorusTetrahedra& tetrahedra, const std::vector<float>& heights);

   private:
    void add_suspects(int t, const TetrahedronBlock& block, int k);
    void scatter(const TorusTetrahedra& tetrahedra, int at, int n, const TetrahedronBlock& block);
};

void EnergySums::Slab::run(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                           const Frame& frame, std::vector<float>& heights) {
    sums.clear(tetrahedra.n_sites());
    value = 0;
    suspects.tetrahedra.clear();
    suspects.facets.clear();
    TetrahedronBlock block;
    for (int at = first; at < end; at += TetrahedronBlock::kSize) {
        const int n = std::min(TetrahedronBlock::kSize, end - at);
        gather(tetrahedra, coordinates, at, n, block);
        compute(block, n, frame);
        scatter(tetrahedra, at, n, block);
        keep_heights(block, heights.data() + 4 * std::size_t(at));
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

/// Removes the suspects whose two heights have a sum that is certainly positive.
void EnergySums::Slab::certify(const TorusTetrahedra& tetrahedra,
                               const std::vector<float>& heights) {
    std::vector<int>& facets = suspects.facets;
    const auto later = [&](std::size_t k) { return facets[std::min(k, facets.size() - 1)]; };
    std::size_t n_kept = 0;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const int f = facets[k];
        tetrahedra.fetch_opposite(later(k + 2 * kSuspectsFetched));
        const int next = later(k + kSuspectsFetched);
        for (const int g : {next, tetrahedra.opposite(next)}) prefetch(&heights[height_place(g)]);
        const float here = heights[height_place(f)];
        const float there = heights[height_place(tetrahedra.opposite(f))];
        const bool certain = here + there > kSumError * (std::abs(here) + std::abs(there));
        if (!certain) facets[n_kept++] = f;
    }
    facets.resize(n_kept);
}

EnergySums::EnergySums() = default;
EnergySums::~EnergySums() = default;
EnergySums::EnergySums(const EnergySums&) = default;
EnergySums& EnergySums::operator=(const EnergySums&) = default;

void EnergySums::divide(int n_tetrahedra) {
    constexpr int kSize = TetrahedronBlock::kSize;
    const int n_slabs = std::clamp(n_tetrahedra / kTetrahedraPerSlab, 1, kMostSlabs);
    const int n_blocks = (n_tetrahedra + kSize - 1) / kSize;
    slabs_.resize(static_cast<std::size_t>(n_slabs));
    for (int k = 0; k < n_slabs; ++k) {
        const auto limit = [&](int s) {
            return static_cast<int>(std::int64_t{n_blocks} * s / n_slabs) * kSize;
        };
        slabs_[k].first = limit(k);
        slabs_[k].end = std::min(limit(k + 1), n_tetrahedra);
    }
}

Suspects EnergySums::run(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                         const Frame& frame, Workers& workers, Energy& energy) {
    divide(tetrahedra.n_tetrahedra());
    const auto n_slabs = static_cast<int>(slabs_.size());
    heights_.resize(4 * std::size_t(tetrahedra.n_tetrahedra() + TetrahedronBlock::kSize));
    workers.for_each(n_slabs,
                     [&](int k) { slabs_[k].run(tetrahedra, coordinates, frame, heights_); });
    workers.for_each(n_slabs, [&](int k) { slabs_[k].certify(tetrahedra, heights_); });
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
    const auto n_blocks = static_cast<int>(SlabSums::n_blocks(n_sites));
    workers.for_each((n_blocks + kBlocksPerTask - 1) / kBlocksPerTask, [&](int task) {
        const int end = std::min((task + 1) * kBlocksPerTask, n_blocks);
        for (int b = task * kBlocksPerTask; b < end; ++b) {
            SlabSums::Block sums = SlabSums::Block::Zero();
            for (const Slab& slab : slabs_) slab.sums.add_block_to(b, sums);
            const Eigen::Index first = b * SlabSums::kBlock;
            const Eigen::Index n = std::min<Eigen::Index>(SlabSums::kBlock, n_sites - first);
            energy.mass.segment(first, n) = sums.row(3).head(n).transpose();
            sums.row(3).setZero();
            energy.gradient.segment(kNumbers * first, kNumbers * n) = sums.leftCols(n).reshaped();
        }
    });
}

bool correct_for_exchange(ExchangedTetrahedra exchanged, const Points& coordinates,
                          const Frame& frame, Energy& energy) {
    cancel_common(exchanged.removed, exchanged.added);
    return add_tetrahedra(exchanged.removed, -1, coordinates, frame, energy) &&
           add_tetrahedra(exchanged.added, 1, coordinates, frame, energy);
}

}  // namespace pcvt::space
