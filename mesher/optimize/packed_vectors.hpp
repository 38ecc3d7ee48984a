#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcvt {

/// Large vectors of one length at 16 bits a number, for what is read often and need not be exact:
/// within a block of 2048 numbers they are whole multiples of one scale, and the largest is 32767
/// of them. The same block of all vectors lies in one piece of memory.
///
/// Different threads may work on different blocks. All functions take the number of the vector,
/// that of the block, and a plain array of its numbers: 2048 or, in the last block, fewer. Sums are
/// taken in single precision within a block, always in the same order.
class PackedVectors {
   public:
    static constexpr Eigen::Index kBlock = 1 << 11;

    PackedVectors(int n_vectors, Eigen::Index n_numbers);

    /// Stores x and rounds it to what is stored. A block with a number that is not finite becomes
    /// NaN.
    void pack(int vector, Eigen::Index block, float* x);
    /// x becomes what is stored.
    void unpack(int vector, Eigen::Index block, float* x) const;
    /// The dot product with x.
    double dot(int vector, Eigen::Index block, const float* x) const;
    /// sum += c times the vector.
    void add_multiple(int vector, Eigen::Index block, float c, float* sum) const;

   private:
    Eigen::Index n_in(Eigen::Index block) const {
        return std::min(kBlock, n_numbers_ - block * kBlock);
    }
    Eigen::Index place(int vector, Eigen::Index block) const { return block * n_vectors_ + vector; }
    const std::int16_t* numbers_at(Eigen::Index at) const { return numbers_.data() + at * kBlock; }
    /// Those of the same vector in the next block, if there is one.
    const std::int16_t* next_numbers(Eigen::Index at) const {
        const Eigen::Index next = at + n_vectors_;
        return numbers_at(next < std::ssize(scales_) ? next : at);
    }

    int n_vectors_;
    Eigen::Index n_numbers_;
    /// By block, then by vector.
    std::vector<std::int16_t> numbers_;
    std::vector<float> scales_;
};

}  // namespace pcvt
