#include "tests/support/walled_tiles.hpp"

#include "mesher/plane/cvt/walled_cvt.hpp"

namespace pcvt::testing {

plane::Tile walled_tile(Walls walls, WallCells cells, int n, plane::TileOptions options) {
    const plane::Lattice lattice = plane::Lattice::rectangle(2, 1);
    const plane::WalledCvt cvt =
        compute_walled_cvt(lattice, walls, cells, uniform_points(lattice, n, 4), {});
    options.walled = cvt.domain;
    return build_tile(cvt.torus.delaunay, options).tile;
}

std::vector<plane::Tile> walled_tiles(Walls walls) {
    std::vector<plane::Tile> tiles;
    for (const int order : {1, 2}) {
        for (const plane::Outline outline : {plane::Outline::kWhole, plane::Outline::kBox}) {
            const plane::TileOptions grains{
                .kind = plane::MeshKind::kGrains, .outline = outline, .order = order};
            tiles.push_back(walled_tile(walls, WallCells::kWhole, 7, grains));
            tiles.push_back(walled_tile(walls, WallCells::kHalf, 14, grains));
        }
        const plane::TileOptions grains{.kind = plane::MeshKind::kGrains, .order = order};
        tiles.push_back(walled_tile(walls, WallCells::kWhole, 1, grains));
    }
    tiles.push_back(walled_tile(walls, WallCells::kHalf, 14, {.kind = plane::MeshKind::kDelaunay}));
    return tiles;
}

}  // namespace pcvt::testing
