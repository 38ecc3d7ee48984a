#pragma once

#include <vector>

#include "mesher/space/grains/cell_hull.hpp"

namespace pcvt::space {

/// Features below this angle are named, degrees, and edges whose angle is this near to 180.
inline constexpr double kSharpAngle = 20;
/// Narrower faces keep long thin triangles in their middle.
inline constexpr double kNarrowPart = 0.05;

/// A corner of a face, or an edge of a cell, beside which an angle below kSharpAngle is
/// unavoidable; a face narrower than kNarrowPart of its length; or a cell that is flat over the
/// size of its tetrahedra.
struct SharpFeature {
    enum class Kind { kFaceCorner, kCellEdge, kNarrowFace, kFlatCell };
    Kind kind;
    /// One of the two cells of the face, the cell of the edge, or the flat cell.
    SiteId cell;
    /// The corner, the middle of the edge, the first corner of the face, or the site, in the frame
    /// of the cell, length units.
    Vec3 place;
    /// The angle between the edges at the corner, between the faces at the edge, or
    /// FlatCell::angle, degrees.
    double angle;
};

/// The sharp features of the cells.
struct SharpFeatures {
    std::vector<SharpFeature> features = {};
    /// For each cell and each point of its hull whether it lies on a feature of the cell, or is a
    /// corner of a triangle with an angle below kSharpAngle that touches one.
    std::vector<std::vector<char>> near = {};
};

/// Finds the sharp features.
///
/// Law, tested by number:
///   (1) Each feature has the angle that its corner or its edge has in the cells.
///
/// @param hulls  cell_hulls() of the surface.
SharpFeatures sharp_features(const CellComplex& complex, const GrainSurface& surface,
                             const std::vector<CellHull>& hulls);

}  // namespace pcvt::space
