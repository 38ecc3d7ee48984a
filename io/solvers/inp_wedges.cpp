#include "io/solvers/inp_wedges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/forms/box_sets.hpp"
#include "io/forms/wedges.hpp"
#include "io/solvers/inp_fields.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

/// Abaqus numbers the bottom and the top of a wedge 1 and 2, then the side over edge 1.
constexpr int kSidesBefore = 2;
/// As the proof of a tile compares positions.
constexpr double kHeightUlps = 4;

/// Turns the parts of a form in the plane into those of a layer of wedges.
class Extrusion {
   public:
    Extrusion(const plane::Tile& tile, double thickness, InpForm& form)
        : form_(form),
          nodes_{form.mesh.n_nodes(), tile.n_vertices(), tile.order},
          thickness_(thickness) {}

    void extrude() {
        form_.element = nodes_.order == 2 ? "C3D15" : "C3D6";
        form_.mesh = wedge_mesh(form_.mesh, nodes_.n_corners, thickness_);
        form_.is_strained = true;
        add_ties();
        raise_node_sets();
        for (InpSurface& surface : form_.surfaces) {
            for (std::array<int, 2>& side : surface.sides) side[1] += kSidesBefore;
        }
    }

   private:
    void add_ties() {
        const std::vector<InpTie> of_triangles = std::move(form_.ties);
        form_.ties = of_triangles;
        for (int v = 0; v < nodes_.n_layer; ++v) {
            form_.ties.push_back({nodes_.at_top(v), v, {0, 0, thickness_}});
        }
        for (const InpTie& tie : of_triangles) {
            InpTie& top = form_.ties[of_triangles.size() + static_cast<std::size_t>(tie.node)];
            top.representative = tie.representative;
            top.translation = {tie.translation[0], tie.translation[1], thickness_};
            if (nodes_.order == 1 || tie.node >= nodes_.n_corners) continue;
            form_.ties.push_back({nodes_.in_middle(tie.node), nodes_.in_middle(tie.representative),
                                  tie.translation});
        }
    }

    /// All nodes above some of the triangles.
    std::vector<int> raised(const std::vector<int>& members) const {
        std::vector<int> raised = members;
        for (const int v : members) raised.push_back(nodes_.at_top(v));
        for (const int v : members) {
            if (nodes_.order == 2 && v < nodes_.n_corners) raised.push_back(nodes_.in_middle(v));
        }
        return raised;
    }

    void raise_node_sets() {
        for (InpSet& set : form_.node_sets) {
            set.members = raised(set.members);
            if (set.name == upper_case(kTriplePointsSet)) set.name = upper_case(kTripleLinesSet);
            if (set.name.starts_with(kSeamSet)) set.name += "_0";
            if (!set.is_free) continue;
            // The nodes at the top are tied to those at the bottom.
            std::erase_if(set.members, [this](int node) { return nodes_.is_at_top(node); });
        }
        InpSet bottom{seam_name(std::array{0, 0, 1})};
        InpSet top{seam_name(std::array{0, 0, -1})};
        for (int v = 0; v < nodes_.n_layer; ++v) {
            bottom.members.push_back(v);
            top.members.push_back(nodes_.at_top(v));
        }
        form_.node_sets.push_back(std::move(bottom));
        form_.node_sets.push_back(std::move(top));
        for (BoxSet& set : box_sets(form_.mesh)) {
            form_.node_sets.push_back({std::move(set.name), std::move(set.nodes), true});
        }
    }

    InpForm& form_;
    const WedgeNodes nodes_;
    const double thickness_;
};

/// The side of a wedge over edge k of its triangle, as Abaqus numbers it.
std::array<int, 2> numbered_side(const SharedEdge& edge, std::size_t k) {
    return {edge.faces[k], edge.sides[k] + 1 + kSidesBefore};
}

void add_boundaries(const plane::Tile& tile, const TriangleCells& cells,
                    const CellMaterials& materials, std::vector<InpSurface>& surfaces) {
    InpSurface boundary{upper_case(kGrainBoundarySet) + upper_case(kSidesSuffix)};
    std::map<std::array<int, 2>, std::vector<std::array<int, 2>>> between;
    for (const SharedEdge& edge : shared_edges(tile, cells)) {
        if (!edge.is_between_cells) continue;
        const std::array one = numbered_side(edge, 0);
        const std::array other = numbered_side(edge, 1);
        boundary.sides.push_back(std::min(one, other));
        if (materials.site_phase.empty()) continue;
        const int p = materials.site_phase[cells.site(one[0])];
        const int q = materials.site_phase[cells.site(other[0])];
        if (p == q) continue;
        between[{p, q}].push_back(one);
        between[{q, p}].push_back(other);
    }
    std::sort(boundary.sides.begin(), boundary.sides.end());
    surfaces.push_back(std::move(boundary));
    for (auto& [phases, sides] : between) {
        std::sort(sides.begin(), sides.end());
        surfaces.push_back({upper_case(kPhaseSet) + materials.phase_names[phases[0]] + "_TO_" +
                                materials.phase_names[phases[1]],
                            std::move(sides)});
    }
}

/// Takes the wedges of a file to the triangles below them, part by part.
class Flattening {
   public:
    explicit Flattening(FileWedges& file) : file_(file) {}

    void flatten() {
        find_layer();
        for (NumberedItems::Triangle& element : file_.elements) flatten(element);
        require_positions();
        flatten_ties();
        file_.nodes.resize(static_cast<std::size_t>(nodes_.n_layer));
    }

   private:
    [[noreturn]] void refuse(int line, const std::string& complaint) const {
        throw BadFile(file_.name + ":" + std::to_string(line) + ": " + complaint +
                      "; write the file again with pcvt");
    }

    /// Whether a node has the number; the nodes are numbered 1, 2, ...
    bool is_number(int number) const { return number >= 1 && number <= std::ssize(file_.nodes); }

    void find_layer() {
        std::stable_sort(file_.nodes.begin(), file_.nodes.end(),
                         [](const auto& p, const auto& q) { return p.number < q.number; });
        for (std::size_t k = 0; k < file_.nodes.size(); ++k) {
            const NumberedPoint& node = file_.nodes[k];
            if (node.number == static_cast<int>(k) + 1) continue;
            refuse(node.line, "the nodes are not numbered 1, 2, ..., each once");
        }
        const NumberedItems::Triangle& first = file_.elements.front();
        const int n = static_cast<int>(file_.nodes.size());
        nodes_.order = first.nodes.size() == 15 ? 2 : 1;
        for (const int number : first.nodes) {
            if (!is_number(number)) refuse_element(first);
        }
        nodes_.n_layer = first.nodes[3] - first.nodes[0];
        nodes_.n_corners = nodes_.order == 1 ? nodes_.n_layer : n - 2 * nodes_.n_layer;
        if (nodes_.n_layer < 1 || nodes_.n_corners < 1 || nodes_.n_corners > nodes_.n_layer ||
            nodes_.n_nodes() != n) {
            refuse(first.line, "the wedges are not one layer");
        }
    }

    void flatten(NumberedItems::Triangle& element) const {
        std::vector<int> triangle;
        for (const std::size_t first : {std::size_t{0}, std::size_t{6}}) {
            if (first >= element.nodes.size()) break;
            for (std::size_t k = first; k < first + 3; ++k) {
                const int number = element.nodes[k];
                const int most = first == 0 ? nodes_.n_corners : nodes_.n_layer;
                if (number < 1 || number > most) refuse_element(element);
                triangle.push_back(number - 1);
            }
        }
        std::vector<int> wedge = nodes_.wedge(triangle);
        for (int& v : wedge) ++v;
        if (wedge != element.nodes) refuse_element(element);
        for (int& v : triangle) ++v;
        element.nodes = std::move(triangle);
    }

    [[noreturn]] void refuse_element(const NumberedItems::Triangle& element) const {
        refuse(element.line, "wedge " + std::to_string(element.number) +
                                 " does not stand on a triangle of the first nodes");
    }

    /// Heights are rounded to the width of a number.
    bool is_height(double z, double height) const {
        return std::abs(z - height) <= (height == 0 ? 0 : tolerance_);
    }

    void require_positions() {
        double largest = file_.thickness;
        for (const NumberedPoint& node : file_.nodes) {
            for (const double x : node.position) largest = std::max(largest, std::abs(x));
        }
        tolerance_ = kHeightUlps * std::numeric_limits<double>::epsilon() * largest;
        for (int v = 0; v < nodes_.n_nodes(); ++v) {
            const NumberedPoint& node = file_.nodes[v];
            const auto& [x, y, z] = node.position;
            const auto& below = file_.nodes[nodes_.column(v)].position;
            if (x == below[0] && y == below[1] && is_height(z, nodes_.height(v, file_.thickness)))
                continue;
            refuse(node.line, "node " + std::to_string(node.number) +
                                  " does not lie above its node at the bottom");
        }
    }

    /// The tie of each node of the triangles, which are the representatives of all others.
    void flatten_ties() {
        if (file_.ties.empty()) return;
        std::map<int, NumberedTie> ties;
        for (const NumberedTie& tie : file_.ties) {
            if (!is_number(tie.node) || !is_number(tie.master)) {
                refuse(tie.line, "the tie is of a node that is missing");
            }
            ties.emplace(tie.node - 1, tie);
        }
        file_.ties.clear();
        for (int node = 0; node < nodes_.n_nodes(); ++node) {
            const int v = nodes_.column(node);
            const auto below = ties.find(v);
            const bool is_tied = below != ties.end();
            NumberedTie wanted{.node = node + 1,
                               .master = is_tied ? below->second.master : v + 1,
                               .line = 0,
                               .translation = {}};
            if (is_tied) wanted.translation = below->second.translation;
            if (node - v > nodes_.n_layer) wanted.master += node - v;
            wanted.translation[2] = nodes_.is_at_top(node) ? file_.thickness : 0;
            const auto found = ties.find(node);
            require_tie(node, is_tied || nodes_.is_at_top(node),
                        found == ties.end() ? nullptr : &found->second, wanted);
            if (is_tied && node == v) file_.ties.push_back(below->second);
        }
    }

    void require_tie(int node, bool is_tied, const NumberedTie* found,
                     const NumberedTie& wanted) const {
        const bool is_right = found == nullptr
                                  ? !is_tied
                                  : is_tied && found->master == wanted.master &&
                                        found->translation[0] == wanted.translation[0] &&
                                        found->translation[1] == wanted.translation[1] &&
                                        is_height(found->translation[2], wanted.translation[2]);
        if (is_right) return;
        refuse(found != nullptr ? found->line : file_.nodes[node].line,
               "node " + std::to_string(node + 1) + " is not tied as the node below it");
    }

    FileWedges& file_;
    WedgeNodes nodes_{};
    double tolerance_ = 0;
};

}  // namespace

double wedge_thickness(const plane::Tile& tile, const FileOptions& options) {
    return options.thickness > 0 ? options.thickness
                                 : std::sqrt(tile.lattice.area() / tile.n_faces());
}

void extrude(const plane::Tile& tile, const TriangleCells& cells, const CellMaterials& materials,
             double thickness, InpForm& form) {
    Extrusion(tile, thickness, form).extrude();
    add_boundaries(tile, cells, materials, form.surfaces);
}

void flatten(FileWedges& file) { Flattening(file).flatten(); }

}  // namespace pcvt
