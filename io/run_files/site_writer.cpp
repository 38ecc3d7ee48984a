#include "io/run_files/site_writer.hpp"

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

/// A number as long as -2.2250738585072014e-308, and the blank or the line end behind it.
constexpr std::size_t kLongestNumber = 25;

template <class Points>
std::string encode(std::string_view head, const Points& points) {
    // Memory that is reserved and not used costs nothing, in contrast to a text that is moved.
    std::string text;
    text.reserve(head.size() + kLongestNumber * static_cast<std::size_t>(points.size()));
    text += head;
    for (const auto& site : points.colwise()) {
        for (const double x : site) {
            append_number(text, x);
            text += ' ';
        }
        text.back() = '\n';
    }
    return text;
}

}  // namespace

std::string encode_sites(const Eigen::Matrix2Xd& points) {
    return encode("# Sites written by pcvt, \"x y\" a line\n", points);
}

std::string encode_sites(const Eigen::Matrix3Xd& points) {
    return encode("# Sites written by pcvt, \"x y z\" a line\n", points);
}

}  // namespace pcvt
