#pragma once

namespace pcvt {

/// Copies of a domain, side by side.
///
/// Example usage:
///   const Repetition repeat{.columns = 3, .rows = 2};
///   const plane::Lattice whole = lattice.repeated(repeat.columns, repeat.rows);
struct Repetition {
    /// Along the first, the second and in space the third period.
    int columns = 1;
    int rows = 1;
    int layers = 1;

    /// The number of all copies.
    double n_copies() const { return double(columns) * rows * layers; }
};

}  // namespace pcvt
