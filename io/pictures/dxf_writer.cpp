#include "io/pictures/dxf_writer.hpp"

#include "io/bytes/text.hpp"
#include "io/pictures/cut_lines.hpp"

namespace pcvt {
namespace {

/// Numbers of DXF colours: black or white by the background, and red.
constexpr int kInnerColour = 7;
constexpr int kSeamColour = 1;

/// Appends a group: its code and its value, a line each.
void append_group(std::string& text, int code, const std::string& value) {
    append_number(text, code);
    text += '\n' + value + '\n';
}

void append_group(std::string& text, int code, double value) {
    append_number(text, code);
    text += '\n';
    append_number(text, value);
    text += '\n';
}

void append_point(std::string& text, int first_code, const plane::Vec2& point) {
    append_group(text, first_code, point.x());
    append_group(text, first_code + 10, point.y());
    append_group(text, first_code + 20, 0.0);
}

void append_header(std::string& text, const plane::Vec2& size) {
    text += "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$EXTMIN\n";
    append_point(text, 10, plane::Vec2::Zero());
    text += "9\n$EXTMAX\n";
    append_point(text, 10, size);
    text += "0\nENDSEC\n";
}

void append_layer(std::string& text, const char* name, int colour) {
    text += "0\nLAYER\n";
    append_group(text, 2, std::string(name));
    append_group(text, 70, std::string("0"));
    append_group(text, 62, std::to_string(colour));
    append_group(text, 6, std::string("CONTINUOUS"));
}

void append_tables(std::string& text) {
    text +=
        "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLTYPE\n70\n1\n0\nLTYPE\n2\nCONTINUOUS\n70\n0\n"
        "3\nSolid line\n72\n65\n73\n0\n40\n0\n0\nENDTAB\n0\nTABLE\n2\nLAYER\n70\n2\n";
    append_layer(text, kInnerLayer, kInnerColour);
    append_layer(text, kSeamLayer, kSeamColour);
    text += "0\nENDTAB\n0\nENDSEC\n";
}

void append_lines(std::string& text, const std::vector<CutLine>& lines, const char* layer) {
    for (const CutLine& line : lines) {
        text += "0\nLINE\n";
        append_group(text, 8, std::string(layer));
        append_point(text, 10, line.from);
        append_point(text, 11, line.to);
    }
}

}  // namespace

std::vector<EncodedFile> encode_dxf(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    const CutLines lines = cut_lines(tile, options.cut_width);
    std::string text = "999\nA periodic tile, written by pcvt\n";
    append_header(text, lines.size);
    append_tables(text);
    text += "0\nSECTION\n2\nENTITIES\n";
    append_lines(text, lines.inner, kInnerLayer);
    append_lines(text, lines.seam, kSeamLayer);
    return only_file(path, std::move(text += "0\nENDSEC\n0\nEOF\n"));
}

}  // namespace pcvt
