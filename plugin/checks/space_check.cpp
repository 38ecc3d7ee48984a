#include "plugin/checks/space_check.hpp"

#include "io/bytes/bad_file.hpp"
#include "io/bytes/readable_number.hpp"
#include "io/formats/space_file_proof.hpp"
#include "io/gltf/space_gltf_proof.hpp"
#include "io/graphics/stl_proof.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/proof/box_proof.hpp"
#include "plugin/checks/tolerance_check.hpp"
#include "plugin/checks/volume_check.hpp"

namespace pcvt::checks {
namespace {

std::string cvt_text(const std::string& path, const SpaceFileProof& proof, double tolerance) {
    if (!proof.sites) throw UnusableFile(path + ": --cvt needs the sites, which the file lacks");
    const double found = proof.sites->from_centroid;
    if (!(found <= tolerance)) {
        throw NotATile("a site lies " + figure(found) + " h off the centroid of its cell, more " +
                       "than " + figure(tolerance) + " h");
    }
    return ", centroidal within " + figure(found) + " h (tolerance " + figure(tolerance) + " h)";
}

/// Requires that no property of cells is to be proved of a file without them.
void require_no_cells(const std::string& path, const Question& question, const char* found) {
    if (!question.cvt_tolerance && !question.volumes) return;
    throw UnusableFile(path + (question.cvt_tolerance ? ": --cvt" : ": --volumes") +
                       " needs cells, and the file holds " + found + "; check a .vtu");
}

/// Requires that no tolerance of positions is given for a file that does not need one.
void refuse_tolerance(const std::string& path, double tolerance, const char* found) {
    if (tolerance == 0) return;
    throw UnusableFile(path + ": --tolerance is for cells and tetrahedra, and the file holds " +
                       found + "; leave it out");
}

/// What a line says of a tile that is a box.
std::string box_text(const std::optional<space::Vec3>& corner) {
    if (!corner) return "";
    return ", a box at (" + figure(corner->x()) + ", " + figure(corner->y()) + ", " +
           figure(corner->z()) + ")";
}

/// Proves files by `prove`, which takes a tolerance.
/// @throws NotATile  also with the tolerance that would suffice.
template <class Prove>
auto proved_within(double tolerance, const Prove& prove) {
    try {
        return prove(tolerance);
    } catch (const SeamMismatch& fault) {
        throw NotATile(fault.what() + tolerance_advice(fault, [&](double wider) {
                           return prove(wider).proof.mismatch;
                       }));
    }
}

std::string prove_tetrahedral_tile(const std::vector<EncodedFile>& files, double tolerance) {
    const auto [tile, proof] = proved_within(
        tolerance, [&](double within) { return prove_tetrahedral_files(files, within); });
    const space::TetrahedralMesh& mesh = tile.mesh;
    const std::string of = mesh.cell.empty() ? " of " + counted(proof.n_sites, "site")
                                             : " in " + counted(mesh.cell.back() + 1, "cell") +
                                                   " on " + counted(proof.n_sites, "node");
    return std::to_string(mesh.n_tetrahedra()) + of + (mesh.order == 2 ? " of order 2, " : ", ") +
           std::to_string(2 * proof.pairs.size()) + " boundary triangles in " +
           std::to_string(proof.pairs.size()) + " pairs, periodic within " +
           in_words(proof.mismatch) + " (tolerance " + figure(proof.tolerance) +
           "), Euler characteristic 0 after gluing, volume " + figure(proof.volume) +
           box_text(box_corner(mesh, proof));
}

std::string prove_boundary(const std::vector<EncodedFile>& files) {
    const BoundaryFileProof found = prove_boundary_files(files);
    const space::SurfaceProof& proof = found.proof;
    const auto n_sites = static_cast<int>(found.surface.sites.cols());
    return counted(proof.n_points, "point") + ", " + std::to_string(proof.n_faces) + " faces in " +
           std::to_string(proof.n_faces / 2) + " pairs by " +
           counted(proof.n_translations, "translation") + ", a closed manifold in " +
           counted(proof.n_parts, "part") + ", Euler characteristic " +
           std::to_string(proof.euler) + ", volume " + figure(proof.volume) +
           (n_sites == 0 ? ", no sites stored"
                         : ", between " + counted(n_sites, "site") + " within " +
                               figure(proof.from_bisector) + " h");
}

std::string prove_triangles(const EncodedFile& file) {
    const GlbSurfaces glb = decode_glb_surfaces(file);
    const GlbProof proof = prove_glb_surfaces(file, glb);
    return std::to_string(proof.n_triangles) + " triangles in " + counted(proof.n_parts, "part") +
           (glb.list.form == SurfaceForm::kCells ? ", each closed" : ", which close together") +
           ", volume " + figure(proof.volume) + " (tolerance " + figure(proof.tolerance) + ")";
}

std::string prove_closed(const EncodedFile& file) {
    const StlProof proof = prove_stl(file);
    return std::to_string(proof.n_triangles) + " triangles in " +
           counted(proof.n_surfaces, "surface") + ", each closed and oriented outwards, volume " +
           figure(proof.volume) + (proof.has_periods ? ", that of the periods in its header" : "") +
           " (tolerance " + figure(proof.tolerance) + ")" +
           (proof.repeats ? ", translations by which map the boundary onto itself" : "") +
           "; not proved, because STL does not hold them: unit, cells";
}

std::string prove_cells(const std::string& path, const std::vector<EncodedFile>& files,
                        const Question& question) {
    const SpaceFileProof found = proved_within(
        question.tolerance, [&](double within) { return prove_space_files(files, within); });
    const space::PolyhedralProof& proof = found.proof;
    const space::PolyhedralMesh& mesh = found.tile.mesh;
    const bool is_cut = !mesh.piece_cell.empty();
    std::string line = (is_cut ? counted(proof.n_cells, "piece") + " of " : "") +
                       counted(mesh.n_sites(), "cell") + ", " + std::to_string(proof.n_faces) +
                       " faces, " + std::to_string(2 * proof.n_boundary_pairs) +
                       " boundary faces in " + std::to_string(proof.n_boundary_pairs) +
                       " pairs by " + counted(proof.n_translations, "translation") +
                       ", periodic within " + in_words(proof.mismatch) + " (tolerance " +
                       figure(proof.tolerance) + "), boundary " +
                       (proof.boundary_is_manifold ? "a manifold" : "touches itself") +
                       ", Euler characteristic 0 after gluing, volume " + figure(proof.volume) +
                       box_text(box_corner(mesh, proof.tolerance));
    if (found.tile.mesh.short_edges > 0) {
        line += ", edges under " + figure(found.tile.mesh.short_edges) + " h removed";
    }
    const bool has_weights = found.tile.weights.size() > 0;
    line += found.sites ? (has_weights ? ", power cells of " : ", Voronoi cells of ") +
                              counted(mesh.n_sites(), "site") + " within " +
                              figure(found.sites->from_bisector) + " h"
                        : ", no sites stored";
    if (question.cvt_tolerance) line += cvt_text(path, found, *question.cvt_tolerance);
    if (question.volumes) line += prove_cell_volumes(found, *question.volumes);
    return line;
}

/// The proof of files of one kind, without what they hold.
std::string prove_kind(SpaceFileKind kind, const std::string& path,
                       const std::vector<EncodedFile>& files, const Question& question) {
    switch (kind) {
        case SpaceFileKind::kTetrahedra:
            require_no_cells(path, question, "tetrahedra");
            return prove_tetrahedral_tile(files, question.tolerance);
        case SpaceFileKind::kBoundary:
            require_no_cells(path, question, "a boundary");
            refuse_tolerance(path, question.tolerance, "a boundary");
            return prove_boundary(files);
        case SpaceFileKind::kClosedSurfaces:
            require_no_cells(path, question, "closed surfaces");
            refuse_tolerance(path, question.tolerance, "closed surfaces");
            return prove_closed(files.front());
        case SpaceFileKind::kTriangles:
            require_no_cells(path, question, "triangles in single precision");
            refuse_tolerance(path, question.tolerance, "triangles in single precision");
            return prove_triangles(files.front());
        default:
            return prove_cells(path, files, question);
    }
}

}  // namespace

std::string space_content_text(SpaceFileKind kind) {
    switch (kind) {
        case SpaceFileKind::kTetrahedra:
            return "a periodic tile of tetrahedra";
        case SpaceFileKind::kBoundary:
            return "the boundary of a periodic tile of polyhedra";
        case SpaceFileKind::kClosedSurfaces:
            return "closed surfaces of triangles";
        case SpaceFileKind::kTriangles:
            return "surfaces of a periodic tile of polyhedra";
        default:
            return "a periodic tile of polyhedra";
    }
}

std::string prove_space_tile(const std::string& path, const std::vector<EncodedFile>& files,
                             const Question& question) {
    const SpaceFileKind kind = space_file_kind(files).value();
    return path + ": " + space_content_text(kind) + ": " + prove_kind(kind, path, files, question) +
           "\n";
}

}  // namespace pcvt::checks
