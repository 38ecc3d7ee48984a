#pragma once

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt::plane {

/// The sides of a rectangle, which walls need: its width and its height.
/// @pre is_upright().
inline double side_length(const Lattice& lattice, int axis) {
    return axis == 0 ? lattice.a().x() : lattice.b().y();
}

/// Whether the period vectors are (width, 0) and (0, height) with positive sides.
inline bool is_upright(const Lattice& lattice) {
    return lattice.a().y() == 0 && lattice.b().x() == 0 && lattice.a().x() > 0 &&
           lattice.b().y() > 0;
}

/// Where the points of a wall lie along its axis.
inline double wall_line(const WallSideRow& row, const Lattice& lattice) {
    return row.at_end ? side_length(lattice, row.axis) : 0;
}

/// The lattice of the torus that consists of a domain between walls and its mirror images.
inline Lattice mirrored_lattice(const Lattice& domain, Walls walls) {
    return domain.repeated(has_walls_across(walls, 0) ? 2 : 1, has_walls_across(walls, 1) ? 2 : 1);
}

/// The part of a torus that lies between walls; the rest of the torus consists of its
/// mirror images.
struct WalledDomain {
    Walls walls = Walls::kY;
    /// The upright lattice of the domain. The torus has mirrored_lattice(lattice, walls).
    Lattice lattice = Lattice::rectangle(1, 1);
    /// Sites of the domain, numbered before their images; those on walls are counted whole.
    int n_sites = 0;
    /// Sites of the domain that lie on walls.
    int n_on_walls = 0;

    WalledDomain repeated(int columns, int rows) const {
        return {walls, lattice.repeated(columns, rows), n_sites, n_on_walls};
    }
    /// The number of images of a general point.
    int n_images() const { return pcvt::n_images(walls); }
};

}  // namespace pcvt::plane
