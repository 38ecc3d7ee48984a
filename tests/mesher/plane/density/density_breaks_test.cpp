#include "mesher/plane/density/density_breaks.hpp"

#include <gmock/gmock.h>

#include "tests/support/densities.hpp"

namespace pcvt::plane {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

template <class Function>
Density found(const Function& function) {
    return with_axis_breaks(Lattice({1, 0}, {0.3, 2}), shared_density(function));
}

TEST(DensityBreaks, JumpsAlongTheAxesAreFoundToTheLastDigits) {
    const Density density = found([](const DensityPoint& p) {
        return (p.u < 1.0 / 3 ? 1 : 7) + (p.v < 0.9 ? 0.5 : 0) + 0.1 * p.u;
    });
    EXPECT_THAT(density.u_breaks, ElementsAre(DoubleNear(1.0 / 3, 1e-15)));
    EXPECT_THAT(density.v_breaks, ElementsAre(DoubleNear(0.9, 1e-15)));
}

TEST(DensityBreaks, ACheckerboardHasOneLineInEachDirection) {
    const Density density = with_axis_breaks(Lattice::rectangle(1, 1), testing::checkerboard());
    EXPECT_THAT(density.u_breaks, ElementsAre(DoubleNear(0.5, 1e-15)));
    EXPECT_THAT(density.v_breaks, ElementsAre(DoubleNear(0.5, 1e-15)));
}

TEST(DensityBreaks, SmoothDensitiesHaveNoBreaks) {
    for (const Density& density : {testing::smooth_density(), testing::ridge_density()}) {
        const Density same = with_axis_breaks(Lattice::rectangle(1, 1), density);
        EXPECT_THAT(same.u_breaks, IsEmpty());
        EXPECT_THAT(same.v_breaks, IsEmpty());
    }
    const Density steep =
        found([](const DensityPoint& p) { return 2 + std::tanh((p.u - 0.4) * 1e6); });
    EXPECT_THAT(steep.u_breaks, IsEmpty());
}

TEST(DensityBreaks, JumpsAlongOtherCurvesAreNotFound) {
    const Density disc = with_axis_breaks(Lattice::rectangle(1, 1), testing::disc_density());
    EXPECT_THAT(disc.u_breaks, IsEmpty());
    EXPECT_THAT(disc.v_breaks, IsEmpty());
}

}  // namespace
}  // namespace pcvt::plane
