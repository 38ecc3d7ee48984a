#include "io/solvers/inp_writer.hpp"

#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "io/forms/finite.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/seam_segments.hpp"
#include "io/forms/site_notes.hpp"
#include "io/forms/site_orbits.hpp"
#include "io/forms/solver_nodes.hpp"
#include "io/forms/triangle_cells.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/solvers/inp_fields.hpp"
#include "io/solvers/inp_sections.hpp"
#include "io/solvers/inp_text.hpp"
#include "io/solvers/inp_wedges.hpp"

namespace pcvt {
namespace {

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

/// Makes the form of one tile, part by part.
class PlaneInp {
   public:
    PlaneInp(const plane::Tile& tile, const FileOptions& options)
        : tile_(tile),
          options_(options),
          cells_(tile),
          nodes_(solver_nodes(tile)),
          thickness_(are_wedges(options.element) ? wedge_thickness(tile, options) : 0),
          form_{.mesh = element_mesh(tile, nodes_)} {}

    InpForm make() {
        form_.element = plane_element_row(options_.element).word;
        form_.element += tile_.order == 2 ? "6" : "3";
        form_.kind = file_word(tile_.kind);
        form_.is_strained = !is_box();
        form_.explanation = explanation();
        append_notes();
        add_ties();
        add_cells();
        form_.orbits = inp_orbit_sets(options_.site_orbits, cell_sets_);
        add_node_sets();
        add_wall_sides();
        if (thickness_ > 0) extrude(tile_, cells_, materials(), thickness_, form_);
        add_job();
        return std::move(form_);
    }

   private:
    CellMaterials materials() const {
        return options_.materials != nullptr ? *options_.materials : CellMaterials{};
    }

    void add_job() {
        const int dimension = form_.mesh.dimension;
        if (options_.materials != nullptr) {
            form_.job = inp_sections(*options_.materials, cell_sets_, dimension);
        }
        if (options_.job == SolverJob::kElastic) {
            const double height = thickness_ > 0 ? thickness_ : 1;
            form_.job += inp_elastic_job(materials(), options_.elastic,
                                         tile_.lattice.area() * height, dimension);
        }
    }

    /// Whether walls leave no seam, so that no node is tied.
    bool is_box() const { return tile_.walls == Walls::kXY && thickness_ == 0; }

    std::string explanation() const {
        std::string text = inp_head(options_);
        if (tile_.walls != Walls::kNone) {
            const std::string_view what(kPeriodicTile);
            text.replace(text.find(what), what.size(), kBetweenWalls);
        }
        text += is_box() ? kBoxExplanation : thickness_ > 0 ? kInpStrainsInSpace : kExplanation;
        if (tile_.walls != Walls::kNone) text += kWallSets;
        return text;
    }

    void append_notes() {
        std::string& text = form_.notes;
        append_note_comments(text, "** pcvt ", tile_, 1);
        append_inp_sites(text, tile_.vertex_site);
        append_materials(text, "** pcvt ", materials());
        append_site_orbits(text, "** pcvt ", options_.site_orbits);
    }

    void add_ties() {
        for (const plane::VertexPair& pair : nodes_.pairs) {
            const plane::Vec2 t = tile_.lattice.translation(pair.offset);
            form_.ties.push_back({pair.w, pair.v, {t.x(), t.y(), 0}});
        }
    }

    void add_cells() {
        std::map<SiteId, std::vector<int>> elements;
        for (int f = 0; f < tile_.n_faces(); ++f) elements[cells_.site(f)].push_back(f);
        add_cells_without_triangles(elements);
        for (auto& [cell, members] : elements) {
            cell_sets_.push_back(cell);
            form_.cells.push_back(
                {upper_case(kCellSet) + std::to_string(cell), std::move(members)});
        }
    }

    void add_cells_without_triangles(std::map<SiteId, std::vector<int>>& elements) const {
        if (tile_.vertex_site.empty()) return;
        std::map<SiteId, std::vector<int>> touching;
        for (int f = 0; f < tile_.n_faces(); ++f) {
            for (const int v : tile_.faces[f]) {
                const SiteId site = tile_.vertex_site[v];
                if (elements.count(site) > 0) continue;
                std::vector<int>& members = touching[site];
                // A triangle with two images of the site touches it once.
                if (members.empty() || members.back() != f) members.push_back(f);
            }
        }
        elements.merge(touching);
    }

    void add_node_sets() {
        const CellContacts contacts = cell_contacts(tile_, nodes_, cells_);
        form_.node_sets = {{upper_case(kGrainBoundarySet), contacts.of_two_cells},
                           {upper_case(kTriplePointsSet), contacts.of_three_cells}};
        std::map<plane::Offset, std::set<int>> seams;
        std::map<plane::WallId, std::set<int>> walls;
        for (const SeamSegment& segment : seam_segments(tile_, nodes_.middles)) {
            std::set<int>& nodes = segment.wall ? walls[*segment.wall] : seams[segment.offset];
            nodes.insert(segment.vertices.begin(), segment.vertices.end());
            nodes.insert(segment.middles.begin(), segment.middles.end());
        }
        for (const auto& [offset, nodes] : seams) {
            form_.node_sets.push_back({seam_name(offset), {nodes.begin(), nodes.end()}});
        }
        for (auto& [wall, nodes] : walls) {
            // Solvers refuse boundary conditions on nodes that an equation determines.
            for (const plane::VertexPair& pair : nodes_.pairs) nodes.erase(pair.w);
            form_.node_sets.push_back({.name = upper_case(wall_name(tile_, wall)),
                                       .members = {nodes.begin(), nodes.end()},
                                       .is_free = true});
        }
    }

    /// Adds the sides of elements on each wall: side k of a triangle begins at its corner k.
    void add_wall_sides() {
        std::map<std::pair<int, int>, plane::WallId> wall_of;
        for (const plane::WallEdge& edge : tile_.wall_edges)
            wall_of[{edge.v0, edge.v1}] = edge.wall;
        std::map<plane::WallId, std::vector<std::array<int, 2>>> sides;
        for (int f = 0; !wall_of.empty() && f < tile_.n_faces(); ++f) {
            const auto& corners = tile_.faces[f];
            for (int k = 0; k < 3; ++k) {
                const auto found = wall_of.find({corners[k], corners[(k + 1) % 3]});
                if (found != wall_of.end()) sides[found->second].push_back({f, k + 1});
            }
        }
        for (auto& [wall, of_wall] : sides) {
            form_.surfaces.push_back({upper_case(wall_name(tile_, wall)) + upper_case(kSidesSuffix),
                                      std::move(of_wall)});
        }
    }

    const plane::Tile& tile_;
    const FileOptions& options_;
    TriangleCells cells_;
    SolverNodes nodes_;
    /// The height of the wedges; 0 for triangles.
    double thickness_;
    InpForm form_;
    /// The sites whose cells have a set.
    std::vector<SiteId> cell_sets_;
};

}  // namespace

std::vector<EncodedFile> encode_inp(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_triangles(tile.kind, path);
    require_finite(tile);
    return only_file(path, inp_text(PlaneInp(tile, options).make(), path));
}

}  // namespace pcvt
