#pragma once

namespace pcvt {

/// Lengths of a tile that is to be stored in 32-bit floats, known before it is computed.
struct FloatLengths {
    /// The mean distance of the sites.
    double h;
    double shortest_period;
    /// About the largest coordinate.
    double largest;
    /// Whether weights, which are squares of lengths, are stored too.
    bool has_weights = false;
};

/// Requires that floats hold the lengths with all their digits, and that they resolve the cells.
///
/// Example usage:
///   require_floats({.h = 0.1, .shortest_period = 1, .largest = 1});
///
/// @throws InvalidInput with the remedy.
void require_floats(const FloatLengths& lengths);

struct FormatRequest;

/// The same for a tile of the plane (tile_formats.hpp): in glTF, which moves distant tiles near 0,
/// and in PLY, if the request is for 32-bit coordinates.
void require_gltf_precision(const FormatRequest& request);
void require_ply_precision(const FormatRequest& request);

}  // namespace pcvt
