#include "io/run_files/site_writer.hpp"

#include "io/bytes/text.hpp"

namespace pcvt {

std::string encode_sites(const Points& points) {
    std::string text = "# Sites written by pcvt, \"x y\" a line\n";
    for (const auto& site : points.colwise()) {
        append_number(text, site.x());
        text += ' ';
        append_number(text, site.y());
        text += '\n';
    }
    return text;
}

}  // namespace pcvt
