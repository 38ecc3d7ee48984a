#include "io/solvers/inp_cards.hpp"

#include <algorithm>

#include "io/bytes/bad_file.hpp"
#include "io/solvers/inp_fields.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

/// Returns a line in upper case and without blanks, as the solver reads it.
std::string compact(const InpCards::Words& words) {
    std::string text;
    for (const std::string_view word : words) text += word;
    return upper_case(text);
}

/// Splits a line at its commas; a comma at the end does not begin a field.
InpCards::Words fields_of(std::string_view text) {
    InpCards::Words fields;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(','), text.size());
        fields.push_back(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return fields;
}

/// Returns the value of `NAME=value` among the parameters of a card; empty if there is none.
std::string parameter(const InpCards::Words& fields, std::string_view name) {
    for (const std::string_view field : fields) {
        const std::size_t equals = field.find('=');
        if (equals != std::string_view::npos && field.substr(0, equals) == name) {
            return std::string(field.substr(equals + 1));
        }
    }
    return {};
}

}  // namespace

void InpCards::parse() {
    while (scanner_.next()) parse_line();
    if (n_pending_ > 0)
        scanner_.throw_bad_file("the last equation is not whole; write the file again");
}

bool InpCards::is_control(int node) const {
    return std::find(controls_.begin(), controls_.end(), node) != controls_.end();
}

void InpCards::throw_bad_file(int line, const std::string& complaint) const {
    throw BadFile(name_ + ":" + std::to_string(line) + ": " + complaint);
}

void InpCards::parse_line() {
    const Words& words = scanner_.words();
    if (words.empty()) return;
    if (words.front().starts_with("**")) {
        if (words.size() < 3 || words[0] != "**" || words[1] != "pcvt") return;
        take_comment(words[2], {words.begin() + 3, words.end()});
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

void InpCards::parse_card(const Words& fields) {
    // A card ends the data of the card before it.
    if (n_pending_ > 0)
        scanner_.throw_bad_file("the equation before this card is not whole; write the file again");
    handler_ = nullptr;
    set_.clear();
    // The handler reads the data lines of this card; other cards have none.
    const std::string_view card = fields.front();
    if (card == "*NODE") {
        set_ = parameter(fields, "NSET");
        handler_ = &InpCards::parse_node;
    } else if (card == "*ELEMENT") {
        n_element_nodes_ = n_element_nodes(parameter(fields, "TYPE"));
        handler_ = &InpCards::parse_element;
    } else if (card == "*ELSET") {
        set_ = parameter(fields, "ELSET");
        if (set_.starts_with(upper_case(kCellSet))) handler_ = &InpCards::parse_cell;
    } else if (card == "*EQUATION") {
        handler_ = &InpCards::parse_equation;
    }
}

void InpCards::require_fields(const Words& fields, std::size_t least, std::size_t most) const {
    if (fields.size() >= least && fields.size() <= most) return;
    scanner_.throw_bad_file("the line has " + std::to_string(fields.size()) +
                            " fields, which are too few or too many; write the file again");
}

void InpCards::parse_node(const Words& fields) {
    require_fields(fields, 3, 4);
    const int number = scanner_.integer(fields[0]);
    for (std::size_t k = 0; k < controls_.size(); ++k) {
        if (set_ == upper_case(kControlSet) + std::to_string(k + 1)) controls_[k] = number;
    }
    take_node(number, {scanner_.number(fields[1]), scanner_.number(fields[2]),
                       fields.size() == 4 ? scanner_.number(fields[3]) : 0});
}

void InpCards::parse_element(const Words& fields) {
    require_fields(fields, 1 + n_element_nodes_, 1 + n_element_nodes_);
    std::vector<int> nodes;
    for (std::size_t k = 1; k < fields.size(); ++k) nodes.push_back(scanner_.integer(fields[k]));
    take_element(scanner_.integer(fields[0]), std::move(nodes));
}

void InpCards::parse_cell(const Words& fields) {
    const int cell = scanner_.integer(std::string_view(set_).substr(kCellSet.size()));
    for (const std::string_view field : fields) take_cell_member(scanner_.integer(field), cell);
}

void InpCards::parse_equation(const Words& fields) {
    // The first line holds the number of terms.
    if (n_pending_ == 0) {
        require_fields(fields, 1, 1);
        n_pending_ = scanner_.integer(fields[0]);
        if (n_pending_ < 1) scanner_.throw_bad_file("an equation has at least 1 term; correct it");
        equations_.push_back({scanner_.line(), {}});
        return;
    }
    // The next lines hold the terms, three fields each.
    if (fields.size() % 3 != 0) {
        scanner_.throw_bad_file("a term is a node, a direction and a coefficient; write all three");
    }
    for (std::size_t k = 0; k < fields.size(); k += 3) {
        if (n_pending_-- == 0)
            scanner_.throw_bad_file("the equation has too many terms; correct them");
        equations_.back().terms.push_back({scanner_.integer(fields[k]),
                                           scanner_.integer(fields[k + 1]),
                                           scanner_.number(fields[k + 2])});
    }
}

}  // namespace pcvt
