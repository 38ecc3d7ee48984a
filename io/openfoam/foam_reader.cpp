#include "io/openfoam/foam_reader.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/lattice_numbers.hpp"
#include "io/openfoam/foam_case.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_scanner.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

Eigen::Vector3d read_separation(FoamScanner& scanner, int n_periods) {
    Eigen::Vector3d separation;
    scanner.expect("(");
    for (int k = 0; k < 3; ++k) {
        separation[k] = scanner.number();
        if (k < n_periods || separation[k] == 0) continue;
        scanner.throw_bad_file("a separation leaves the plane; make z 0");
    }
    scanner.expect(")");
    return separation;
}

/// Reads a patch and the name of its partner, which is empty if the patch has none.
std::pair<FiniteVolumePatch, std::string> read_patch(FoamScanner& scanner, int n_periods) {
    FiniteVolumePatch patch{.name = std::string(scanner.next()),
                            .kind = PatchKind::kCyclic,
                            .first_face = -1,
                            .n_faces = -1};
    std::string type;
    std::string partner;
    // Read the entries that matter, skip the others.
    scanner.expect("{");
    for (std::string_view key = scanner.next(); key != "}"; key = scanner.next()) {
        if (key.empty()) scanner.throw_bad_file("a patch does not end; give the whole file");
        if (key == "type") type = scanner.next();
        if (key == "neighbourPatch") partner = scanner.next();
        if (key == "nFaces") patch.n_faces = scanner.integer();
        if (key == "startFace") patch.first_face = scanner.integer();
        if (key == "separationVector") patch.separation = read_separation(scanner, n_periods);
        scanner.skip_entry();
    }
    // A patch is a wall, empty, or cyclic with an offset in its name.
    if (type == "wall") patch.kind = PatchKind::kWall;
    if (type == "empty" && find_wall_side(patch.name) == nullptr) patch.kind = PatchKind::kEmpty;
    if (partner.empty() && patch.kind != PatchKind::kCyclic) return {patch, partner};
    patch.offset = offset_in_name(patch.name);
    if (type != "cyclic" || partner.empty() ||
        patch.offset.size() != static_cast<std::size_t>(n_periods)) {
        scanner.throw_bad_file("patch " + in_quotes(patch.name) +
                               " is neither an empty one, a wall nor one side of a seam; name the "
                               "cyclic ones " +
                               foam_seam_form(n_periods) +
                               ", and give each of these a neighbourPatch");
    }
    return {patch, partner};
}

/// Reads the patches. They have the faces behind the inner ones, one patch after the other.
std::vector<FiniteVolumePatch> read_patches(const EncodedFile& file, int n_periods,
                                            const FiniteVolumeMesh& mesh) {
    FoamScanner scanner(file.path, file.bytes);
    std::vector<FiniteVolumePatch> patches;
    int next_face = mesh.n_inner_faces();
    std::vector<std::string> partners;
    std::map<std::string, int> index;
    for (int left = scanner.begin_list(); left > 0; --left) {
        auto [patch, partner] = read_patch(scanner, n_periods);
        if (!index.emplace(patch.name, static_cast<int>(patches.size())).second) {
            scanner.throw_bad_file("two patches have one name; rename one");
        }
        if (patch.first_face != next_face || patch.n_faces < 0 ||
            patch.n_faces > mesh.n_faces() - next_face) {
            scanner.throw_bad_file("patch " + in_quotes(patch.name) + " has not its faces from " +
                                   std::to_string(next_face) + " on; correct startFace and nFaces");
        }
        next_face += patch.n_faces;
        patches.push_back(std::move(patch));
        partners.push_back(std::move(partner));
    }
    scanner.expect(")");
    if (next_face != mesh.n_faces()) {
        scanner.throw_bad_file("no patch has face " + std::to_string(next_face) +
                               "; correct startFace and nFaces");
    }
    // Find the partners by their names.
    for (std::size_t p = 0; p < partners.size(); ++p) {
        if (partners[p].empty()) continue;
        const auto found = index.find(partners[p]);
        if (found == index.end()) {
            scanner.throw_bad_file("there is no patch " + in_quotes(partners[p]) +
                                   "; name an existing one");
        }
        patches[p].partner = found->second;
    }
    return patches;
}

}  // namespace

FiniteVolumeMesh decode_foam_mesh(const std::vector<EncodedFile>& files, int n_periods) {
    FiniteVolumeMesh mesh;
    mesh.points = foam_points(foam_mesh_file(files, "points"));
    mesh.faces = foam_faces(foam_mesh_file(files, "faces"));
    mesh.owner = foam_labels(foam_mesh_file(files, "owner"));
    mesh.neighbour = foam_labels(foam_mesh_file(files, "neighbour"));
    mesh.patches = read_patches(foam_mesh_file(files, "boundary"), n_periods, mesh);
    return mesh;
}

}  // namespace pcvt
