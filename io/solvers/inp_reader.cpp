#include "io/solvers/inp_reader.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/forms/material_words.hpp"
#include "io/solvers/inp_cards.hpp"
#include "io/solvers/inp_wedges.hpp"

namespace pcvt {
namespace {

/// The types of elements that a file of a tile in the plane may have.
struct InpType {
    std::string_view name;
    std::size_t n_nodes;
    bool is_wedge;
};
constexpr std::array kTypes{InpType{"CPE3", 3, false}, InpType{"CPS3", 3, false},
                            InpType{"CPE6", 6, false}, InpType{"CPS6", 6, false},
                            InpType{"C3D6", 6, true},  InpType{"C3D15", 15, true}};
/// The number of words of a lattice in space.
constexpr std::size_t kSpaceLattice = 9;

class InpParser final : public InpCards {
   public:
    InpParser(const std::string& name, std::string_view text)
        : InpCards(name, text),
          file_{.name = name, .index_base = 1, .notes = {.short_edges = 0}},
          layer_{.name = name, .thickness = 0} {}

    FileTileBuilder read() {
        parse();
        std::erase_if(layer_.nodes,
                      [this](const NumberedPoint& node) { return is_control(node.number); });
        are_wedges_ ? require_layer() : require_plane();
        if (control(0) && control(1) && (control(2) || !are_wedges_)) tie_nodes();
        if (are_wedges_) flatten(layer_);
        take_items();
        // Cell sets count only in a file of pcvt, and only if its nodes have no sites.
        if (!file_.kind || !file_.sites.empty()) file_.numbered.triangle_sites.clear();
        return std::move(file_);
    }

    /// The height of the wedges; 0 in a file of triangles.
    double thickness() const { return layer_.thickness; }

   private:
    void take_comment(std::string_view key, const Words& values) override {
        if (key == "lattice" && values.size() == kSpaceLattice) {
            take_space_lattice(values);
            return;
        }
        if (file_.take_comment(scanner(), key, values)) return;
        if (take_material(scanner(), key, values, file_.materials)) return;
        scanner().throw_bad_file("pcvt does not know " + in_quotes(key) + "; remove the line");
    }

    /// The periods of wedges: two in the plane, and the thickness along z.
    void take_space_lattice(const Words& values) {
        for (const std::size_t k : {2, 5, 6, 7}) {
            if (scanner().number(values[k]) == 0) continue;
            scanner().throw_bad_file("the lattice is not that of a layer along z; correct it");
        }
        layer_.thickness = scanner().number(values[8]);
        if (!(layer_.thickness > 0)) {
            scanner().throw_bad_file("the thickness is not above 0; correct the lattice");
        }
        file_.take_comment(scanner(), "lattice", Words{values[0], values[1], values[3], values[4]});
    }

    void take_node(int number, const Position& position) override {
        layer_.nodes.push_back({number, scanner().line(), position});
    }

    std::size_t n_element_nodes(const std::string& type) override {
        const auto* const found = std::find_if(
            kTypes.begin(), kTypes.end(), [&](const InpType& row) { return row.name == type; });
        if (found == kTypes.end()) {
            scanner().throw_bad_file("elements of type " + in_quotes(type) +
                                     " are not plane triangles; give CPE3 or CPE6");
        }
        if (!layer_.elements.empty() && found->is_wedge != are_wedges_) {
            scanner().throw_bad_file("there are triangles and wedges; take one kind of elements");
        }
        are_wedges_ = found->is_wedge;
        return found->n_nodes;
    }

    void take_element(int number, std::vector<int> nodes) override {
        layer_.elements.push_back({number, scanner().line(), std::move(nodes)});
    }

    void take_cell_member(int element, int cell) override {
        file_.numbered.triangle_sites.push_back({element, scanner().line(), cell});
    }

    int dimension() const { return are_wedges_ ? 3 : 2; }

    static bool is_term(const InpEquation::Term& term, int node, int direction) {
        return term.node == node && term.direction == direction;
    }

    /// Refuses every equation of another form than encode_inp() writes, because a solver obeys it.
    void require_form(const InpEquation& equation) const {
        const auto& terms = equation.terms;
        const int i = terms.front().direction;
        bool is_ours = std::ssize(terms) == 2 + dimension() && i >= 1 && i <= dimension() &&
                       terms[0].coefficient == 1 && terms[1].coefficient == -1 &&
                       terms[1].direction == i;
        for (int j = 1; is_ours && j <= dimension(); ++j) {
            is_ours = is_term(terms[1 + j], *control(std::min(i, j) - 1), std::max(i, j));
        }
        if (is_ours) return;
        throw_bad_file(equation.line,
                       "the equation does not tie a node to its representative by the mean strain; "
                       "write the file "
                       "again with pcvt");
    }

    NumberedTie tie_of(const InpEquation& equation) const {
        const auto& terms = equation.terms;
        NumberedTie tie{terms[0].node, terms[1].node, equation.line, {}};
        for (int j = 0; j < dimension(); ++j) tie.translation[j] = -terms[2 + j].coefficient;
        return tie;
    }

    void tie_nodes() {
        // Collect the ties of all directions.
        std::vector<std::map<int, NumberedTie>> ties(static_cast<std::size_t>(dimension()));
        for (const InpEquation& equation : equations()) {
            require_form(equation);
            const NumberedTie tie = tie_of(equation);
            if (!ties[equation.terms[0].direction - 1].emplace(tie.node, tie).second) {
                throw_bad_file(equation.line,
                               "node " + std::to_string(tie.node) +
                                   " is tied twice in this direction; remove one equation");
            }
        }
        // The directions agree, and no master is tied itself.
        for (const auto& others : ties) {
            for (const auto& [node, tie] : others) require_alike(ties, tie);
        }
        for (const auto& [node, tie] : ties[0]) {
            if (ties[0].count(tie.master) > 0) {
                throw_bad_file(tie.line, "the master node " + std::to_string(tie.master) +
                                             " is tied itself; tie both to one node");
            }
            layer_.ties.push_back(tie);
        }
    }

    /// Requires that a node is tied as `tie` states in all directions.
    void require_alike(const std::vector<std::map<int, NumberedTie>>& ties,
                       const NumberedTie& tie) const {
        for (const auto& others : ties) {
            const auto other = others.find(tie.node);
            if (other != others.end() && other->second.master == tie.master &&
                other->second.translation == tie.translation)
                continue;
            throw_bad_file(tie.line, "node " + std::to_string(tie.node) + " is not tied alike in " +
                                         (dimension() == 2 ? "both" : "all") +
                                         " directions; write the file again with pcvt");
        }
    }

    void require_layer() const {
        if (layer_.thickness > 0 && !layer_.elements.empty()) return;
        throw BadFile(name() +
                      ": has not one layer of wedges with the nine numbers of its lattice;" +
                      " write the file again with pcvt");
    }

    void require_plane() const {
        if (layer_.thickness > 0) {
            throw BadFile(name() + ": has the lattice of wedges, but no wedges; write the file " +
                          "again with pcvt");
        }
        for (const NumberedPoint& node : layer_.nodes) {
            if (node.position[2] == 0) continue;
            throw_bad_file(node.line, "z is not 0; move the tile to the plane z = 0");
        }
    }

    void take_items() {
        for (const auto& [number, line, position] : layer_.nodes) {
            file_.numbered.nodes.push_back({number, line, {position[0], position[1]}});
        }
        for (const NumberedTie& tie : layer_.ties) {
            file_.numbered.links.push_back(
                {tie.node, tie.master, tie.line, {tie.translation[0], tie.translation[1]}});
        }
        file_.numbered.triangles = std::move(layer_.elements);
    }

    FileTileBuilder file_;
    /// The nodes, elements and ties of the file; its thickness is 0 where it states none.
    FileWedges layer_;
    bool are_wedges_ = false;
};

}  // namespace

TileFile decode_inp(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& inp = files.front();
    refuse_binary(inp.path, inp.bytes, "give an Abaqus or CalculiX input");
    InpParser parser(inp.path, inp.bytes);
    FileTileBuilder builder = parser.read();
    TileFile file = finish(std::move(builder), lattice, plane::Precision::kDouble);
    file.thickness = parser.thickness();
    return file;
}

}  // namespace pcvt
