#include "plugin/cli/density_option.hpp"

#include "io/bytes/text.hpp"
#include "plugin/cli/option_values.hpp"
#include "plugin/job/job_density.hpp"

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

Density density_option(const std::string& density, const std::string& range,
                       const Lattice& lattice) {
    if (names_picture(density)) {
        std::optional<GreyRange> greys;
        if (!range.empty()) greys = grey_range(range);
        return source_density(density, greys, lattice);
    }
    if (!range.empty()) {
        throw InvalidInput("--density-range is for --density FILE.png; remove it");
    }
    try {
        return source_density(density, {}, lattice);
    } catch (const InvalidInput& error) {
        throw InvalidInput("--density " + in_quotes(density) + ": " + error.what());
    }
}

}  // namespace pcvt::cli
