#include "plugin/cli/density_option.hpp"

#include <algorithm>
#include <cctype>

#include "io/density_expression.hpp"
#include "io/density_image.hpp"
#include "io/text.hpp"
#include "mesher/density_breaks.hpp"
#include "plugin/cli/option_values.hpp"

namespace pcvt::cli {
namespace {

GreyRange grey_range(const std::string& text) {
    const Vec2 range = point("--density-range", text);
    for (const double limit : {range.x(), range.y()}) {
        if (!(limit >= kLeastDensity && limit <= kGreatestDensity)) {
            throw InvalidInput("--density-range " + text +
                               ": not from 1e-60 to 1e60; give two positive densities LO,HI");
        }
    }
    return {range.x(), range.y()};
}

}  // namespace

bool names_picture(const std::string& density) {
    std::string end = density.substr(density.size() - std::min<std::size_t>(density.size(), 4));
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end == ".png";
}

Density density_option(const std::string& density, const std::string& range,
                       const Lattice& lattice) {
    if (names_picture(density)) {
        return png_density(density, range.empty() ? GreyRange{} : grey_range(range));
    }
    if (!range.empty()) {
        throw InvalidInput("--density-range is for --density FILE.png; remove it");
    }
    try {
        return with_axis_breaks(lattice, expression_density(density));
    } catch (const InvalidInput& error) {
        throw InvalidInput("--density " + in_quotes(density) + ": " + error.what());
    }
}

}  // namespace pcvt::cli
