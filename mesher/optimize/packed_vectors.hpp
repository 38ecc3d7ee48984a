#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcvt {

/// Large vectors of equal length at 16 bits a number, for data that is read often and need not be
/// exact. Within a block of 2048 numbers each number is an integer multiple of one scale, and the
/// largest is 32767 times the scale. The same block of all vectors is contiguous in memory.
///
/// Different threads may work on different blocks. All functions take the index of the vector, the
/// index of the block, and a plain array with the numbers of that block: 2048, or fewer in the last
/// block. Sums within a block are in single precision and always in the same order.
class PackedVectors {
   public:
    static constexpr Eigen::Index kBlock = 1 << 11;

    PackedVectors(int n_vectors, Eigen::Index n_numbers);

    /// Stores x and rounds x to the stored values. A block with a number that is not finite becomes
    /// NaN.
    void pack(int vector, Eigen::Index block, float* x);
    /// Copies the stored block to x.
    void unpack(int vector, Eigen::Index block, float* x) const;
    /// Returns the dot product of the stored block with x.
    double dot(int vector, Eigen::Index block, const float* x) const;
    /// Adds c times the stored block to `sum`.
    void add_multiple(int vector, Eigen::Index block, float c, float* sum) const;

   private:
    Eigen::Index n_in(Eigen::Index block) const {
        return std::min(kBlock, n_numbers_ - block * kBlock);
    }
    Eigen::Index place(int vector, Eigen::Index block) const { return block * n_vectors_ + vector; }
    const std::int16_t* numbers_at(Eigen::Index at) const { return numbers_.data() + at * kBlock; }
    /// The numbers of the same vector in the next block, if there is one.
    const std::int16_t* next_numbers(Eigen::Index at) const {
        const Eigen::Index next = at + n_vectors_;
        return numbers_at(next < std::ssize(scales_) ? next : at);
    }

    int n_vectors_;
    Eigen::Index n_numbers_;
    /// Ordered by block, then by vector.
    std::vector<std::int16_t> numbers_;
    std::vector<float> scales_;
};

}  // namespace pcvt
