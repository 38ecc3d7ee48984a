#include "io/solvers/inp_writer.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/finite.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/seam_segments.hpp"
#include "io/forms/site_notes.hpp"
#include "io/forms/site_orbits.hpp"
#include "io/forms/solver_nodes.hpp"
#include "io/forms/triangle_cells.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/solvers/fixed_width_numbers.hpp"
#include "io/solvers/inp_fields.hpp"
#include "io/solvers/inp_sections.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kIdsALine = 8;
constexpr std::size_t kSitesALine = 16;

/// The explanation begins with one of these.
constexpr const char* kMeshAlone =
    "** The mesh of a periodic tile, written by pcvt: *INCLUDE it in a job that adds a material,\n"
    "** a *SOLID SECTION for EALL or each CELL_s, and steps.";
constexpr const char* kWithSections =
    "** The mesh of a periodic tile with a section for each cell, written by pcvt: *INCLUDE it in\n"
    "** a job that adds the materials of these sections, and steps.";
constexpr const char* kWithJob =
    "** A job of linear elasticity on a periodic tile, written by pcvt, that CalculiX runs as it\n"
    "** is; its materials and steps are at the end.";
constexpr const char* kPeriodicTile = "a periodic tile";
constexpr const char* kBetweenWalls = "a tile between walls";
/// Explains the sets of a tile between walls.
constexpr const char* kWallSets =
    "** WALL_LEFT and so on are the nodes of a wall, but for tied ones; WALL_LEFT_SIDES the sides "
    "of\n"
    "** elements there.\n";
/// Explains a box, which has no equations.
constexpr const char* kBoxExplanation =
    " No node is tied to another.\n"
    "** Lines that begin with \"** pcvt\" hold what no card does.\n";
constexpr const char* kExplanation =
    " FIXED 1,2 holds the tile. The mean\n** strain is the displacement of the control nodes: "
    "CONTROL_1 has e_xx, e_xy in 1, 2, and\n"
    "** CONTROL_2 has e_yy in 2. Lines that begin with \"** pcvt\" hold what no card does.\n";

/// Returns the largest absolute value of a coordinate or of a component of a translation.
double largest_number(const plane::Tile& tile) {
    double largest = 0;
    for (const plane::Vec2& p : tile.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        const plane::Vec2 translation = tile.lattice.translation(pair.offset);
        largest = std::max(largest, translation.cwiseAbs().maxCoeff());
    }
    return largest;
}

/// Builds the text of one file, card by card.
class InpText {
   public:
    InpText(const plane::Tile& tile, const FileOptions& options, std::string path)
        : tile_(tile),
          options_(options),
          cells_(tile),
          nodes_(solver_nodes(tile)),
          path_(std::move(path)),
          numbers_(largest_number(tile)) {}

    std::string write() {
        append_comments();
        append_nodes();
        append_elements();
        append_cells();
        text_ += inp_orbit_sets(options_.site_orbits, cell_sets_);
        append_node_sets();
        append_wall_sides();
        append_equations();
        if (options_.materials != nullptr) text_ += inp_sections(*options_.materials, cell_sets_);
        if (options_.job == SolverJob::kElastic)
            text_ += inp_elastic_job(materials(), options_.elastic, tile_.lattice.area());
        return std::move(text_);
    }

   private:
    CellMaterials materials() const {
        return options_.materials != nullptr ? *options_.materials : CellMaterials{};
    }
    int control(int k) const { return nodes_.n_nodes() + k; }

    /// Whether walls leave no seam, so that no node is tied.
    bool is_box() const { return tile_.walls == Walls::kXY; }

    void append_real(double value) {
        if (numbers_.append(text_, value)) return;
        throw InvalidInput(
            path_ +
            ": solvers read 20 characters of a number there, too few for this tile; "
            "choose a unit of length in which its coordinates lie between 0.1 and 1e6");
    }

    void append_comments() {
        const plane::Vec2& a = tile_.lattice.a();
        const plane::Vec2& b = tile_.lattice.b();
        text_ = options_.job != SolverJob::kNone ? kWithJob
                : options_.materials != nullptr  ? kWithSections
                                                 : kMeshAlone;
        if (tile_.walls != Walls::kNone) {
            const std::string_view what(kPeriodicTile);
            text_.replace(text_.find(what), what.size(), kBetweenWalls);
        }
        text_ += is_box() ? kBoxExplanation : kExplanation;
        if (tile_.walls != Walls::kNone) text_ += kWallSets;
        text_ += "** pcvt kind " + file_word(tile_.kind) + "\n** pcvt lattice";
        for (const double number : {a.x(), a.y(), b.x(), b.y()}) {
            text_ += ' ';
            append_number(text_, number);
        }
        text_ += '\n';
        append_note_comments(text_, "** pcvt ", tile_, 1);
        for (std::size_t k = 0; k < tile_.vertex_site.size(); ++k) {
            text_ += k % kSitesALine != 0 ? " " : k == 0 ? "** pcvt sites " : "\n** pcvt sites ";
            append_number(text_, tile_.vertex_site[k]);
        }
        if (!tile_.vertex_site.empty()) text_ += '\n';
        append_materials(text_, "** pcvt ", materials());
        append_site_orbits(text_, "** pcvt ", options_.site_orbits);
    }

    void append_node(int number, const plane::Vec2& p) {
        append_number(text_, number);
        text_ += ',';
        append_real(p.x());
        text_ += ',';
        append_real(p.y());
        text_ += ",0\n";
    }

    void append_nodes() {
        text_ += "*NODE,NSET=" + upper_case(kAllNodesSet) + "\n";
        for (int v = 0; v < nodes_.n_nodes(); ++v) append_node(v + 1, nodes_.points[v]);
        if (is_box()) return;
        for (const int k : {1, 2}) {
            text_ += "*NODE,NSET=" + upper_case(kControlSet) + std::to_string(k) + "\n";
            append_node(control(k), tile_.points[0]);
        }
    }

    void append_elements() {
        text_ += std::string("*ELEMENT,TYPE=") + find_row(kPlaneElements, [this](const auto& row) {
                                                     return row.element == options_.element;
                                                 })->word;
        text_ += tile_.order == 2 ? "6,ELSET=" : "3,ELSET=";
        text_ += upper_case(kAllElementsSet) + "\n";
        for (int f = 0; f < tile_.n_faces(); ++f) {
            append_number(text_, f + 1);
            for (const int v : element_nodes(tile_, nodes_, f)) {
                text_ += ',';
                append_number(text_, v + 1);
            }
            text_ += '\n';
        }
    }

    void append_ids(const std::vector<int>& ids) {
        for (std::size_t k = 0; k < ids.size(); ++k) {
            append_number(text_, ids[k]);
            text_ += (k + 1) % kIdsALine == 0 || k + 1 == ids.size() ? '\n' : ',';
        }
    }

    void append_cells() {
        std::map<SiteId, std::vector<int>> elements;
        for (int f = 0; f < tile_.n_faces(); ++f) elements[cells_.site(f)].push_back(f + 1);
        add_cells_without_triangles(elements);
        for (const auto& [cell, ids] : elements) {
            cell_sets_.push_back(cell);
            text_ += "*ELSET,ELSET=" + upper_case(kCellSet) + std::to_string(cell) + "\n";
            append_ids(ids);
        }
    }

    void add_cells_without_triangles(std::map<SiteId, std::vector<int>>& elements) const {
        if (tile_.vertex_site.empty()) return;
        std::map<SiteId, std::vector<int>> touching;
        for (int f = 0; f < tile_.n_faces(); ++f) {
            for (const int v : tile_.faces[f]) {
                const SiteId site = tile_.vertex_site[v];
                if (elements.count(site) > 0) continue;
                std::vector<int>& ids = touching[site];
                // A triangle with two images of the site touches it once.
                if (ids.empty() || ids.back() != f + 1) ids.push_back(f + 1);
            }
        }
        elements.merge(touching);
    }

    void append_node_set(const std::string& name, std::vector<int> nodes) {
        if (nodes.empty()) return;
        for (int& v : nodes) ++v;
        text_ += "*NSET,NSET=" + name + "\n";
        append_ids(nodes);
    }

    void append_node_sets() {
        const CellContacts contacts = cell_contacts(tile_, nodes_, cells_);
        append_node_set(upper_case(kGrainBoundarySet), contacts.of_two_cells);
        append_node_set(upper_case(kTriplePointsSet), contacts.of_three_cells);
        std::map<plane::Offset, std::set<int>> seams;
        std::map<plane::WallId, std::set<int>> walls;
        for (const SeamSegment& segment : seam_segments(tile_, nodes_.middles)) {
            std::set<int>& ids = segment.wall ? walls[*segment.wall] : seams[segment.offset];
            ids.insert(segment.vertices.begin(), segment.vertices.end());
            ids.insert(segment.middles.begin(), segment.middles.end());
        }
        for (const auto& [offset, ids] : seams) {
            append_node_set(seam_name(offset), {ids.begin(), ids.end()});
        }
        for (auto& [wall, ids] : walls) {
            // Solvers refuse boundary conditions on nodes that an equation determines.
            for (const plane::VertexPair& pair : nodes_.pairs) ids.erase(pair.w);
            append_node_set(upper_case(wall_name(tile_, wall)), {ids.begin(), ids.end()});
        }
        if (!is_box()) text_ += "*NSET,NSET=" + upper_case(kFixedSet) + "\n1\n";
    }

    /// Appends the sides of elements on each wall: side k of a triangle begins at its corner k.
    void append_wall_sides() {
        std::map<std::pair<int, int>, plane::WallId> wall_of;
        for (const plane::WallEdge& edge : tile_.wall_edges)
            wall_of[{edge.v0, edge.v1}] = edge.wall;
        std::map<plane::WallId, std::string> sides;
        for (int f = 0; !wall_of.empty() && f < tile_.n_faces(); ++f) {
            const auto& corners = tile_.faces[f];
            for (int k = 0; k < 3; ++k) {
                const auto found = wall_of.find({corners[k], corners[(k + 1) % 3]});
                if (found == wall_of.end()) continue;
                std::string& lines = sides[found->second];
                lines += std::to_string(f + 1) + ",S" + std::to_string(k + 1) + "\n";
            }
        }
        for (const auto& [wall, lines] : sides) {
            text_ += "*SURFACE,NAME=" + upper_case(wall_name(tile_, wall)) +
                     upper_case(kSidesSuffix) + ",TYPE=ELEMENT\n" + lines;
        }
    }

    /// Appends `node,dof,coefficient`.
    void append_term(int node, int dof, double coefficient) {
        append_number(text_, node);
        text_ += dof == 1 ? ",1," : ",2,";
        append_real(coefficient);
    }

    void append_equation(const plane::VertexPair& pair, int dof) {
        const plane::Vec2 t = tile_.lattice.translation(pair.offset);
        text_ += "4\n";
        append_term(pair.w + 1, dof, 1);
        text_ += ',';
        append_term(pair.v + 1, dof, -1);
        text_ += ',';
        append_term(control(1), dof, -t.x());
        text_ += ',';
        append_term(control(dof), 2, -t.y());
        text_ += '\n';
    }

    void append_equations() {
        if (is_box()) return;
        text_ += "*EQUATION\n";
        for (const plane::VertexPair& pair : nodes_.pairs) {
            append_equation(pair, 1);
            append_equation(pair, 2);
        }
    }

    const plane::Tile& tile_;
    const FileOptions& options_;
    TriangleCells cells_;
    SolverNodes nodes_;
    std::string path_;
    FixedWidthNumbers numbers_;
    /// The sites whose cells have a set.
    std::vector<SiteId> cell_sets_;
    std::string text_;
};

}  // namespace

std::vector<EncodedFile> encode_inp(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_triangles(tile.kind, path);
    require_finite(tile);
    return only_file(path, InpText(tile, options, path).write());
}

}  // namespace pcvt
