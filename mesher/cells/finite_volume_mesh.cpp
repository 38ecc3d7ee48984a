#include "mesher/cells/finite_volume_mesh.hpp"

#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {

int last_cell(const FiniteVolumeMesh& mesh) {
    int last = -1;
    for (const auto* cells : {&mesh.owner, &mesh.neighbour}) {
        for (const int cell : *cells) last = std::max(last, cell);
    }
    return last;
}

namespace {

void require_indices(const FiniteVolumeMesh& mesh, const char* law) {
    // Check the points of the faces.
    for (const int p : mesh.faces.corners) {
        if (p >= 0 && p < mesh.n_points()) continue;
        throw_violation(law, "a face names point " + std::to_string(p) + "; there are " +
                                 std::to_string(mesh.n_points()));
    }
    // Check the lengths of the lists.
    const int last = last_cell(mesh);
    if (last >= mesh.n_faces()) {
        throw_violation(law, "cell " + std::to_string(last) + " is named; there are only " +
                                 std::to_string(mesh.n_faces()) + " faces");
    }
    if (mesh.faces.n_faces() != mesh.n_faces()) {
        throw_violation(law, "there are " + std::to_string(mesh.faces.n_faces()) + " faces and " +
                                 std::to_string(mesh.n_faces()) + " owners");
    }
    if (mesh.n_inner_faces() > mesh.n_faces())
        throw_violation(law, "there are more neighbours than faces");
    // Check the cells at each face.
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        if (mesh.owner[f] >= 0 && (f >= mesh.n_inner_faces() || mesh.neighbour[f] >= 0)) continue;
        throw_violation(law, "face " + std::to_string(f) + " refers to a cell that does not exist");
    }
}

void require_runs(const FiniteVolumeMesh& mesh, const char* law) {
    int next = mesh.n_inner_faces();
    for (const FiniteVolumePatch& patch : mesh.patches) {
        if (patch.first_face != next || patch.n_faces < 0 ||
            patch.n_faces > mesh.n_faces() - next) {
            throw_violation(law, "patch " + patch.name + " begins with face " +
                                     std::to_string(patch.first_face) + ", not " +
                                     std::to_string(next) + ", or has faces that do not exist");
        }
        next += patch.n_faces;
    }
    if (next != mesh.n_faces()) {
        throw_violation(law, "the patches leave face " + std::to_string(next) + " out");
    }
}

void require_inner_order(const FiniteVolumeMesh& mesh, const char* law) {
    for (int f = 0; f < mesh.n_inner_faces(); ++f) {
        checkpoint_each(f);
        if (mesh.owner[f] >= mesh.neighbour[f]) {
            throw_violation(
                law, "the owner of face " + std::to_string(f) + " is not below its neighbour");
        }
        if (f == 0 || std::tie(mesh.owner[f - 1], mesh.neighbour[f - 1]) <=
                          std::tie(mesh.owner[f], mesh.neighbour[f])) {
            continue;
        }
        throw_violation(
            law, "face " + std::to_string(f) + " is out of order: sort by owner and neighbour");
    }
}

}  // namespace

void add_seam_patches(const std::vector<int>& offset, const Eigen::Vector3d& there,
                      const Eigen::Vector3d& back, int n_faces, FiniteVolumeMesh& mesh) {
    const int patch = static_cast<int>(mesh.patches.size());
    std::vector<int> reversed = offset;
    for (int& number : reversed) number = -number;
    mesh.patches.push_back({seam_name(std::span(offset)), PatchKind::kCyclic, mesh.n_faces(),
                            n_faces, patch + 1, offset, there});
    mesh.patches.push_back({seam_name(std::span(reversed)), PatchKind::kCyclic,
                            mesh.n_faces() + n_faces, n_faces, patch, reversed, back});
}

void require_face_order(const FiniteVolumeMesh& mesh, const char* law) {
    require_indices(mesh, law);
    require_runs(mesh, law);
    require_inner_order(mesh, law);
}

}  // namespace pcvt
