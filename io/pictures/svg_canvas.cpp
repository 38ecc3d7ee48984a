#include "io/pictures/svg_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace pcvt {
namespace {

constexpr double kCanvasMargin = 20;
constexpr double kTypicalSide = 800;
constexpr double kLongestSide = 1600;
/// The longest attribute. libxml2, which librsvg and others use, refuses about 10 MB.
constexpr std::size_t kLongestAttribute = 1 << 20;

/// The colours of text and lines on a dark background.
constexpr const char* kDarkRules =
    ".ink { fill: #e8eaef } .rule { stroke: #e8eaef } .grid { stroke: #343944 }";
/// White has more contrast than black on backgrounds of less luminance.
constexpr double kDark = 0.18;

/// The ratio of the widths of bold and of regular text.
constexpr double kBold = 1.12;

/// Returns a bound on the width of a character in ems, after DejaVu Sans; the first byte of a
/// character in UTF-8 counts for all of its bytes.
double character_width(char c) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) return 0;
    if (static_cast<unsigned char>(c) >= 0x80) return 0.9;
    if (std::string_view(" .,:;()|'!").find(c) != std::string_view::npos) return 0.41;
    if (std::string_view("mMwW%@").find(c) != std::string_view::npos) return 1;
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? 0.64 : 0.84;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return result;
}

}  // namespace

SvgFrame::SvgFrame(const std::vector<plane::Vec2>& points) {
    low_ = points.at(0);
    plane::Vec2 high = low_;
    for (const plane::Vec2& p : points) {
        low_ = low_.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double longest = (high - low_).maxCoeff();
    const double shortest = std::max((high - low_).minCoeff(), 1e-6 * longest);
    const double typical = std::sqrt(shortest) * std::sqrt(longest);
    scale_ = std::min(kTypicalSide / typical, kLongestSide / longest);
    size_ = (high - low_) * scale_ + plane::Vec2::Constant(2 * kCanvasMargin);
}

plane::Vec2 SvgFrame::pixel(const plane::Vec2& point) const {
    const plane::Vec2 from_low = (point - low_) * scale_;
    return {kCanvasMargin + from_low.x(), size_.y() - kCanvasMargin - from_low.y()};
}

void append_pixels(std::string& text, double value) {
    const std::int64_t thousandths = std::llround(1000 * value);
    const std::int64_t size = std::abs(thousandths);
    // Write from the last digit to the first, without zeros at the end of the decimals.
    std::array<char, 24> digits{};
    char* begin = digits.end();
    std::int64_t rest = size;
    for (int k = 0; k < 3; ++k, rest /= 10) {
        if (begin != digits.end() || rest % 10 != 0) *--begin = static_cast<char>('0' + rest % 10);
    }
    if (begin != digits.end()) *--begin = '.';
    do {
        *--begin = static_cast<char>('0' + rest % 10);
        rest /= 10;
    } while (rest > 0);
    if (thousandths < 0) *--begin = '-';
    text.append(begin, digits.end());
}

SvgPath& SvgPath::add(char command, const plane::Vec2& point) {
    const plane::Vec2 pixel = frame_.pixel(point);
    text_ += command;
    append_pixels(text_, pixel.x());
    text_ += ' ';
    append_pixels(text_, pixel.y());
    return *this;
}

SvgPath& SvgPath::close() {
    text_ += 'Z';
    return *this;
}

SvgPath& SvgPath::dot(const plane::Vec2& point) {
    move(point);
    text_ += "h0";
    return *this;
}

std::string SvgPath::element(const std::string& attributes) const {
    std::string svg;
    for (std::size_t begin = 0; begin < text_.size();) {
        const std::size_t end = std::min(text_.find('M', begin + kLongestAttribute), text_.size());
        svg.append("<path").append(attributes).append(" d=\"");
        svg.append(text_, begin, end - begin).append("\"/>\n");
        begin = end;
    }
    return svg;
}

std::string svg_attribute(const std::string& name, double pixels) {
    std::string text = " " + name + "=\"";
    append_pixels(text, pixels);
    return text + '"';
}

std::string svg_stroke(const std::string& colour, double width) {
    return " stroke=\"" + colour + "\"" + svg_attribute("stroke-width", width);
}

std::string svg_head(const std::string& title, double width, double height,
                     const std::optional<Colour>& background) {
    const std::string size = svg_attribute("width", width) + svg_attribute("height", height);
    std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg")" + size + " viewBox=\"0 0 ";
    append_pixels(text, width);
    text += ' ';
    append_pixels(text, height);
    text += "\">\n<title>" + escaped(title) + "</title>\n";
    if (!background) {
        return text + "<style>@media (prefers-color-scheme: dark) { " + kDarkRules + " }</style>\n";
    }
    if (luminance(*background) < kDark) text += "<style>" + std::string(kDarkRules) + "</style>\n";
    return text + "<rect" + size + " fill=\"" + hex(*background) + "\"/>\n";
}

std::string svg_text_group() {
    return std::string("<g") + kSvgTextClass + R"( font-family="sans-serif")" +
           svg_attribute("font-size", kSvgFontSize) + " fill=\"" + kSvgInk + "\">\n";
}

std::string svg_text(const plane::Vec2& place, const std::string& text,
                     const std::string& attributes) {
    return "<text" + svg_attribute("x", place.x()) + svg_attribute("y", place.y()) + attributes +
           ">" + escaped(text) + "</text>\n";
}

double svg_text_width(const std::string& text, double font_size) {
    double ems = 0;
    for (const char c : text) ems += character_width(c);
    return font_size * ems;
}

double svg_bold_text_width(const std::string& text, double font_size) {
    return kBold * svg_text_width(text, font_size);
}

}  // namespace pcvt
