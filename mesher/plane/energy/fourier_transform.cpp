#include "mesher/plane/energy/fourier_transform.hpp"

#include <algorithm>
#include <numbers>

#include "mesher/base/error.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::plane {
namespace {

using Element = FourierTransform::Element;
using Factor = std::array<float, 2>;

/// cos and sin of 2 pi k / R, correctly rounded.
template <int R>
struct Roots;
template <>
struct Roots<3> {
    static constexpr float kCos[] = {1, -0.5F, -0.5F};
    static constexpr float kSin[] = {0, 0.866025404F, -0.866025404F};
};
template <>
struct Roots<5> {
    static constexpr float kCos[] = {1, 0.309016994F, -0.809016994F, -0.809016994F, 0.309016994F};
    static constexpr float kSin[] = {0, 0.951056516F, 0.587785252F, -0.587785252F, -0.951056516F};
};
template <>
struct Roots<7> {
    static constexpr float kCos[] = {
        1, 0.623489802F, -0.222520934F, -0.900968868F, -0.900968868F, -0.222520934F, 0.623489802F};
    static constexpr float kSin[] = {
        0, 0.781831482F, 0.974927912F, 0.433883739F, -0.433883739F, -0.974927912F, -0.781831482F};
};

/// The R inputs or outputs of a butterfly in one series.
template <int R>
struct Points {
    float real[R];
    float imaginary[R];
};

/// The transform of an odd number of points.
template <int R>
[[gnu::always_inline]] inline Points<R> butterfly(const Points<R>& x) {
    constexpr int kHalf = R / 2;
    Points<R> y;
    Points<kHalf> sum;
    Points<kHalf> difference;
    y.real[0] = x.real[0];
    y.imaginary[0] = x.imaginary[0];
    for (int j = 0; j < kHalf; ++j) {
        sum.real[j] = x.real[j + 1] + x.real[R - 1 - j];
        sum.imaginary[j] = x.imaginary[j + 1] + x.imaginary[R - 1 - j];
        difference.real[j] = x.real[j + 1] - x.real[R - 1 - j];
        difference.imaginary[j] = x.imaginary[j + 1] - x.imaginary[R - 1 - j];
        y.real[0] += sum.real[j];
        y.imaginary[0] += sum.imaginary[j];
    }
    for (int k = 1; k <= kHalf; ++k) {
        float even_real = x.real[0];
        float even_imaginary = x.imaginary[0];
        float odd_real = 0;
        float odd_imaginary = 0;
        for (int j = 0; j < kHalf; ++j) {
            const float c = Roots<R>::kCos[(j + 1) * k % R];
            const float s = Roots<R>::kSin[(j + 1) * k % R];
            even_real += c * sum.real[j];
            even_imaginary += c * sum.imaginary[j];
            odd_real += s * difference.real[j];
            odd_imaginary += s * difference.imaginary[j];
        }
        y.real[k] = even_real + odd_imaginary;
        y.imaginary[k] = even_imaginary - odd_real;
        y.real[R - k] = even_real - odd_imaginary;
        y.imaginary[R - k] = even_imaginary + odd_real;
    }
    return y;
}

template <>
[[gnu::always_inline]] inline Points<2> butterfly(const Points<2>& x) {
    return {{x.real[0] + x.real[1], x.real[0] - x.real[1]},
            {x.imaginary[0] + x.imaginary[1], x.imaginary[0] - x.imaginary[1]}};
}

template <>
[[gnu::always_inline]] inline Points<4> butterfly(const Points<4>& x) {
    const Points<2> even = butterfly<2>({{x.real[0], x.real[2]}, {x.imaginary[0], x.imaginary[2]}});
    const Points<2> odd = butterfly<2>({{x.real[1], x.real[3]}, {x.imaginary[1], x.imaginary[3]}});
    return {{even.real[0] + odd.real[0], even.real[1] + odd.imaginary[1],
             even.real[0] - odd.real[0], even.real[1] - odd.imaginary[1]},
            {even.imaginary[0] + odd.imaginary[0], even.imaginary[1] - odd.real[1],
             even.imaginary[0] - odd.imaginary[0], even.imaginary[1] + odd.real[1]}};
}

/// Transforms one point of each of R parts of the series and multiplies by the factors.
template <int R>
[[gnu::always_inline]] inline void combine(const Element* from, std::ptrdiff_t part,
                                           const Factor* factors, Element* to,
                                           std::ptrdiff_t stride) {
    for (int lane = 0; lane < FourierTransform::kLanes; ++lane) {
        Points<R> x;
        for (int j = 0; j < R; ++j) {
            x.real[j] = from[j * part].real[lane];
            x.imaginary[j] = from[j * part].imaginary[lane];
        }
        const Points<R> y = butterfly<R>(x);
        to[0].real[lane] = y.real[0];
        to[0].imaginary[lane] = y.imaginary[0];
        for (int k = 1; k < R; ++k) {
            const auto [c, s] = factors[k - 1];
            to[k * stride].real[lane] = c * y.real[k] - s * y.imaginary[k];
            to[k * stride].imaginary[lane] = c * y.imaginary[k] + s * y.real[k];
        }
    }
}

/// One stage: y[q + s (R p + k)] = w^(p k) sum_j x[q + s (p + m j)] exp(-2 pi i j k / R) for
/// p = 0 ... m - 1 and q = 0 ... s - 1, with the stride s, the number of groups m and
/// w = exp(-2 pi i / (R m)).
template <int R>
[[gnu::always_inline]] inline void stage(const Element* from, Element* to, int n_groups, int stride,
                                         const Factor* factors) {
    const std::ptrdiff_t part = std::ptrdiff_t(n_groups) * stride;
    for (std::ptrdiff_t p = 0; p < n_groups; ++p) {
        for (std::ptrdiff_t q = 0; q < stride; ++q) {
            combine<R>(from + q + stride * p, part, factors + (R - 1) * p, to + q + stride * R * p,
                       stride);
        }
    }
}

PCVT_TARGET_CLONES void stage_of_2(const Element* from, Element* to, int n_groups, int stride,
                                   const Factor* factors) {
    stage<2>(from, to, n_groups, stride, factors);
}
PCVT_TARGET_CLONES void stage_of_3(const Element* from, Element* to, int n_groups, int stride,
                                   const Factor* factors) {
    stage<3>(from, to, n_groups, stride, factors);
}
PCVT_TARGET_CLONES void stage_of_4(const Element* from, Element* to, int n_groups, int stride,
                                   const Factor* factors) {
    stage<4>(from, to, n_groups, stride, factors);
}
PCVT_TARGET_CLONES void stage_of_5(const Element* from, Element* to, int n_groups, int stride,
                                   const Factor* factors) {
    stage<5>(from, to, n_groups, stride, factors);
}
PCVT_TARGET_CLONES void stage_of_7(const Element* from, Element* to, int n_groups, int stride,
                                   const Factor* factors) {
    stage<7>(from, to, n_groups, stride, factors);
}

struct Radix {
    int radix;
    void (*stage)(const Element* from, Element* to, int n_groups, int stride,
                  const Factor* factors);
};

/// In the order in which they divide the length.
constexpr Radix kRadices[] = {
    {4, stage_of_4}, {2, stage_of_2}, {3, stage_of_3}, {5, stage_of_5}, {7, stage_of_7}};

}  // namespace

int FourierTransform::good_length(int at_least) {
    for (int length = std::max(4, at_least + at_least % 2);; length += 2) {
        int rest = length;
        for (const Radix& row : kRadices) {
            while (rest % row.radix == 0) rest /= row.radix;
        }
        if (rest == 1) return length;
    }
}

FourierTransform::FourierTransform(int length) : length_(length) {
    int rest = length;
    for (const Radix& row : kRadices) {
        for (; rest % row.radix == 0; rest /= row.radix) {
            Stage& stage = stages_.emplace_back();
            stage.radix = row.radix;
            stage.n_groups = rest / row.radix;
            stage.stride = length / rest;
            for (int p = 0; p < stage.n_groups; ++p) {
                for (int k = 1; k < row.radix; ++k) {
                    const double angle = 2 * std::numbers::pi * double(p) * k / rest;
                    const auto [cos, sin] = cos_sin(angle);
                    stage.factors.push_back({static_cast<float>(cos), -static_cast<float>(sin)});
                }
            }
        }
    }
    if (rest != 1) throw InternalError("a Fourier transform of a length with a large prime factor");
}

void FourierTransform::apply(Element* series, Element* scratch) const {
    Element* from = series;
    Element* to = scratch;
    for (const Stage& stage : stages_) {
        const auto* row = std::find_if(std::begin(kRadices), std::end(kRadices),
                                       [&](const Radix& r) { return r.radix == stage.radix; });
        row->stage(from, to, stage.n_groups, stage.stride, stage.factors.data());
        std::swap(from, to);
    }
    if (from != series) std::copy_n(from, length_, series);
}

}  // namespace pcvt::plane
