#include "io/gltf/gltf_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "io/forms/lattice_numbers.hpp"
#include "io/forms/material_words.hpp"
#include "io/gltf/gltf_attributes.hpp"
#include "io/gltf/gltf_document.hpp"
#include "io/gltf/gltf_layout.hpp"
#include "io/gltf/gltf_periodic.hpp"
#include "io/gltf/gltf_scene.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kCellPrefix = "cell_";
constexpr SiteId kMaxSite = 1 << 28;
/// The largest number of vertices, and of corners; far below the largest int.
constexpr std::size_t kMaxVertices = std::size_t{1} << 29;

/// The range of one accessor's vertices in the list of all vertices.
struct VertexRange {
    std::size_t first;
    std::size_t n;
};

/// The data collected so far by the walk over the nodes.
struct Finding {
    explicit Finding(const EncodedFile& file) : document(file) {}

    GltfDocument document;
    /// extras.periodic of the one node that has it.
    const Json* periodic = nullptr;
    /// That of the nodes with triangles.
    std::optional<plane::Vec2> translation = std::nullopt;
    std::vector<plane::Vec2> points;
    /// The vertices of each POSITION accessor, each read once.
    std::map<std::size_t, VertexRange> ranges;
    std::vector<int> corners;
    /// One site per face; -1 where the file names none.
    std::vector<SiteId> face_site;
    /// One site per point; -1 where the file names none.
    std::vector<SiteId> vertex_site;
    /// The material of each primitive; "" where the file names none.
    std::vector<MaterialRun> materials;

    const Json& periodic_member(const std::string& key) const {
        static const Json kNone;
        return GltfDocument::member(periodic ? *periodic : kNone, key);
    }
};

std::vector<SiteId> read_sites(const GltfDocument& document, std::size_t accessor,
                               std::size_t n_vertices) {
    const std::vector<float> numbers = document.floats(accessor, 1);
    if (numbers.size() != n_vertices)
        document.throw_bad_file("the number of ids is not that of vertices");
    std::vector<SiteId> sites;
    for (const float number : numbers) {
        if (number < 0 || number >= kMaxSite || number != std::floor(number)) {
            document.throw_bad_file(
                "an id in _CELL_ID or _SITE_ID is not a whole number from 0 on");
        }
        sites.push_back(static_cast<SiteId>(number));
    }
    return sites;
}

/// Returns the site in a node's name; -1 if there is none.
SiteId named_site(const Json& node) {
    const Json& name = GltfDocument::member(node, "name");
    if (!name.is_string()) return -1;
    const auto& text = name.text();
    if (!text.starts_with(kCellPrefix)) return -1;
    SiteId site = -1;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data() + kCellPrefix.size(), end, site);
    return fault == std::errc() && stop == end && site >= 0 && site < kMaxSite ? site : -1;
}

VertexRange add_points(std::size_t accessor, Finding& finding) {
    const auto known = finding.ranges.find(accessor);
    if (known != finding.ranges.end()) return known->second;
    const std::vector<float> numbers = finding.document.floats(accessor, 3);
    const VertexRange range{finding.points.size(), numbers.size() / 3};
    for (std::size_t k = 0; k < numbers.size(); k += 3) {
        finding.points.emplace_back(numbers[k], numbers[k + 1]);
    }
    if (finding.points.size() > kMaxVertices) finding.document.throw_bad_file("too many vertices");
    finding.vertex_site.resize(finding.points.size(), -1);
    finding.ranges.emplace(accessor, range);
    return range;
}

std::vector<int> primitive_corners(const GltfDocument& document, const Json& primitive,
                                   std::size_t n_vertices) {
    std::vector<int> corners;
    if (primitive.contains("indices")) {
        corners = document.indices(document.count_in(primitive, "indices"), n_vertices);
    } else {
        for (std::size_t k = 0; k < n_vertices; ++k) corners.push_back(static_cast<int>(k));
    }
    if (corners.size() % 3 != 0) document.throw_bad_file("a primitive ends within a triangle");
    return corners;
}

void add_faces(const std::vector<int>& corners, const std::vector<SiteId>& cells, SiteId otherwise,
               Finding& finding) {
    for (std::size_t k = 0; k < corners.size(); k += 3) {
        const SiteId site = cells.empty() ? otherwise : cells[corners[k]];
        for (std::size_t l = k; l < k + 3 && !cells.empty(); ++l) {
            if (cells[corners[l]] == site) continue;
            finding.document.throw_bad_file("a triangle has corners of two cells in _CELL_ID");
        }
        finding.face_site.push_back(site);
    }
}

void add_triangles(const Json& node, const Json& primitive, Finding& finding) {
    const GltfDocument& document = finding.document;
    const Json& attributes = GltfDocument::member(primitive, "attributes");
    const VertexRange range = add_points(document.count_in(attributes, "POSITION"), finding);
    const std::vector<int> corners = primitive_corners(document, primitive, range.n);
    std::vector<SiteId> cells;
    if (attributes.contains("_CELL_ID")) {
        cells = read_sites(document, document.count_in(attributes, "_CELL_ID"), range.n);
    }
    if (attributes.contains("_SITE_ID")) {
        const auto sites = read_sites(document, document.count_in(attributes, "_SITE_ID"), range.n);
        std::copy(sites.begin(), sites.end(),
                  finding.vertex_site.begin() + std::ptrdiff_t(range.first));
    }
    const auto first_face = static_cast<int>(finding.face_site.size());
    add_faces(corners, cells, named_site(node), finding);
    finding.materials.push_back({document.material_name(primitive), first_face});
    for (const int corner : corners)
        finding.corners.push_back(static_cast<int>(range.first) + corner);
    if (finding.corners.size() > kMaxVertices) document.throw_bad_file("too many triangles");
}

/// Notes the translation of a node with triangles, which is the same for all of them.
void take_translation(const plane::Vec2& translation, Finding& finding) {
    if (finding.translation.value_or(translation) != translation) {
        finding.document.throw_bad_file(
            "two nodes have different translations; apply them before exporting");
    }
    finding.translation = translation;
}

void add_mesh(const Json& node, const plane::Vec2& translation, Finding& finding) {
    const GltfDocument& document = finding.document;
    const Json& mesh = document.entry("meshes", document.count_in(node, "mesh"));
    const Json& primitives = GltfDocument::member(mesh, "primitives");
    if (!primitives.is_array()) document.throw_bad_file("a mesh has no list of primitives");
    for (const Json& primitive : primitives) {
        const std::size_t mode = document.count_in(primitive, "mode", kGltfTriangles);
        if (mode == kGltfTriangles) {
            take_translation(translation, finding);
            add_triangles(node, primitive, finding);
        }
        if (mode > kGltfTriangles)
            document.throw_bad_file("triangle strips and fans; export triangles");
    }
}

/// Notes extras.periodic of a node and adds its triangles.
void visit(const SceneNode& placed, Finding& finding) {
    const Json& extras = GltfDocument::member(*placed.node, "extras");
    if (extras.contains("periodic")) {
        if (finding.periodic)
            finding.document.throw_bad_file("two nodes have extras.periodic; keep one");
        finding.periodic = &GltfDocument::member(extras, "periodic");
    }
    if (placed.node->contains("mesh")) add_mesh(*placed.node, placed.translation, finding);
}

plane::Lattice read_lattice(const GltfDocument& document, const Json& rows) {
    const std::vector<double> numbers = document.vector_list(rows, 2);
    if (numbers.size() != 4) {
        document.throw_bad_file("extras.periodic.lattice is not [[ax, ay], [bx, by]]");
    }
    try {
        return lattice_from<plane::Lattice>(numbers);
    } catch (const InvalidInput& fault) {
        document.throw_bad_file(std::string("extras.periodic.lattice: ") + fault.what());
    }
}

plane::Lattice find_lattice(const Finding& finding, const std::optional<plane::Lattice>& given) {
    const Json& rows = finding.periodic_member("lattice");
    if (!rows.is_null()) return read_lattice(finding.document, rows);
    if (!given)
        finding.document.throw_unusable(
            "has no lattice in extras.periodic; pass --lattice AX,AY,BX,BY");
    return *given;
}

int pair_entry(const GltfDocument& document, const Json& number, int least, int most) {
    const bool small = number.is_number_integer() &&
                       (!number.is_number_unsigned() || number.get<std::uint64_t>() <= INT64_MAX);
    const std::int64_t value = small ? number.get<std::int64_t>() : INT64_MAX;
    if (value < least || value > most) {
        document.throw_bad_file("an entry of extras.periodic.vertexPairs is out of range");
    }
    return static_cast<int>(value);
}

std::vector<plane::VertexPair> read_pairs(const Finding& finding, const Json& rows) {
    const GltfDocument& document = finding.document;
    constexpr int kMost = std::numeric_limits<int>::max();
    if (finding.ranges.size() != 1) {
        document.throw_bad_file("vertexPairs need one POSITION accessor for all triangles");
    }
    if (!rows.is_array()) document.throw_bad_file("extras.periodic.vertexPairs is not a list");
    const int last = static_cast<int>(finding.points.size()) - 1;
    std::vector<plane::VertexPair> pairs;
    for (const Json& row : rows) {
        checkpoint();
        if (!row.is_array() || row.size() != 4) {
            document.throw_bad_file("an entry of extras.periodic.vertexPairs is not [v, w, i, j]");
        }
        pairs.push_back({pair_entry(document, row[0], 0, last),
                         pair_entry(document, row[1], 0, last),
                         {pair_entry(document, row[2], -kMost, kMost),
                          pair_entry(document, row[3], -kMost, kMost)}});
    }
    return pairs;
}

/// Reads vertexCopies: the last vertices are copies of these earlier vertices.
std::vector<int> read_copies(const Finding& finding, const Json& copies) {
    const GltfDocument& document = finding.document;
    if (!copies.is_array() || finding.ranges.size() != 1 || copies.size() > finding.points.size()) {
        document.throw_bad_file("extras.periodic.vertexCopies is not a list of vertices");
    }
    const std::size_t n_first = finding.points.size() - copies.size();
    std::vector<int> originals;
    originals.reserve(copies.size());
    for (const Json& copy : copies) {
        const std::size_t v = document.count(copy, "vertexCopies");
        const std::size_t own = n_first + originals.size();
        if (v >= n_first || finding.points[v] != finding.points[own]) {
            document.throw_bad_file("vertex " + std::to_string(own) +
                                    " is not a copy of the vertex that vertexCopies names");
        }
        originals.push_back(static_cast<int>(v));
    }
    return originals;
}

/// Reads cellTriangles: the sites of consecutive triangles.
void read_cells(const Json& rows, Finding& finding) {
    const GltfDocument& document = finding.document;
    if (!rows.is_array()) document.throw_bad_file("extras.periodic.cellTriangles is not a list");
    std::size_t at = 0;
    for (const Json& row : rows) {
        checkpoint();
        if (!row.is_array() || row.size() != 2) {
            document.throw_bad_file("an entry of extras.periodic.cellTriangles is not [site, n]");
        }
        const std::size_t site = document.count(row[0], "cellTriangles");
        const std::size_t n = document.count(row[1], "cellTriangles");
        if (site >= std::size_t{kMaxSite} || n > finding.face_site.size() - at) {
            document.throw_bad_file("an entry of extras.periodic.cellTriangles is out of range");
        }
        std::fill_n(finding.face_site.begin() + std::ptrdiff_t(at), n, static_cast<SiteId>(site));
        at += n;
    }
    if (at == finding.face_site.size()) return;
    document.throw_bad_file("extras.periodic.cellTriangles does not count all triangles");
}

plane::MeshKind tile_kind(const Finding& finding) {
    const auto unknown = std::count(finding.face_site.begin(), finding.face_site.end(), -1);
    const Json& kind = finding.periodic_member("kind");
    const bool grains =
        kind.is_string() && plane::mesh_kind_of_file_word(kind.text()) == plane::MeshKind::kGrains;
    if (!kind.is_null() && !grains) {
        finding.document.throw_bad_file("extras.periodic.kind is not \"grains\"");
    }
    if (unknown == 0) return grains ? plane::MeshKind::kGrains : plane::MeshKind::kVoronoi;
    if (unknown < std::ssize(finding.face_site)) {
        finding.document.throw_bad_file(
            "some triangles belong to a cell and some do not; keep the tile only");
    }
    return plane::MeshKind::kDelaunay;
}

/// The translation in a file of pcvt is that of whole periods.
void require_whole_periods(const GltfDocument& document, const plane::Lattice& lattice,
                           const plane::Vec2& translation) {
    const plane::Vec2 periods = lattice.to_lattice(translation).array().round().matrix();
    if (translation == lattice.to_position(periods)) return;
    document.throw_bad_file(
        "the translation of its node is not a sum of whole periods; write the file again with "
        "pcvt");
}

bool all_known(const std::vector<SiteId>& sites) {
    return std::find(sites.begin(), sites.end(), -1) == sites.end();
}

}  // namespace

TileFile decode_gltf(const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice) {
    Finding finding(files.at(0));
    for (const SceneNode& node : scene_nodes(finding.document)) visit(node, finding);
    if (finding.corners.empty()) {
        finding.document.throw_bad_file("there are no triangles in its scene");
    }
    const Json& cells = finding.periodic_member("cellTriangles");
    if (!cells.is_null()) read_cells(cells, finding);
    plane::Tile tile{.lattice = find_lattice(finding, lattice), .kind = tile_kind(finding)};
    const Json& pairs = finding.periodic_member("vertexPairs");
    if (!pairs.is_null()) tile.vertex_pairs = read_pairs(finding, pairs);
    const Json& copies = finding.periodic_member("vertexCopies");
    if (!copies.is_null()) tile.copies = read_copies(finding, copies);
    for (int k = 3; k <= std::ssize(finding.corners); k += 3) tile.faces.begin.push_back(k);
    tile.points = std::move(finding.points);
    tile.faces.corners = std::move(finding.corners);
    if (faces_have_sites(tile.kind)) {
        tile.face_site = std::move(finding.face_site);
    } else if (all_known(finding.vertex_site)) {
        tile.vertex_site = std::move(finding.vertex_site);
    }
    if (finding.periodic) read_site_notes(finding.document, *finding.periodic, tile);
    if (is_own_gltf(finding.document)) {
        require_own_layout(finding.document);
        require_whole_periods(finding.document, tile.lattice, finding.translation.value());
        require_own_attributes(finding.document, tile);
    }
    TileFile file{std::move(tile), plane::Precision::kSingle, !pairs.is_null(), false};
    file.translation = finding.translation.value();
    file.shown = shown_phases(file.tile, finding.materials);
    return file;
}

}  // namespace pcvt
