#include "plugin/cli/checks/space_check.hpp"

#include "io/bytes/bad_file.hpp"
#include "io/space/space_formats.hpp"
#include "mesher/proof/validate.hpp"
#include "plugin/cli/terminal/console.hpp"

namespace pcvt::cli {
namespace {

std::string cvt_text(const std::string& path, const SpaceFileProof& proof, double tolerance) {
    if (!proof.sites) throw BadFile(path + ": --cvt needs the sites, which the file lacks");
    const double found = proof.sites->from_centroid;
    if (!(found <= tolerance)) {
        throw NotATile("a site lies " + figure(found) + " h off the centroid of its cell, more " +
                       "than " + figure(tolerance) + " h");
    }
    return ", centroidal within " + figure(found) + " h (tolerance " + figure(tolerance) + " h)";
}

std::string prove_tetrahedral_tile(const std::string& path, const EncodedFile& file,
                                   bool asks_for_cvt) {
    if (asks_for_cvt) {
        throw BadFile(path + ": --cvt needs cells, and the file holds tetrahedra; check a .vtu");
    }
    const auto [mesh, proof] = prove_tetrahedral_file(file);
    return path + ": a periodic tile of tetrahedra: " + std::to_string(mesh.n_tetrahedra()) +
           " of " + counted(proof.n_sites, "site") + ", " + std::to_string(2 * proof.pairs.size()) +
           " boundary triangles in " + std::to_string(proof.pairs.size()) +
           " pairs, Euler characteristic 0 after gluing, volume " + figure(proof.volume) + "\n";
}

}  // namespace

std::string prove_space_tile(const std::string& path, const std::vector<EncodedFile>& files,
                             std::optional<double> cvt_tolerance) {
    if (hold_tetrahedra(files)) {
        return prove_tetrahedral_tile(path, files.front(), cvt_tolerance.has_value());
    }
    const SpaceFileProof found = prove_space_files(files);
    const PolyhedralProof& proof = found.proof;
    std::string line = path + ": a periodic tile of polyhedra: " + counted(proof.n_cells, "cell") +
                       ", " + std::to_string(proof.n_faces) + " faces, " +
                       std::to_string(2 * proof.n_boundary_pairs) + " boundary faces in " +
                       std::to_string(proof.n_boundary_pairs) + " pairs by " +
                       counted(proof.n_translations, "translation") + ", boundary " +
                       (proof.boundary_is_manifold ? "a manifold" : "touches itself") +
                       ", Euler characteristic 0 after gluing, volume " + figure(proof.volume);
    line += found.sites ? ", Voronoi cells of " + counted(proof.n_cells, "site") + " within " +
                              figure(found.sites->from_bisector) + " h"
                        : ", no sites stored";
    if (cvt_tolerance) line += cvt_text(path, found, *cvt_tolerance);
    return line + "\n";
}

}  // namespace pcvt::cli
