#pragma once

namespace pcvt::cli {

/// The examples in the help of `pcvt mesh`:
///
///   app.footer(kMeshExamples);
inline constexpr const char* kMeshExamples =
    "Examples:\n"
    "  pcvt mesh --sites 300 -o tile.obj\n"
    "      300 random sites on the unit square, optimised; tile.obj, tile.mtl, tile.seam.json\n"
    "  pcvt mesh --sites 300 --seed 7 --lattice 1,0,0.37,0.81 -o tile.glb -o tile.svg\n"
    "      an oblique lattice; a picture beside the mesh\n"
    "  pcvt mesh --input sites.txt --period 2,1 --mesh voronoi --mesh delaunay -o tile.ply\n"
    "      your own sites; writes tile-voronoi.ply and tile-delaunay.ply\n"
    "  pcvt mesh --input sites.txt --max-iterations 0 -o tile.obj\n"
    "      the periodic Voronoi diagram of the sites as given\n"
    "  pcvt mesh --sites 30 --repeat 2x3 --strict --report run.json -o tile.om -o sites.txt\n"
    "      a tile of 2 x 3 domains; exit code 5 if the tolerance was not reached\n"
    "  pcvt mesh --sites 2000 --density '1 + 99 * exp(-((v - 0.5) / 0.1)^2)' -o ridge.svg\n"
    "      a graded mesh, fine along the line v = 0.5\n"
    "  pcvt mesh --sites 1000 --areas lognormal:0.42 --max-iterations 5 --cells grains.csv\n"
    "      the table of a polycrystal with a law of grain sizes; add -o for meshes and pictures\n"
    "  pcvt mesh --sites 200 --mesh grains --phases soft:0.7,hard:0.3 --job elastic \\\n"
    "      --material soft:70000,0.33 --material hard:210000,0.3 -o job.inp\n"
    "      a periodic element of two phases; `ccx job` computes its stiffness\n"
    "  pcvt mesh --sites 1000 --period 1,1,1 -o tile.vtu -o tile.foam -o tile.glb\n"
    "      three dimensions: polyhedra that repeat along three periods\n";

}  // namespace pcvt::cli
