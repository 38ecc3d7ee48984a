#include "mesher/cells/target_areas.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <random>
#include <string_view>

#include "mesher/base/error.hpp"
#include "mesher/portable/decimal_text.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

struct LawRow {
    AreaLaw::Kind kind;
    std::string_view word;
    bool has_spread;
};

constexpr std::array kLaws{LawRow{AreaLaw::Kind::kEqual, "equal", false},
                           LawRow{AreaLaw::Kind::kLognormal, "lognormal", true},
                           LawRow{AreaLaw::Kind::kGamma, "gamma", true}};

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

/// A diameter of the law, in any unit.
double draw_diameter(const AreaLaw& law, RandomNumbers& random) {
    switch (law.kind) {
        case AreaLaw::Kind::kLognormal: {
            const double sigma = std::sqrt(portable_log(1 + law.spread * law.spread));
            return portable_exp(sigma * random.normal());
        }
        case AreaLaw::Kind::kGamma:
            return random.gamma(1 / (law.spread * law.spread));
        default:
            return 1;
    }
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
    for (double& d : diameters) d = draw_diameter(law, random);
    return diameters;
}

const LawRow* find_row(std::string_view text) {
    const std::string_view word = text.substr(0, text.find(':'));
    for (const LawRow& row : kLaws) {
        if (row.word == word) return &row;
    }
    return nullptr;
}

}  // namespace

bool names_area_law(const std::string& text) { return find_row(text) != nullptr; }

AreaLaw parse_area_law(const std::string& text) {
    const LawRow* const row = find_row(text);
    if (row == nullptr) {
        throw InvalidInput("'" + text +
                           "' is not a law of areas; choose equal, lognormal:S or gamma:S");
    }
    AreaLaw law{.kind = row->kind};
    const std::size_t colon = text.find(':');
    if (!row->has_spread) {
        if (colon == std::string::npos) return law;
        throw InvalidInput("'" + text + "': equal areas have no spread; write 'equal'");
    }
    const char* const end = text.data() + text.size();
    const char* const begin = colon == std::string::npos ? end : text.data() + colon + 1;
    const auto [stop, error] = read_decimal(begin, end, law.spread);
    if (error == std::errc{} && stop == end && law.spread > 0 && law.spread <= kMostSpread) {
        return law;
    }
    throw InvalidInput("'" + text + "': write '" + std::string(row->word) +
                       ":S', where S, the standard deviation of the diameters over their mean, is "
                       "above 0 and at most " +
                       three_digits(kMostSpread));
}

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
