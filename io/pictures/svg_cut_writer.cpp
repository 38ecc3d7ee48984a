#include "io/pictures/svg_cut_writer.hpp"

#include <cmath>

#include "io/bytes/text.hpp"
#include "io/pictures/cut_lines.hpp"

namespace pcvt {
namespace {

/// In millimetres.
constexpr double kLineWidth = 0.1;

/// @param millimetres  a multiple of 1e-6 up to rounding, as all sums of cut_lines() are.
std::string number(double millimetres) {
    std::string text;
    append_number(text, std::round(1e6 * millimetres) / 1e6);
    return text;
}

/// Returns a layer as Inkscape shows it.
/// @param height  of the picture: y points down in SVG.
std::string layer(const std::vector<CutLine>& lines, double height, const std::string& name,
                  const std::string& colour) {
    std::string text = "<g id=\"" + name + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" +
                       name + "\" stroke=\"" + colour + "\">\n";
    for (const CutLine& line : lines) {
        text += "<path d=\"M" + number(line.from.x()) + ' ' + number(height - line.from.y()) + 'L' +
                number(line.to.x()) + ' ' + number(height - line.to.y()) + "\"/>\n";
    }
    return text + "</g>\n";
}

}  // namespace

std::vector<EncodedFile> encode_svg_cut(const plane::Tile& tile, double width,
                                        const std::string& path) {
    const CutLines lines = cut_lines(tile, width);
    const std::string x = number(lines.size.x());
    const std::string y = number(lines.size.y());
    std::string text =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"" +
        x + "mm\" height=\"" + y + "mm\" viewBox=\"0 0 " + x + ' ' + y +
        "\">\n<title>Lines to cut of a periodic tile</title>\n<g fill=\"none\" "
        "stroke-width=\"" +
        number(kLineWidth) + "\" stroke-linecap=\"round\">\n";
    text += layer(lines.inner, lines.size.y(), kInnerLayer, "#000000");
    text += layer(lines.seam, lines.size.y(), kSeamLayer, "#ff0000");
    return only_file(path, std::move(text += "</g>\n</svg>\n"));
}

}  // namespace pcvt
