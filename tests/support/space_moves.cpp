#include "tests/support/space_moves.hpp"

#include <cmath>

#include "tests/support/random_numbers.hpp"

namespace pcvt::testing {
namespace {

using Random = std::mt19937_64;

space::Vec3 uniform_vector(Random& random, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    const double x = uniform(random);
    const double y = uniform(random);
    return {x, y, uniform(random)};
}

/// Collects displacements in coordinates of the reduced basis.
class Direction {
   public:
    explicit Direction(const space::MovingTetrahedra& moving)
        : moving_(moving),
          numbers_(Eigen::VectorXf::Zero(space::MovingTetrahedra::kNumbersPerSite *
                                         Eigen::Index{size()})) {}

    int size() const { return moving_.n_sites(); }
    /// A displacement in the frame.
    void set(SiteId site, const space::Vec3& move) {
        numbers_.segment<3>(space::MovingTetrahedra::kNumbersPerSite * Eigen::Index{site}) =
            move.cast<float>();
    }
    void set_coordinates(SiteId site, const space::Vec3& move) {
        set(site, moving_.frame().to_position(move));
    }
    const Eigen::VectorXf& numbers() const { return numbers_; }

   private:
    const space::MovingTetrahedra& moving_;
    Eigen::VectorXf numbers_;
};

/// Moves both sites by `times` half of their distance towards each other: 1 lets them meet at the
/// middle, 2 exchanges them.
void approach(Direction& direction, const space::MovingTetrahedra& moving, Random& random,
              double times) {
    const SiteId first = random_integer(random, 0, direction.size() - 1);
    const SiteId second = random_integer(random, 0, direction.size() - 1);
    const space::Vec3 between = moving.coordinates().col(second) - moving.coordinates().col(first);
    const space::Vec3 nearest = between - between.array().round().matrix();
    direction.set_coordinates(first, times / 2 * nearest);
    direction.set_coordinates(second, -times / 2 * nearest);
}

void lloyd(Direction& direction, const Energy& energy) {
    for (SiteId s = 0; s < direction.size(); ++s) {
        direction.set(s, energy.gradient.segment<3>(space::MovingTetrahedra::kNumbersPerSite * s) /
                             (-2 * energy.mass[s]));
    }
}

}  // namespace

NamedSpaceMove random_space_move(const space::MovingTetrahedra& moving, const Energy& energy,
                                 Random& random) {
    Direction direction(moving);
    const auto for_each = [&](const auto& move) {
        for (SiteId s = 0; s < direction.size(); ++s) move(s);
    };
    const auto done = [&](const char* name) { return NamedSpaceMove{name, direction.numbers()}; };
    const space::Vec3 drift = uniform_vector(random, 1);
    const double share = std::uniform_real_distribution()(random);
    const int count = random_integer(random, 2, 9);
    const double size = moving.spacing() * std::pow(10.0, -random_integer(random, 0, 12));
    switch (random_integer(random, 0, 8)) {
        case 0:
            for_each([&](SiteId s) { direction.set_coordinates(s, drift); });
            return done("drift");
        case 1:
            for_each([&](SiteId s) {
                direction.set_coordinates(s, uniform_vector(random, 1.5).array().round());
            });
            return done("jumps by periods");
        case 2:
            for_each([&](SiteId s) {
                if (random_integer(random, 0, direction.size()) > 3) return;
                direction.set_coordinates(s, uniform_vector(random, 1));
            });
            return done("jumps of some sites");
        case 3:
            for_each([&](SiteId s) {
                if (std::uniform_real_distribution()(random) > share) return;
                const space::Vec3 u = moving.coordinates().col(s);
                direction.set_coordinates(s, (u * count).array().round().matrix() / count - u);
            });
            return done("to a grid");
        case 4:
            approach(direction, moving, random, 1);
            return done("meeting");
        case 5:
            approach(direction, moving, random, 2);
            return done("exchange");
        case 6:
            lloyd(direction, energy);
            return done("step of Lloyd's method");
        default:
            for_each([&](SiteId s) { direction.set(s, uniform_vector(random, size)); });
            return done("noise");
    }
}

}  // namespace pcvt::testing
