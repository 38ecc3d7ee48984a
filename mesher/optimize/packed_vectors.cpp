#include "mesher/optimize/packed_vectors.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/huge_pages.hpp"
#include "mesher/base/prefetch.hpp"
#include "mesher/base/target_clones.hpp"

namespace pcvt {
namespace {

constexpr float kLargest = 32767;
/// Adding this to a float below 2^22 leaves the nearest integer in its last bits.
constexpr float kRounding = 12582912;
/// Partial sums of a dot product, enough of them to hide the latency of an addition.
constexpr Eigen::Index kLanes = 32;

/// The largest |x_i|, or NaN if a number is not finite.
PCVT_TARGET_CLONES float largest_of(const float* x, Eigen::Index n) {
    float largest[kLanes] = {};
    float zero[kLanes] = {};
    Eigen::Index i = 0;
    for (; i + kLanes <= n; i += kLanes) {
        for (Eigen::Index k = 0; k < kLanes; ++k) {
            const float size = std::abs(x[i + k]);
            largest[k] = largest[k] < size ? size : largest[k];
            zero[k] += 0 * x[i + k];
        }
    }
    for (; i < n; ++i) {
        largest[0] = std::max(largest[0], std::abs(x[i]));
        zero[0] += 0 * x[i];
    }
    float sum = 0;
    for (const float part : zero) sum += part;
    return sum == 0 ? *std::max_element(largest, largest + kLanes)
                    : std::numeric_limits<float>::quiet_NaN();
}

PCVT_TARGET_CLONES void round_to(float scale, float* x, std::int16_t* numbers, Eigen::Index n) {
    const float per_scale = 1 / scale;
    for (Eigen::Index i = 0; i < n; ++i) {
        const float whole = x[i] * per_scale + kRounding;
        numbers[i] = static_cast<std::int16_t>(Eigen::numext::bit_cast<std::int32_t>(whole) -
                                               Eigen::numext::bit_cast<std::int32_t>(kRounding));
        x[i] = scale * (whole - kRounding);
    }
}

/// Computes the dot product and meanwhile prefetches the numbers at `next`, which are read soon;
/// kLanes numbers fill one cache line.
PCVT_TARGET_CLONES float dot_of(const std::int16_t* numbers, const std::int16_t* next,
                                const float* x, Eigen::Index n) {
    float lane[kLanes] = {};
    Eigen::Index i = 0;
    for (; i + kLanes <= n; i += kLanes) {
        prefetch(next + i);
        for (Eigen::Index k = 0; k < kLanes; ++k) lane[k] += x[i + k] * float(numbers[i + k]);
    }
    for (; i < n; ++i) lane[i % kLanes] += x[i] * float(numbers[i]);
    float sum = 0;
    for (const float part : lane) sum += part;
    return sum;
}

PCVT_TARGET_CLONES void add_multiple_of(float c, const std::int16_t* numbers,
                                        const std::int16_t* next, float* sum, Eigen::Index n) {
    Eigen::Index i = 0;
    for (; i + kLanes <= n; i += kLanes) {
        prefetch(next + i);
        for (Eigen::Index k = 0; k < kLanes; ++k) sum[i + k] += c * float(numbers[i + k]);
    }
    for (; i < n; ++i) sum[i] += c * float(numbers[i]);
}

PCVT_TARGET_CLONES void widen(float scale, const std::int16_t* numbers, const std::int16_t* next,
                              float* x, Eigen::Index n) {
    Eigen::Index i = 0;
    for (; i + kLanes <= n; i += kLanes) {
        prefetch(next + i);
        for (Eigen::Index k = 0; k < kLanes; ++k) x[i + k] = scale * float(numbers[i + k]);
    }
    for (; i < n; ++i) x[i] = scale * float(numbers[i]);
}

}  // namespace

PackedVectors::PackedVectors(int n_vectors, Eigen::Index n_numbers)
    : n_vectors_(n_vectors), n_numbers_(n_numbers) {
    const Eigen::Index n_blocks = (n_numbers + kBlock - 1) / kBlock;
    const auto n_stored = static_cast<std::size_t>(n_blocks * kBlock * n_vectors);
    numbers_.reserve(n_stored);
    prefer_huge_pages(numbers_.data(), n_stored * sizeof(std::int16_t));
    numbers_.resize(n_stored);
    scales_.resize(static_cast<std::size_t>(n_blocks * n_vectors));
}

void PackedVectors::pack(int vector, Eigen::Index block, float* x) {
    const Eigen::Index at = place(vector, block);
    const float scale = largest_of(x, n_in(block)) / kLargest;
    scales_[at] = scale;
    if (scale >= std::numeric_limits<float>::min()) {
        round_to(scale, x, numbers_.data() + at * kBlock, n_in(block));
        return;
    }
    // The scale is NaN, or the block is negligible: 0 * scale covers both cases.
    std::fill_n(numbers_.data() + at * kBlock, n_in(block), std::int16_t{0});
    std::fill_n(x, n_in(block), 0 * scale);
}

void PackedVectors::unpack(int vector, Eigen::Index block, float* x) const {
    const Eigen::Index at = place(vector, block);
    widen(scales_[at], numbers_at(at), next_numbers(at), x, n_in(block));
}

double PackedVectors::dot(int vector, Eigen::Index block, const float* x) const {
    const Eigen::Index at = place(vector, block);
    return double(scales_[at]) * double(dot_of(numbers_at(at), next_numbers(at), x, n_in(block)));
}

void PackedVectors::add_multiple(int vector, Eigen::Index block, float c, float* sum) const {
    const Eigen::Index at = place(vector, block);
    add_multiple_of(c * scales_[at], numbers_at(at), next_numbers(at), sum, n_in(block));
}

}  // namespace pcvt
