#include "mesher/cells/target_areas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/portable/decimal_text.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

/// Separates the numbers from those that uniform_points draws from the same seed.
constexpr std::uint64_t kSeedOfAreas = 0x9e3779b97f4a7c15;

/// Random numbers that are the same on every machine.
class RandomNumbers {
   public:
    explicit RandomNumbers(std::uint64_t seed) : generator_(seed ^ kSeedOfAreas) {}

    /// In (0, 1).
    double uniform() { return std::ldexp(double(generator_() >> 12) + 0.5, -52); }
    /// Normally distributed, by G. Marsaglia's polar method.
    double normal() {
        for (;;) {
            const double x = 2 * uniform() - 1;
            const double y = 2 * uniform() - 1;
            const double s = x * x + y * y;
            if (s < 1 && s > 0) return x * std::sqrt(-2 * portable_log(s) / s);
        }
    }
    /// Gamma distributed with scale 1 (G. Marsaglia, W. Tsang 2000).
    double gamma(double shape) {
        if (shape < 1) return gamma(shape + 1) * portable_exp(portable_log(uniform()) / shape);
        const double d = shape - 1.0 / 3;
        for (;;) {
            const double x = normal();
            const double root = 1 + x / std::sqrt(9 * d);
            if (!(root > 0)) continue;
            const double v = root * root * root;
            if (portable_log(uniform()) < x * x / 2 + d * (1 - v + portable_log(v))) return d * v;
        }
    }

   private:
    std::mt19937_64 generator_;
};

double lognormal_sigma(double spread) { return std::sqrt(portable_log(1 + spread * spread)); }

/// A diameter of the law, in a unit of its own.
double draw_diameter(const LawComponent& law, RandomNumbers& random) {
    switch (law.kind) {
        case LawComponent::Kind::kLognormal:
            return portable_exp(lognormal_sigma(law.spread) * random.normal());
        case LawComponent::Kind::kGamma:
            return random.gamma(1 / (law.spread * law.spread));
        default:
            return 1;
    }
}

/// The mean of draw_diameter().
double mean_diameter(const LawComponent& law) {
    switch (law.kind) {
        case LawComponent::Kind::kLognormal:
            return std::sqrt(1 + law.spread * law.spread);
        case LawComponent::Kind::kGamma:
            return 1 / (law.spread * law.spread);
        default:
            return 1;
    }
}

/// How many of n cells have each law: the whole parts of the shares of n, and one more where the
/// rest is largest.
std::vector<int> numbers_of_cells(const AreaLaw& law, int n) {
    std::vector<int> numbers;
    std::vector<double> rests;
    int n_left = n;
    for (const LawComponent& component : law.components) {
        const double exact = component.share * n;
        numbers.push_back(std::min(n_left, static_cast<int>(exact)));
        rests.push_back(exact - numbers.back());
        n_left -= numbers.back();
    }
    for (; n_left > 0; --n_left) {
        const auto largest = std::max_element(rests.begin(), rests.end());
        ++numbers[static_cast<std::size_t>(largest - rests.begin())];
        *largest = -1;
    }
    return numbers;
}

/// Draws the law of one cell, so that every order of the laws is as likely, and takes the cell off.
std::size_t draw_law(std::vector<int>& numbers, int n_left, RandomNumbers& random) {
    int k = static_cast<int>(random.uniform() * n_left);
    std::size_t law = 0;
    while (k >= numbers[law]) k -= numbers[law++];
    --numbers[law];
    return law;
}

std::string three_digits(double x) {
    std::array<char, 32> text{};
    char* const end =
        write_decimal(text.data(), text.data() + text.size(), x, std::chars_format::general, 3);
    return {text.data(), end};
}

/// Scales sizes to the sum `total`, as scaled_areas() does.
/// @param word  of a size in messages.
Eigen::VectorXd scaled_sizes(const Eigen::VectorXd& sizes, int n_sites, double total,
                             const std::string& word) {
    if (sizes.size() != n_sites) {
        throw InvalidInput("there are " + std::to_string(sizes.size()) + " " + word + "s for " +
                           std::to_string(n_sites) + " sites; give one for each site");
    }
    for (int s = 0; s < n_sites; ++s) {
        if (std::isfinite(sizes[s]) && sizes[s] > 0) continue;
        throw InvalidInput("the " + word + " of site " + std::to_string(s) + " is " +
                           three_digits(sizes[s]) + "; give a positive number");
    }
    // The largest area first: sums of very large sizes stay finite.
    const Eigen::VectorXd relative = sizes / sizes.maxCoeff();
    const double mean = relative.mean();
    Eigen::Index smallest = 0;
    const double least = relative.minCoeff(&smallest) / mean;
    if (!(least >= kLeastArea)) {
        throw InvalidInput("the " + word + " of site " + std::to_string(smallest) + " is " +
                           three_digits(least) + " of the mean; give " + word + "s above " +
                           three_digits(kLeastArea) +
                           " of the mean, or a law with a smaller spread");
    }
    return relative * (total / relative.sum());
}

Eigen::VectorXd draw_diameters(const AreaLaw& law, int n, std::uint64_t seed) {
    RandomNumbers random(seed);
    Eigen::VectorXd diameters(n);
    if (law.components.size() == 1) {
        for (double& d : diameters) d = draw_diameter(law.components[0], random);
        return diameters;
    }
    std::vector<int> numbers = numbers_of_cells(law, n);
    for (int s = 0; s < n; ++s) {
        const LawComponent& own = law.components[draw_law(numbers, n - s, random)];
        diameters[s] = draw_diameter(own, random) * (own.mean / mean_diameter(own));
    }
    return diameters;
}

}  // namespace

Eigen::VectorXd draw_areas(const AreaLaw& law, int n, std::uint64_t seed) {
    return areas_of_diameters(draw_diameters(law, n, seed));
}

Eigen::VectorXd draw_volumes(const AreaLaw& law, int n, std::uint64_t seed) {
    return volumes_of_diameters(draw_diameters(law, n, seed));
}

Eigen::VectorXd areas_of_diameters(const Eigen::VectorXd& diameters) {
    // Keeps the sign, so that scaled_areas refuses a negative diameter.
    return std::numbers::pi / 4 * diameters.array() * diameters.array().abs();
}

Eigen::VectorXd volumes_of_diameters(const Eigen::VectorXd& diameters) {
    return std::numbers::pi / 6 * diameters.array().square() * diameters.array();
}

Eigen::VectorXd scaled_areas(const Eigen::VectorXd& areas, int n_sites, double total) {
    return scaled_sizes(areas, n_sites, total, "area");
}

Eigen::VectorXd scaled_volumes(const Eigen::VectorXd& volumes, int n_sites, double total) {
    return scaled_sizes(volumes, n_sites, total, "volume");
}

std::optional<double> area_scale(const Eigen::VectorXd& areas, double total) {
    const double scale = total / areas.sum();
    return std::isfinite(scale) && scale > 0 ? std::optional(scale) : std::nullopt;
}

double diameter_spread(const Eigen::VectorXd& sizes, int dimension) {
    Eigen::ArrayXd diameters = sizes.array() / sizes.maxCoeff();
    for (double& d : diameters) d = dimension == 3 ? portable_cbrt(d) : std::sqrt(d);
    const double mean = diameters.mean();
    return std::sqrt((diameters - mean).square().mean()) / mean;
}

}  // namespace pcvt
