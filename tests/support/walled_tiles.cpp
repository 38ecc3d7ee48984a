#include "tests/support/walled_tiles.hpp"

#include "mesher/cvt/walled_cvt.hpp"

namespace pcvt::testing {

Tile walled_tile(Walls walls, WallCells cells, int n, TileOptions options) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    const WalledCvt cvt =
        compute_walled_cvt(lattice, walls, cells, uniform_points(lattice, n, 4), {});
    options.walled = cvt.domain;
    return build_tile(cvt.torus.delaunay, options).tile;
}

std::vector<Tile> walled_tiles(Walls walls) {
    std::vector<Tile> tiles;
    for (const int order : {1, 2}) {
        for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
            const TileOptions grains{.kind = MeshKind::kGrains, .outline = outline, .order = order};
            tiles.push_back(walled_tile(walls, WallCells::kWhole, 7, grains));
            tiles.push_back(walled_tile(walls, WallCells::kHalf, 14, grains));
        }
        const TileOptions grains{.kind = MeshKind::kGrains, .order = order};
        tiles.push_back(walled_tile(walls, WallCells::kWhole, 1, grains));
    }
    tiles.push_back(walled_tile(walls, WallCells::kHalf, 14, {.kind = MeshKind::kDelaunay}));
    return tiles;
}

}  // namespace pcvt::testing
