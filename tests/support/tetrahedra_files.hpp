#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/formats/space_file_proof.hpp"
#include "mesher/space/grains/grains.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::testing {

/// A name for messages and a tile of tetrahedra.
using NamedTetrahedra = std::pair<std::string, space::TetrahedralMesh>;

inline space::TetrahedralMesh tetrahedra_of(const SpaceCase& c) {
    return tetrahedral_mesh(space::periodic_delaunay(space::Sites(c.lattice, c.points)));
}

/// The cases without flat tetrahedra.
inline std::vector<NamedTetrahedra> tetrahedra_cases() {
    std::vector<NamedTetrahedra> meshes;
    for (const SpaceCase& c : space_cases()) {
        space::TetrahedralMesh mesh = tetrahedra_of(c);
        if (!flat_tetrahedra(mesh, static_cast<int>(c.points.cols())).empty()) continue;
        meshes.emplace_back(c.name, std::move(mesh));
    }
    return meshes;
}

inline space::TetrahedralMesh random_tetrahedra(int n) {
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    return tetrahedra_of({"random", oblique, uniform_points(oblique, n, 3)});
}

/// Tetrahedra inside of n random cells.
inline space::TetrahedralMesh grain_tetrahedra(int n) {
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    const SpaceCase c{"random", oblique, uniform_points(oblique, n, 3)};
    const space::Sites sites(oblique, c.points);
    Workers one_worker(1);
    return mesh_grains(sites, complex_of(c), {.size = 0.7 * sites.spacing(), .n_rounds = 0},
                       one_worker)
        .mesh.tetrahedra;
}

/// The message of the proof of a file of tetrahedra; empty if it accepts the file.
inline std::string fault_of_tetrahedra(const EncodedFile& file) {
    try {
        prove_tetrahedral_files({file});
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

}  // namespace pcvt::testing
