#include "io/space/space_foam_reader.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_fields.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_scanner.hpp"
#include "io/space/space_foam_writer.hpp"
#include "io/tiles/tile_file.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"
#include "mesher/space/mesh/short_edges.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kBoundary = "constant/polyMesh/boundary";

/// Returns (I, J, K) of the name seam_I_J_K; `nullopt` for any other name.
std::optional<space::Offset> named_offset(std::string_view name) {
    constexpr std::string_view kHead = "seam";
    if (!name.starts_with(kHead)) return std::nullopt;
    name.remove_prefix(kHead.size());
    std::vector<int> numbers;
    while (!name.empty() && name.front() == '_') {
        name.remove_prefix(1);
        const std::string_view word = name.substr(0, name.find('_'));
        try {
            numbers.push_back(parse_integer(word));
        } catch (const InvalidInput&) {
            return std::nullopt;
        }
        name.remove_prefix(word.size());
    }
    const bool fits = std::all_of(numbers.begin(), numbers.end(), [](int number) {
        return -kLargestOffset <= number && number <= kLargestOffset;
    });
    if (!name.empty() || numbers.size() != 3 || !fits) return std::nullopt;
    return space::Offset{numbers[0], numbers[1], numbers[2]};
}

/// Reads a patch and the name of its partner.
std::pair<space::PolyhedralPatch, std::string> read_patch(FoamScanner& scanner) {
    const std::string name(scanner.next());
    space::PolyhedralPatch patch{.first_face = -1, .n_faces = -1, .partner = -1, .offset = {}};
    std::string type;
    std::string partner;
    scanner.expect("{");
    for (std::string_view key = scanner.next(); key != "}"; key = scanner.next()) {
        if (key.empty()) scanner.throw_bad_file("a patch does not end; give the whole file");
        if (key == "type") type = scanner.next();
        if (key == "neighbourPatch") partner = scanner.next();
        if (key == "nFaces") patch.n_faces = scanner.integer();
        if (key == "startFace") patch.first_face = scanner.integer();
        scanner.skip_entry();
    }
    const std::optional<space::Offset> offset = named_offset(name);
    if (type != "cyclic" || !offset) {
        scanner.throw_bad_file("patch " + in_quotes(name) +
                               " is not one side of a seam; name it seam_I_J_K, with the type "
                               "cyclic and a neighbourPatch");
    }
    patch.offset = *offset;
    return {patch, partner};
}

void read_patches(const EncodedFile& file, space::PolyhedralMesh& mesh) {
    FoamScanner scanner(file.path, file.bytes);
    std::vector<std::string> partners;
    std::map<std::string, int> index;
    for (int left = scanner.begin_list(); left > 0; --left) {
        auto [patch, partner] = read_patch(scanner);
        const int p = static_cast<int>(mesh.patches.size());
        if (!index.emplace(seam_name(patch.offset), p).second) {
            scanner.throw_bad_file("two patches have one name; rename one");
        }
        mesh.patches.push_back(patch);
        partners.push_back(std::move(partner));
    }
    scanner.expect(")");
    int next = mesh.n_inner_faces();
    for (std::size_t p = 0; p < partners.size(); ++p) {
        space::PolyhedralPatch& patch = mesh.patches[p];
        const auto found = index.find(partners[p]);
        if (found == index.end()) {
            scanner.throw_bad_file("there is no patch " + in_quotes(partners[p]) +
                                   "; name an existing one");
        }
        patch.partner = found->second;
        if (patch.first_face != next || patch.n_faces < 0 ||
            patch.n_faces > mesh.n_faces() - next) {
            scanner.throw_bad_file(
                "the patches are not one run of the boundary faces each, in "
                "their order; correct startFace and nFaces");
        }
        next += patch.n_faces;
    }
    if (next != mesh.n_faces()) scanner.throw_bad_file("the last faces lie in no patch; add one");
}

/// The numbers behind `// pcvt WORD` of each such comment.
std::vector<double> comment_numbers(const EncodedFile& file, std::string_view word,
                                    std::size_t in_line) {
    std::vector<double> numbers;
    LineScanner scanner(file.path, file.bytes);
    while (scanner.next()) {
        const auto& words = scanner.words();
        if (words.size() < 3 || words[0] != "//" || words[1] != "pcvt" || words[2] != word) {
            continue;
        }
        if (words.size() != 3 + in_line) {
            scanner.throw_bad_file("the comment has not " + std::to_string(in_line) +
                                   " numbers; write the file again with pcvt");
        }
        for (std::size_t k = 3; k < words.size(); ++k) numbers.push_back(scanner.number(words[k]));
    }
    return numbers;
}

space::Lattice read_lattice(const EncodedFile& boundary) {
    const std::vector<double> numbers = comment_numbers(boundary, "lattice", 9);
    if (numbers.size() != 9) {
        throw BadFile(boundary.path + ": names not one lattice; write the case again with pcvt");
    }
    const Eigen::Map<const Eigen::Matrix3d> periods(numbers.data());
    try {
        return {periods.col(0), periods.col(1), periods.col(2)};
    } catch (const InvalidInput& fault) {
        throw BadFile(boundary.path + ": " + fault.what());
    }
}

/// PolyhedralMesh::short_edges, which a case without removed edges does not state.
double read_foam_short_edges(const EncodedFile& boundary) {
    const std::vector<double> numbers = comment_numbers(boundary, "short_edges", 1);
    if (numbers.empty()) return 0;
    if (numbers.size() > 1 || !(numbers[0] >= 0 && numbers[0] <= space::kLongestShortEdge)) {
        throw BadFile(boundary.path + ": " + kShortEdgesRange);
    }
    return numbers[0];
}

/// Refuses numbers of points and cells that do not exist.
void require_numbers(const std::vector<EncodedFile>& files, space::PolyhedralMesh& mesh) {
    const auto refuse = [&files](const char* name, const char* complaint) {
        throw BadFile(foam_mesh_file(files, name).path + ": " + complaint +
                      "; write the case again with pcvt");
    };
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        if (mesh.faces.size(f) < 3) refuse("faces", "a face has not three points");
        for (const int v : mesh.faces[f]) {
            if (v < 0 || v >= mesh.n_points()) refuse("faces", "a face has an unknown point");
        }
    }
    if (mesh.n_faces() != mesh.faces.n_faces()) refuse("owner", "not each face has an owner");
    if (mesh.n_inner_faces() > mesh.n_faces()) refuse("neighbour", "there are too many faces");
    int most = -1;
    for (const auto* cells : {&mesh.owner, &mesh.neighbour}) {
        for (const int cell : *cells) {
            if (cell < 0 || cell >= mesh.n_faces()) refuse("owner", "a cell has too few faces");
            most = std::max(most, cell);
        }
    }
    if (most < 0) refuse("owner", "there is no cell");
    mesh.n_cells = most + 1;
}

}  // namespace

bool is_space_case(const std::vector<EncodedFile>& files) {
    const auto boundary = std::find_if(files.begin(), files.end(), [](const EncodedFile& file) {
        return file.path.ends_with(kBoundary);
    });
    return boundary != files.end() && boundary->bytes.find(kSpaceKind) != std::string::npos;
}

SpaceTile decode_space_foam(const std::vector<EncodedFile>& files, double tolerance) {
    for (const EncodedFile& file : files) {
        refuse_binary(file.path, file.bytes, "write the case with writeFormat ascii");
    }
    const EncodedFile& boundary = foam_mesh_file(files, "boundary");
    SpaceTile tile{.mesh = {.lattice = read_lattice(boundary)}};
    space::PolyhedralMesh& mesh = tile.mesh;
    mesh.short_edges = read_foam_short_edges(boundary);
    mesh.points = foam_points(foam_mesh_file(files, "points"));
    mesh.faces = foam_faces(foam_mesh_file(files, "faces"));
    mesh.owner = foam_labels(foam_mesh_file(files, "owner"));
    mesh.neighbour = foam_labels(foam_mesh_file(files, "neighbour"));
    require_numbers(files, mesh);
    read_patches(boundary, mesh);
    space::PolyhedralMesh joined = assembled_mesh(mesh.lattice, polyhedron_list(mesh), tolerance);
    mesh.point_orbit = std::move(joined.point_orbit);
    mesh.point_offset = std::move(joined.point_offset);
    const std::vector<double> sites = comment_numbers(boundary, "site", 3);
    tile.sites = Eigen::Map<const space::Points>(sites.data(), 3,
                                                 static_cast<Eigen::Index>(sites.size() / 3));
    return tile;
}

void compare_space_case(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    for (const EncodedFile& expected : encode_space_foam(tile, "")) {
        const auto found = std::find_if(files.begin(), files.end(), [&](const EncodedFile& file) {
            return file.path.ends_with(expected.path);
        });
        if (found == files.end() || found->bytes == expected.bytes) continue;
        const std::optional<FileFields> fields = foam_fields(found->path, found->bytes);
        if (fields) compare_fields(*fields, *foam_fields(expected.path, expected.bytes));
    }
}

}  // namespace pcvt
