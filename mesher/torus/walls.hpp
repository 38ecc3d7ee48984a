#pragma once

#include <array>
#include <string_view>

#include "mesher/base/choices.hpp"

namespace pcvt {

/// Which opposite sides of a rectangular domain are walls: none, those across x, those across y, or
/// all four. The domain stays periodic along the other direction.
enum class Walls { kNone, kX, kY, kXY };

/// Walls in options, files, reports and the C interface.
struct WallsRow {
    Walls walls;
    const char* word;
    /// PCVT_WALLS_... of pcvt.h.
    int abi_value;
    /// Whether the sides across x, and those across y, are walls.
    std::array<bool, 2> across;
    /// For the command's help.
    const char* help;
};

/// In the order of the enumerators.
inline constexpr std::array kWalls{
    WallsRow{Walls::kNone, "none", 0, {false, false}, "periodic along both directions"},
    WallsRow{Walls::kX, "x", 1, {true, false}, "walls at x = 0 and at the width"},
    WallsRow{Walls::kY, "y", 2, {false, true}, "walls at y = 0 and at the height"},
    WallsRow{Walls::kXY, "xy", 3, {true, true}, "a closed box"}};

constexpr const WallsRow& walls_row(Walls walls) { return kWalls[static_cast<std::size_t>(walls)]; }

/// Whether the sides across an axis (0: x, 1: y) are walls.
constexpr bool has_walls_across(Walls walls, int axis) { return walls_row(walls).across[axis]; }

/// How many domains a domain and its mirror images are: 1, 2 or 4.
constexpr int n_images(Walls walls) {
    return (has_walls_across(walls, 0) ? 2 : 1) * (has_walls_across(walls, 1) ? 2 : 1);
}

/// Walls as two numbers of a file: 1 for walls across x, 1 for walls across y, else 0.
constexpr std::array<double, 2> walls_as_numbers(Walls walls) {
    return {has_walls_across(walls, 0) ? 1.0 : 0.0, has_walls_across(walls, 1) ? 1.0 : 0.0};
}

/// The row of two such numbers, or nullptr.
constexpr const WallsRow* walls_of_numbers(double across_x, double across_y) {
    return find_row(kWalls, [=](const WallsRow& row) {
        return walls_as_numbers(row.walls) == std::array{across_x, across_y};
    });
}

/// The cells beside a wall: whole cells of sites off the wall, or halves of cells whose sites lie
/// on it.
enum class WallCells { kWhole, kHalf };

struct WallCellsRow {
    WallCells cells;
    const char* word;
    /// PCVT_WALL_CELLS_... of pcvt.h.
    int abi_value;
    const char* help;
};

/// In the order of the enumerators.
inline constexpr std::array kWallCells{
    WallCellsRow{WallCells::kWhole, "whole", 0, "the sites beside a wall lie off it"},
    WallCellsRow{WallCells::kHalf, "half", 1, "the sites beside a wall lie on it"}};

constexpr const WallCellsRow& wall_cells_row(WallCells cells) {
    return kWallCells[static_cast<std::size_t>(cells)];
}

/// One side of the domain that is a wall.
enum class WallSide { kLeft, kRight, kBottom, kTop };

/// A wall as files name it.
///
/// Example usage:
///   const WallSideRow& row = wall_side_row(edge.side);
///   assert(tile.points[edge.v0][row.axis] == wall_line(row, tile.lattice));
struct WallSideRow {
    WallSide side;
    /// The name of its patch, group or set in every format.
    const char* word;
    /// 0: across x, 1: across y.
    int axis;
    /// Whether it lies at the end of the axis and not at 0.
    bool at_end;
};

/// In the order of the enumerators.
inline constexpr std::array kWallSides{WallSideRow{WallSide::kLeft, "wall_left", 0, false},
                                       WallSideRow{WallSide::kRight, "wall_right", 0, true},
                                       WallSideRow{WallSide::kBottom, "wall_bottom", 1, false},
                                       WallSideRow{WallSide::kTop, "wall_top", 1, true}};

constexpr const WallSideRow& wall_side_row(WallSide side) {
    return kWallSides[static_cast<std::size_t>(side)];
}

}  // namespace pcvt
