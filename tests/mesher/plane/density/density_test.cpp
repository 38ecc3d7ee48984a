#include "mesher/plane/density/density.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

template <class Function>
DensityProbe probe_of(const Lattice& lattice, const Function& function) {
    return {lattice, pointwise(function)};
}

std::string refusal(double value) {
    DensityProbe probe = probe_of(Lattice::rectangle(2, 4), [value](const DensityPoint& p) {
        return p.u > 0.4 ? value : 1.0;
    });
    const std::array points{probe.point(0.25, 0), probe.point(0.5, 0.25), probe.point(0.75, 0)};
    try {
        probe.evaluate(points);
    } catch (const BadDensity& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Density, IsRejectedAtTheFirstPointWhereItIsNotPositiveAndFinite) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto at = HasSubstr("at x = 1, y = 1 (u = 0.5, v = 0.25); make it positive and finite");
    EXPECT_THAT(refusal(0), HasSubstr("the density is 0 "));
    EXPECT_THAT(refusal(-3), HasSubstr("the density is -3 "));
    EXPECT_THAT(refusal(kInfinity), HasSubstr("the density is inf "));
    EXPECT_THAT(refusal(std::nan("")), HasSubstr("the density is not a number "));
    for (const double bad : {0.0, -3.0, kInfinity, -kInfinity, std::nan("")}) {
        EXPECT_THAT(refusal(bad), at) << bad;
    }
    EXPECT_THAT(refusal(1e-61), HasSubstr("between 1e-60 and 1e60"));
    EXPECT_THAT(refusal(1e61), HasSubstr("between 1e-60 and 1e60"));
    EXPECT_EQ(refusal(1e-60), "accepted");
    EXPECT_EQ(refusal(1e60), "accepted");
}

TEST(Density, MayNotVaryByMoreThanTheContrast) {
    EXPECT_NO_THROW((DensityRange{1, 1e12, 2}.require_contrast()));
    try {
        DensityRange{0.5, 1e12, 2}.require_contrast();
        FAIL();
    } catch (const BadDensity& error) {
        EXPECT_THAT(error.what(), HasSubstr("from 0.5 to 1e+12"));
    }
}

TEST(Density, IsEvaluatedBelowOneOnly) {
    DensityProbe probe = probe_of(Lattice({1, 0}, {0.5, 2}), [](const DensityPoint& p) {
        EXPECT_LT(p.u, 1);
        EXPECT_LT(p.v, 1);
        EXPECT_DOUBLE_EQ(p.x, p.u + 0.5 * p.v);
        EXPECT_DOUBLE_EQ(p.y, 2 * p.v);
        return 1.0;
    });
    const std::array points{probe.point(1, 1), probe.point(0, 1), probe.point(0.3, 0.6)};
    probe.evaluate(points);
}

TEST(Density, RangeHasTheExtremesAndTheCountSinceTheLastCall) {
    DensityProbe probe =
        probe_of(Lattice::rectangle(1, 1), [](const DensityPoint& p) { return 1 + p.u; });
    const std::array points{probe.point(0.5, 0), probe.point(0.25, 0), probe.point(0.75, 0)};
    probe.evaluate(points);
    const DensityRange range = probe.take_range();
    EXPECT_EQ(range.least, 1.25);
    EXPECT_EQ(range.greatest, 1.75);
    EXPECT_EQ(range.n_evaluations, 3);
    EXPECT_EQ(probe.take_range().n_evaluations, 0);
}

TEST(Density, FunctionsAreCreatedOncePerProbeAndReused) {
    int n_made = 0;
    const Density density{[&n_made] {
        ++n_made;
        return pointwise([](const DensityPoint&) { return 2.0; });
    }};
    DensityProbes probes(Lattice::rectangle(1, 1), density);
    for (int k = 0; k < 3; ++k) {
        probes.with_probe(
            [](DensityProbe& probe) { probe.evaluate(std::array{probe.point(0, 0)}); });
    }
    EXPECT_EQ(n_made, 1);
    EXPECT_EQ(probes.range().n_evaluations, 3);
    probes.with_probe([&](DensityProbe&) { probes.with_probe([](DensityProbe&) {}); });
    EXPECT_EQ(n_made, 2);
}

}  // namespace
}  // namespace pcvt::plane
