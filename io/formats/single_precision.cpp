#include "io/formats/single_precision.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "io/formats/formats.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// Numbers between these are normal floats, also when they are some times smaller or larger.
constexpr double kSmallestFloat = 1e-37;
constexpr double kLargestFloat = 1e37;
/// The least h, in ulps of the largest coordinate: vertices within 4 ulps become one vertex.
constexpr double kLeastUlps = 16;

bool is_held(double number) { return number >= kSmallestFloat && number <= kLargestFloat; }

/// @param distance  of the domain from 0.
void require_floats_of(const FormatRequest& request, double distance) {
    const double size = std::max(request.lattice.a().norm(), request.lattice.b().norm());
    require_floats({.h = request.spacing(),
                    .shortest_period = reduce(request.lattice).reduced.a().norm(),
                    .largest = distance + size,
                    .has_weights = request.has_weights});
}

}  // namespace

void require_floats(const FloatLengths& lengths) {
    const double shortest = std::min(lengths.h, lengths.shortest_period);
    const double longest = lengths.largest;
    const bool holds_weights =
        !lengths.has_weights || (is_held(shortest * shortest) && is_held(longest * longest));
    if (!is_held(shortest) || !is_held(longest) || !holds_weights) {
        throw InvalidInput(std::string("32-bit floats do not hold ") +
                           (holds_weights
                                ? "coordinates"
                                : "the weights of prescribed areas, squares of lengths,") +
                           " in this unit of length; take another unit, or a format of double "
                           "precision, such as .obj");
    }
    if (lengths.h > kLeastUlps * double(std::numeric_limits<float>::epsilon()) * longest) return;
    throw InvalidInput(
        "32-bit floats do not resolve cells that are so small beside their coordinates; take an "
        "origin nearer to 0, or a format of double precision, such as .obj");
}

void require_gltf_precision(const FormatRequest& request) { require_floats_of(request, 0); }

void require_ply_precision(const FormatRequest& request) {
    if (request.files.single_precision) require_floats_of(request, request.tile.origin.norm());
}

}  // namespace pcvt
