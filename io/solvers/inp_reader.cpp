#include "io/solvers/inp_reader.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/forms/material_words.hpp"
#include "io/solvers/inp_cards.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kTerms = 4;
/// The types of plane triangles; the last character of a name is the number of nodes.
const std::array<const char*, 4> kTypes{"CPE3", "CPS3", "CPE6", "CPS6"};

/// The constraint of one node in one direction.
struct Tie {
    int master;
    int line;
    plane::Vec2 translation;
};

class InpParser final : public InpCards {
   public:
    InpParser(const std::string& name, std::string_view text)
        : InpCards(name, text), file_{.name = name, .index_base = 1, .notes = {.short_edges = 0}} {}

    FileTileBuilder read() {
        parse();
        if (control(0) && control(1)) tie_nodes();
        remove_controls();
        // Cell sets count only in a file of pcvt, and only if its nodes have no sites.
        if (!file_.kind || !file_.sites.empty()) file_.numbered.triangle_sites.clear();
        return std::move(file_);
    }

   private:
    void take_comment(std::string_view key, const Words& values) override {
        if (file_.take_comment(scanner(), key, values)) return;
        if (take_material(scanner(), key, values, file_.materials)) return;
        scanner().throw_bad_file("pcvt does not know " + in_quotes(key) + "; remove the line");
    }

    void take_node(int number, const Position& position) override {
        if (position[2] != 0) {
            scanner().throw_bad_file("z is not 0; move the tile to the plane z = 0");
        }
        file_.numbered.nodes.push_back({number, scanner().line(), {position[0], position[1]}});
    }

    std::size_t n_element_nodes(const std::string& type) const override {
        if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) {
            scanner().throw_bad_file("elements of type " + in_quotes(type) +
                                     " are not plane triangles; give CPE3 or CPE6");
        }
        return static_cast<std::size_t>(type.back() - '0');
    }

    void take_element(int number, std::vector<int> nodes) override {
        file_.numbered.triangles.push_back({number, scanner().line(), std::move(nodes)});
    }

    void take_cell_member(int element, int cell) override {
        file_.numbered.triangle_sites.push_back({element, scanner().line(), cell});
    }

    /// Refuses every equation of another form than encode_inp() writes, because a solver obeys it.
    void require_form(const InpEquation& equation) const {
        const auto& terms = equation.terms;
        const bool is_ours =
            terms.size() == kTerms && (terms[0].direction == 1 || terms[0].direction == 2) &&
            terms[0].coefficient == 1 && terms[1].coefficient == -1 &&
            terms[1].direction == terms[0].direction && terms[2].node == *control(0) &&
            terms[2].direction == terms[0].direction &&
            terms[3].node == *control(terms[0].direction == 1 ? 0 : 1) && terms[3].direction == 2;
        if (is_ours) return;
        throw_bad_file(equation.line,
                       "the equation does not tie a node to its representative by the mean strain; "
                       "write the file "
                       "again with pcvt");
    }

    void tie_nodes() {
        // Collect the ties of both directions.
        std::array<std::map<int, Tie>, 2> ties;
        for (const InpEquation& equation : equations()) {
            require_form(equation);
            const auto& terms = equation.terms;
            const Tie tie{
                terms[1].node, equation.line, {-terms[2].coefficient, -terms[3].coefficient}};
            if (!ties[terms[0].direction - 1].emplace(terms[0].node, tie).second) {
                throw_bad_file(equation.line,
                               "node " + std::to_string(terms[0].node) +
                                   " is tied twice in this direction; remove one equation");
            }
        }
        // The directions agree, and no master is tied itself.
        for (const auto& [node, tie] : ties[1]) {
            if (ties[0].count(node) == 0) refuse_half(node, tie.line);
        }
        for (const auto& [node, tie] : ties[0]) {
            const auto other = ties[1].find(node);
            if (other == ties[1].end() || other->second.master != tie.master ||
                other->second.translation != tie.translation) {
                refuse_half(node, tie.line);
            }
            if (ties[0].count(tie.master) > 0) {
                throw_bad_file(tie.line, "the master node " + std::to_string(tie.master) +
                                             " is tied itself; tie both to one node");
            }
            file_.numbered.links.push_back({node, tie.master, tie.line, tie.translation});
        }
    }

    [[noreturn]] void refuse_half(int node, int line) const {
        throw_bad_file(line,
                       "node " + std::to_string(node) +
                           " is not tied alike in both directions; write the file again with pcvt");
    }

    void remove_controls() {
        std::erase_if(file_.numbered.nodes,
                      [this](const auto& node) { return is_control(node.number); });
    }

    FileTileBuilder file_;
};

}  // namespace

TileFile decode_inp(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& inp = files.front();
    refuse_binary(inp.path, inp.bytes, "give an Abaqus or CalculiX input");
    return finish(InpParser(inp.path, inp.bytes).read(), lattice, plane::Precision::kDouble);
}

}  // namespace pcvt
