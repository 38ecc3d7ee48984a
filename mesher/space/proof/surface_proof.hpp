#pragma once

#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt::space {

/// Figures that the proof of a surface finds.
struct SurfaceProof {
    int n_points = 0;
    int n_faces = 0;
    /// The number of translations, counted once for both directions.
    int n_translations = 0;
    /// points - edges + faces: 2 for a ball.
    int euler = 0;
    /// The number of connected parts.
    int n_parts = 0;
    double volume = 0;
    /// The largest distance of a corner from the plane between the sites of its cells, in units of
    /// h; 0 without sites.
    double from_bisector = 0;
};

/// Proves the laws of TileSurface. Positions of partners may differ by 4 double ulps of the largest
/// coordinate.
///
/// Example usage:
///     std::cout << prove_surface(surface).volume;
///
/// @throws NotATile with the law and the first face or point that breaks it.
SurfaceProof prove_surface(const TileSurface& surface);

}  // namespace pcvt::space
