#include "io/bytes/vtk_text.hpp"

namespace pcvt {

void open_vtk_array(std::string& text, const char* type, const char* name,
                    const std::string& attributes) {
    text += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"" + attributes +
            " format=\"ascii\">\n";
}

void close_vtk_array(std::string& text) { text += "</DataArray>\n"; }

void append_vtk_integers(std::string& text, const char* type, const char* name,
                         const std::vector<int>& values) {
    open_vtk_array(text, type, name);
    for (const int value : values) {
        append_vtk_word(text, value);
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

}  // namespace pcvt
