#pragma once

#include <array>
#include <memory>
#include <vector>

namespace pcvt::plane {

/// The discrete Fourier transform of kLanes complex series at a time, in single precision:
///
///   X_k = sum_j x_j exp(-2 pi i j k / n),   k = 0 ... n - 1.
///
/// Stockham's algorithm with the radices 2, 3, 4, 5 and 7, in n log n steps. A vector unit works on
/// one element of several series, so that all machines perform the same operations and return the
/// same bits. Only the constructor allocates memory.
///
/// Example usage:
///
///     const FourierTransform transform(FourierTransform::good_length(1000));
///     auto series = std::make_unique<FourierTransform::Element[]>(transform.length());
///     auto scratch = std::make_unique<FourierTransform::Element[]>(transform.length());
///     transform.apply(series.get(), scratch.get());
class FourierTransform {
   public:
    static constexpr int kLanes = 16;
    /// One element of each series.
    struct Element {
        alignas(64) std::array<float, kLanes> real;
        std::array<float, kLanes> imaginary;
    };

    /// Returns the next even number, at least 4, without prime factors above 7.
    static int good_length(int at_least);

    /// @param length  without prime factors above 7.
    explicit FourierTransform(int length);

    int length() const { return length_; }

    /// Replaces the series by their transforms. With real and imaginary parts exchanged before and
    /// after it, this is the inverse transform times the length.
    /// @param scratch  as many elements, whose values are lost.
    void apply(Element* series, Element* scratch) const;

   private:
    /// One step of the algorithm.
    struct Stage {
        int radix;
        /// The elements between two inputs of a butterfly, and between two groups of outputs.
        int n_groups;
        int stride;
        /// cos and -sin for the outputs 1 ... radix - 1 of each group.
        std::vector<std::array<float, 2>> factors;
    };

    int length_;
    std::vector<Stage> stages_;
};

}  // namespace pcvt::plane
