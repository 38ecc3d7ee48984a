#include "io/solvers/msh_sections.hpp"

#include <utility>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

void MshSections::parse() {
    if (!rows_.next_filled() || rows_.words() != MshRows::Words{"$MeshFormat"}) {
        throw BadFile(name_ + ": does not begin with $MeshFormat; give a file in MSH 4.1");
    }
    do parse_section();
    while (rows_.next_filled());
}

void MshSections::parse_section() {
    // A section begins with $NAME and ends with $EndNAME.
    const std::string section(rows_.words().front());
    if (section.size() < 2 || section[0] != '$' || section.starts_with("$End")) {
        rows_.throw_bad_file(in_quotes(section) +
                             " does not begin a section; write the file again");
    }
    const std::string end = "$End" + section.substr(1);
    bool is_taken = true;
    if (section == "$MeshFormat") {
        parse_format();
    } else if (section == "$Nodes") {
        parse_nodes();
    } else if (section == "$Elements") {
        parse_elements();
    } else if (section == "$NodeData" || section == "$ElementData") {
        is_taken = parse_view(section == "$NodeData");
    } else {
        is_taken = section != "$Comments" && take_section(section);
    }
    // A section that was taken has no further row.
    while (rows_.next_row().front() != end) {
        if (is_taken) {
            rows_.throw_bad_file("the section has more lines than its count; correct the count");
        }
        if (section == "$Comments") take_comment();
    }
}

void MshSections::parse_format() {
    rows_.next_row(3);
    if (rows_.words()[0] != "4.1") {
        rows_.throw_bad_file("the version is " + in_quotes(rows_.words()[0]) +
                             "; save the file as MSH 4.1");
    }
    if (rows_.words()[1] != "0") rows_.throw_bad_file("the file is binary; save it as ASCII");
}

void MshSections::parse_nodes() {
    rows_.next_row(4);
    for (int block = rows_.count(0); block > 0; --block) {
        rows_.next_row(4);
        if (rows_.integer(2) != 0) rows_.throw_bad_file("nodes with parameters; save without them");
        // Grows with the rows, so that a wrong count does not take memory.
        std::vector<std::pair<int, int>> numbers;
        for (int left = rows_.count(3); left > 0; --left) {
            rows_.next_row(1);
            numbers.emplace_back(rows_.integer(0), rows_.line());
        }
        for (const auto& [number, line] : numbers) {
            rows_.next_row(3);
            take_node(number, line, {rows_.number(0), rows_.number(1), rows_.number(2)});
        }
    }
    end_nodes();
}

void MshSections::parse_elements() {
    rows_.next_row(4);
    for (int block = rows_.count(0); block > 0; --block) {
        rows_.next_row(4);
        const int dimension = rows_.integer(0);
        const int entity = rows_.integer(1);
        const int number = rows_.integer(2);
        int left = rows_.count(3);
        const ElementType* const type = find_element_type(&ElementType::msh, number);
        const bool is_taken = takes(type, number);
        for (; left > 0; --left) {
            if (!is_taken) {
                rows_.next_row();
                continue;
            }
            rows_.next_row(1 + static_cast<std::size_t>(type->n_nodes));
            take_element(*type, dimension, entity);
        }
    }
}

bool MshSections::parse_view(bool of_nodes) {
    // The first string tag is the name.
    std::string view;
    for (int n = (rows_.next_row(1), rows_.count(0)); n > 0; --n) {
        rows_.next_row();
        if (view.empty()) view = std::string(rows_.words().front());
    }
    const bool is_quoted = view.size() > 1 && view.front() == '"' && view.back() == '"';
    if (!is_quoted || !states_sites(std::string_view(view).substr(1, view.size() - 2), of_nodes)) {
        return false;
    }
    // Skip the real tags; the last integer tag is the number of values.
    for (int n = (rows_.next_row(1), rows_.count(0)); n > 0; --n) rows_.next_row();
    int n_values = 0;
    for (int n = (rows_.next_row(1), rows_.count(0)); n > 0; --n) {
        n_values = (rows_.next_row(1), rows_.count(0));
    }
    if (!takes_sites(of_nodes, n_values)) return false;
    for (; n_values > 0; --n_values) {
        rows_.next_row(2);
        take_site(of_nodes);
    }
    return true;
}

}  // namespace pcvt
