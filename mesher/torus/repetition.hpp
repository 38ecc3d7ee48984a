#pragma once

namespace pcvt {

/// Copies of a domain, side by side.
///
/// Example usage:
///   const Repetition repeat{.columns = 3, .rows = 2};
///   const plane::Lattice whole = lattice.repeated(repeat.columns, repeat.rows);
struct Repetition {
    /// Along the first and the second period.
    int columns = 1;
    int rows = 1;

    /// The number of all copies.
    double n_copies() const { return double(columns) * rows; }
};

}  // namespace pcvt
