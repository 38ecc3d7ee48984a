#include "mesher/base/error.hpp"

#include <string_view>
#include <utility>

namespace pcvt {
namespace {

constexpr std::string_view kBlanks = "\t\n\v\f\r";

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < ' ' || byte == 0x7F;
}

std::string printable_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    for (char& c : text) {
        if (is_control(c)) c = kBlanks.find(c) == std::string_view::npos ? '?' : ' ';
    }
    return text;
}

}  // namespace

Error::Error(std::string what) : std::runtime_error(printable_line(std::move(what))) {}

}  // namespace pcvt
