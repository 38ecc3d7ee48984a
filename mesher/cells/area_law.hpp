#pragma once

#include <string>
#include <vector>

namespace pcvt {

/// One law of a mixture.
struct LawComponent {
    enum class Kind { kEqual, kLognormal, kGamma };
    Kind kind = Kind::kEqual;
    /// Standard deviation over mean of the equivalent diameter; not used for kEqual.
    double spread = 0;
    /// The part of the cells that have this law; the shares of a mixture sum to 1.
    double share = 1;
    /// The mean equivalent diameter, in a unit that all laws of the mixture share.
    double mean = 1;

    friend bool operator==(const LawComponent&, const LawComponent&) = default;
};

/// The distribution of the equivalent diameters of cells, 2 sqrt(area / pi) or (6 volume /
/// pi)^(1/3): one law, or a mixture of several.
struct AreaLaw {
    std::vector<LawComponent> components = {{}};

    /// Whether diameters of the law depend on a seed.
    bool is_random() const {
        return components.size() > 1 || components[0].kind != LawComponent::Kind::kEqual;
    }

    friend bool operator==(const AreaLaw&, const AreaLaw&) = default;
};

/// The largest spread of a law.
inline constexpr double kMostSpread = 2;
/// Mean diameters of a mixture lie between the inverse of this and this.
inline constexpr double kMostMeanDiameter = 1e9;
/// Shares of a mixture are scaled to the sum 1, from which they may differ by rounding, as three
/// times 0.333 does.
inline constexpr double kShareRounding = 2e-3;

/// Whether the text names a law, that is begins with the word of one or with SHARE*, rather than a
/// file.
bool names_area_law(const std::string& text);

/// Reads `equal`, `lognormal:S`, `gamma:S` or a mixture of them, `SHARE*LAW@MEAN+SHARE*LAW@MEAN`,
/// where SHARE is the part of the cells and MEAN their mean diameter in any unit; blanks may
/// surround the signs of a mixture.
///
/// Example usage:
///
///     const AreaLaw law = parse_area_law("0.7*lognormal:0.3@1 + 0.3*gamma:0.2@3");
///     const Eigen::VectorXd areas = scaled_areas(draw_areas(law, n, seed), n, lattice.area());
///
/// @throws InvalidInput for another text, unless 0 < S <= kMostSpread, the shares are positive and
///         sum to 1, and the means are within kMostMeanDiameter.
AreaLaw parse_area_law(const std::string& text);

}  // namespace pcvt
