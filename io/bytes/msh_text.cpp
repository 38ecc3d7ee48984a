#include "io/bytes/msh_text.hpp"

namespace pcvt {

void append_msh_name(std::string& text, int dimension, int group, const std::string& name) {
    append_msh_words(text, {dimension, group});
    text += '"' + name + "\"\n";
}

void append_msh_link(std::string& text, int dimension, int slave, int master,
                     const std::array<double, 3>& translation, std::size_t n_nodes) {
    append_msh_line(text, {dimension, slave, master});
    text += "16 ";
    for (std::size_t row = 0; row < 3; ++row) {
        std::array<double, 4> entries{0, 0, 0, translation[row]};
        entries[row] = 1;
        append_msh_words(text, {entries[0], entries[1], entries[2], entries[3]});
    }
    append_msh_line(text, {0, 0, 0, 1});
    append_msh_line(text, {static_cast<int>(n_nodes)});
}

void append_msh_data(std::string& text, const char* section, const char* view,
                     const std::vector<MshValue>& values) {
    text += std::string("$") + section + "\n1\n\"" + view + "\"\n1\n0\n3\n0\n1\n";
    append_msh_line(text, {static_cast<int>(values.size())});
    for (const auto& [number, value] : values) append_msh_line(text, {number, value});
    text += std::string("$End") + section + "\n";
}

}  // namespace pcvt
