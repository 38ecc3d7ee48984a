#include "io/solvers/inp_reader.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/forms/material_words.hpp"

namespace pcvt {
namespace {

using Words = std::vector<std::string_view>;

constexpr const char* kCellSetUpper = "CELL_";
constexpr std::size_t kTerms = 4;
/// The types of plane triangles; the last character of a name is the number of nodes.
const std::array<const char*, 4> kTypes{"CPE3", "CPS3", "CPE6", "CPS6"};

/// Returns a line in upper case and without blanks, as the solver reads it.
std::string compact(const Words& words) {
    std::string text;
    for (const std::string_view word : words) text += word;
    for (char& c : text) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return text;
}

/// Splits a line at its commas; a comma at the end does not begin a field.
Words fields_of(std::string_view text) {
    Words fields;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(','), text.size());
        fields.push_back(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return fields;
}

/// Returns the value of `NAME=value` among the parameters of a card; empty if there is none.
std::string parameter(const Words& fields, std::string_view name) {
    for (const std::string_view field : fields) {
        const std::size_t equals = field.find('=');
        if (equals != std::string_view::npos && field.substr(0, equals) == name) {
            return std::string(field.substr(equals + 1));
        }
    }
    return {};
}

/// An equation of the file: the sum of coefficient x displacement over its terms is 0.
struct Equation {
    struct Term {
        int node;
        int direction;
        double coefficient;
    };
    int line;
    std::vector<Term> terms;
};

/// The constraint of one node in one direction.
struct Tie {
    int master;
    int line;
    plane::Vec2 translation;
};

class InpParser {
   public:
    InpParser(const std::string& name, std::string_view text)
        : scanner_(name, text), file_{.name = name, .index_base = 1, .notes = {.short_edges = 0}} {}

    FileTileBuilder parse() {
        while (scanner_.next()) parse_line();
        if (n_pending_ > 0)
            scanner_.throw_bad_file("the last equation is not whole; write the file again");
        if (controls_[0] && controls_[1]) tie_nodes();
        remove_controls();
        // Cell sets count only in a file of pcvt, and only if its nodes have no sites.
        if (!file_.kind || !file_.sites.empty()) file_.numbered.triangle_sites.clear();
        return std::move(file_);
    }

   private:
    using Handler = void (InpParser::*)(const Words& fields);

    void parse_line() {
        const Words& words = scanner_.words();
        if (words.empty()) return;
        if (words.front().starts_with("**")) {
            parse_comment(words);
            return;
        }
        const std::string line = compact(words);
        const Words fields = fields_of(line);
        if (line.front() == '*') {
            parse_card(fields);
        } else if (handler_ != nullptr) {
            (this->*handler_)(fields);
        }
    }

    void parse_comment(const Words& words) {
        if (words.size() < 3 || words[0] != "**" || words[1] != "pcvt") return;
        const Words values(words.begin() + 3, words.end());
        if (file_.take_comment(scanner_, words[2], values)) return;
        if (take_material(scanner_, words[2], values, file_.materials)) return;
        scanner_.throw_bad_file("pcvt does not know " + in_quotes(words[2]) + "; remove the line");
    }

    void parse_card(const Words& fields) {
        // A card ends the data of the card before it.
        if (n_pending_ > 0)
            scanner_.throw_bad_file(
                "the equation before this card is not whole; write the file again");
        handler_ = nullptr;
        set_.clear();
        // The handler reads the data lines of this card; other cards have none.
        const std::string_view card = fields.front();
        if (card == "*NODE") {
            set_ = parameter(fields, "NSET");
            handler_ = &InpParser::parse_node;
        } else if (card == "*ELEMENT") {
            const std::string type = parameter(fields, "TYPE");
            if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) {
                scanner_.throw_bad_file("elements of type " + in_quotes(type) +
                                        " are not plane triangles; give CPE3 or CPE6");
            }
            n_element_nodes_ = static_cast<std::size_t>(type.back() - '0');
            handler_ = &InpParser::parse_element;
        } else if (card == "*ELSET") {
            set_ = parameter(fields, "ELSET");
            if (set_.starts_with(kCellSetUpper)) handler_ = &InpParser::parse_cell;
        } else if (card == "*EQUATION") {
            handler_ = &InpParser::parse_equation;
        }
    }

    void require_fields(const Words& fields, std::size_t least, std::size_t most) const {
        if (fields.size() >= least && fields.size() <= most) return;
        scanner_.throw_bad_file("the line has " + std::to_string(fields.size()) +
                                " fields, which are too few or too many; write the file again");
    }

    void parse_node(const Words& fields) {
        require_fields(fields, 3, 4);
        if (fields.size() == 4 && scanner_.number(fields[3]) != 0) {
            scanner_.throw_bad_file("z is not 0; move the tile to the plane z = 0");
        }
        const int number = scanner_.integer(fields[0]);
        if (set_ == "CONTROL_1") controls_[0] = number;
        if (set_ == "CONTROL_2") controls_[1] = number;
        file_.numbered.nodes.push_back(
            {number, scanner_.line(), {scanner_.number(fields[1]), scanner_.number(fields[2])}});
    }

    void parse_element(const Words& fields) {
        require_fields(fields, 1 + n_element_nodes_, 1 + n_element_nodes_);
        std::vector<int> nodes;
        for (std::size_t k = 1; k < fields.size(); ++k)
            nodes.push_back(scanner_.integer(fields[k]));
        file_.numbered.triangles.push_back({scanner_.integer(fields[0]), scanner_.line(), nodes});
    }

    void parse_cell(const Words& fields) {
        const int cell =
            scanner_.integer(std::string_view(set_).substr(std::string_view(kCellSetUpper).size()));
        for (const std::string_view field : fields) {
            file_.numbered.triangle_sites.push_back(
                {scanner_.integer(field), scanner_.line(), cell});
        }
    }

    void parse_equation(const Words& fields) {
        // The first line holds the number of terms.
        if (n_pending_ == 0) {
            require_fields(fields, 1, 1);
            n_pending_ = scanner_.integer(fields[0]);
            if (n_pending_ < 1)
                scanner_.throw_bad_file("an equation has at least 1 term; correct it");
            equations_.push_back({scanner_.line(), {}});
            return;
        }
        // The next lines hold the terms, three fields each.
        if (fields.size() % 3 != 0) {
            scanner_.throw_bad_file(
                "a term is a node, a direction and a coefficient; write all three");
        }
        for (std::size_t k = 0; k < fields.size(); k += 3) {
            if (n_pending_-- == 0)
                scanner_.throw_bad_file("the equation has too many terms; correct them");
            equations_.back().terms.push_back({scanner_.integer(fields[k]),
                                               scanner_.integer(fields[k + 1]),
                                               scanner_.number(fields[k + 2])});
        }
    }

    [[noreturn]] void throw_bad_file(int line, const std::string& complaint) const {
        throw BadFile(file_.name + ":" + std::to_string(line) + ": " + complaint);
    }

    /// Refuses every equation of another form than encode_inp() writes, because a solver obeys it.
    void require_form(const Equation& equation) const {
        const auto& terms = equation.terms;
        const bool is_ours =
            terms.size() == kTerms && (terms[0].direction == 1 || terms[0].direction == 2) &&
            terms[0].coefficient == 1 && terms[1].coefficient == -1 &&
            terms[1].direction == terms[0].direction && terms[2].node == *controls_[0] &&
            terms[2].direction == terms[0].direction &&
            terms[3].node == *controls_[terms[0].direction == 1 ? 0 : 1] && terms[3].direction == 2;
        if (is_ours) return;
        throw_bad_file(equation.line,
                       "the equation does not tie a node to its representative by the mean strain; "
                       "write the file "
                       "again with pcvt");
    }

    void tie_nodes() {
        // Collect the ties of both directions.
        std::array<std::map<int, Tie>, 2> ties;
        for (const Equation& equation : equations_) {
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
        const auto is_control = [&](const NumberedItems::Node& node) {
            return node.number == controls_[0] || node.number == controls_[1];
        };
        file_.numbered.nodes.erase(
            std::remove_if(file_.numbered.nodes.begin(), file_.numbered.nodes.end(), is_control),
            file_.numbered.nodes.end());
    }

    LineScanner scanner_;
    FileTileBuilder file_;
    Handler handler_ = nullptr;
    /// The name of the set that the current card fills; empty if it has none.
    std::string set_;
    std::size_t n_element_nodes_ = 3;
    std::array<std::optional<int>, 2> controls_;
    std::vector<Equation> equations_;
    int n_pending_ = 0;
};

}  // namespace

TileFile decode_inp(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& inp = files.front();
    refuse_binary(inp.path, inp.bytes, "give an Abaqus or CalculiX input");
    return finish(InpParser(inp.path, inp.bytes).parse(), lattice, plane::Precision::kDouble);
}

}  // namespace pcvt
