#include "mesher/plane/energy/fourier_transform.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <random>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

using Element = FourierTransform::Element;
using Series = std::vector<Element>;

Series random_series(int length, unsigned seed) {
    std::mt19937 random(seed);
    Series series(static_cast<std::size_t>(length));
    for (Element& element : series) {
        for (int lane = 0; lane < FourierTransform::kLanes; ++lane) {
            element.real[lane] = float(random() % 2001) / 1000 - 1;
            element.imaginary[lane] = float(random() % 2001) / 1000 - 1;
        }
    }
    return series;
}

Series transformed(const FourierTransform& transform, Series series) {
    Series scratch(series.size());
    transform.apply(series.data(), scratch.data());
    return series;
}

Series exchanged(Series series) {
    for (Element& element : series) std::swap(element.real, element.imaginary);
    return series;
}

/// The sum of the definition in double precision.
std::complex<double> by_definition(const Series& series, int k, int lane) {
    const auto n = static_cast<int>(series.size());
    std::complex<double> sum = 0;
    for (int j = 0; j < n; ++j) {
        const double angle = -2 * std::numbers::pi * double(j * k % n) / n;
        sum += std::polar(1.0, angle) *
               std::complex<double>(series[j].real[lane], series[j].imaginary[lane]);
    }
    return sum;
}

bool is_good(int length) {
    for (const int factor : {2, 3, 5, 7}) {
        while (length % factor == 0) length /= factor;
    }
    return length == 1;
}

TEST(FourierTransform, IsTheSumOfItsDefinition) {
    for (int length = 1; length <= 256; ++length) {
        if (!is_good(length)) continue;
        const Series series = random_series(length, 1);
        const Series result = transformed(FourierTransform(length), series);
        for (int k = 0; k < length; ++k) {
            for (const int lane : {0, 5, FourierTransform::kLanes - 1}) {
                const std::complex<double> expected = by_definition(series, k, lane);
                const double tolerance = 4e-7 * length;
                ASSERT_NEAR(result[k].real[lane], expected.real(), tolerance) << length;
                ASSERT_NEAR(result[k].imaginary[lane], expected.imag(), tolerance) << length;
            }
        }
    }
}

TEST(FourierTransform, OfExchangedPartsIsTheInverse) {
    for (const int length : {4, 84, 600, 1890, 2048}) {
        const FourierTransform transform(length);
        const Series series = random_series(length, 2);
        const Series back =
            exchanged(transformed(transform, exchanged(transformed(transform, series))));
        for (int j = 0; j < length; ++j) {
            ASSERT_NEAR(back[j].real[3] / float(length), series[j].real[3], 2e-6);
            ASSERT_NEAR(back[j].imaginary[3] / float(length), series[j].imaginary[3], 2e-6);
        }
    }
}

TEST(FourierTransform, GoodLengthsAreTheNextEvenOnesWithSmallFactors) {
    for (int wanted = 1; wanted < 2000; ++wanted) {
        const int length = FourierTransform::good_length(wanted);
        ASSERT_TRUE(is_good(length) && length % 2 == 0 && length >= std::max(4, wanted));
        for (int less = std::max(4, wanted); less < length; ++less) {
            ASSERT_FALSE(is_good(less) && less % 2 == 0) << wanted;
        }
    }
}

TEST(FourierTransform, RefusesLargePrimeFactors) {
    EXPECT_THROW(FourierTransform(22), InternalError);
}

}  // namespace
}  // namespace pcvt::plane
