#pragma once

#include <array>
#include <cstdint>

namespace pcvt::space {

/// A signed integer of `words` times 64 bits, in two's complement, for exact predicates. Sums and
/// products that exceed it lose their upper bits, so the caller chooses `words` by the largest
/// possible result.
///
/// Example usage (the sign of x y - z for 64-bit numbers):
///
///     const WideInteger<3> x(1L << 60), y(1L << 60), z(7);
///     const int sign = (x * y - z).sign();
template <int words>
class WideInteger {
   public:
    WideInteger() = default;
    explicit WideInteger(std::int64_t number) {
        word_.fill(number < 0 ? ~std::uint64_t{0} : 0);
        word_[0] = static_cast<std::uint64_t>(number);
    }
    /// Extends a narrower integer by its sign.
    template <int fewer>
    explicit WideInteger(const WideInteger<fewer>& other) {
        static_assert(fewer <= words);
        word_.fill(other.sign() < 0 ? ~std::uint64_t{0} : 0);
        for (int k = 0; k < fewer; ++k) word_[k] = other.word(k);
    }

    std::uint64_t word(int k) const { return word_[k]; }
    int sign() const {
        if (word_[words - 1] >> 63 != 0) return -1;
        for (const std::uint64_t w : word_) {
            if (w != 0) return 1;
        }
        return 0;
    }

    /// The nearest double, up to some units in its last place.
    double rounded() const {
        if (sign() < 0) return -(WideInteger(0) - *this).rounded();
        double sum = 0;
        for (int k = words - 1; k >= 0; --k) sum = sum * 0x1p64 + static_cast<double>(word_[k]);
        return sum;
    }

    friend WideInteger operator+(const WideInteger& x, const WideInteger& y) {
        WideInteger sum;
        Double carry = 0;
        for (int k = 0; k < words; ++k) {
            carry += Double{x.word_[k]} + y.word_[k];
            sum.word_[k] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        return sum;
    }
    friend WideInteger operator-(const WideInteger& x, const WideInteger& y) {
        WideInteger difference;
        std::uint64_t borrow = 0;
        for (int k = 0; k < words; ++k) {
            const Double right = Double{y.word_[k]} + borrow;
            difference.word_[k] = static_cast<std::uint64_t>(x.word_[k] - right);
            borrow = x.word_[k] < right ? 1 : 0;
        }
        return difference;
    }
    /// Modulo 2^(64 words) the product of two's complements is that of the unsigned numbers.
    friend WideInteger operator*(const WideInteger& x, const WideInteger& y) {
        WideInteger product;
        for (int k = 0; k < words; ++k) {
            std::uint64_t carry = 0;
            for (int m = 0; k + m < words; ++m) {
                const Double sum = Double{x.word_[k]} * y.word_[m] + product.word_[k + m] + carry;
                product.word_[k + m] = static_cast<std::uint64_t>(sum);
                carry = static_cast<std::uint64_t>(sum >> 64);
            }
        }
        return product;
    }

   private:
    __extension__ using Double = unsigned __int128;

    std::array<std::uint64_t, words> word_{};
};

}  // namespace pcvt::space
