#include "io/run_files/site_writer.hpp"

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kHead = "# Sites written by pcvt, \"x y\" a line\n";
/// Two numbers as long as -2.2250738585072014e-308, a blank and the end of the line.
constexpr std::size_t kLongestLine = 50;

}  // namespace

std::string encode_sites(const Points& points) {
    // Memory that is reserved and not used costs nothing, in contrast to a text that is moved.
    std::string text;
    text.reserve(kHead.size() + kLongestLine * static_cast<std::size_t>(points.cols()));
    text += kHead;
    for (const auto& site : points.colwise()) {
        append_number(text, site.x());
        text += ' ';
        append_number(text, site.y());
        text += '\n';
    }
    return text;
}

}  // namespace pcvt
