#include "mesher/base/error.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace pcvt {
namespace {

constexpr std::size_t kMostListed = 1000;

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

std::string duplicates_text(const std::vector<CoincidentSite>& pairs) {
    const auto& [site, earlier] = pairs.front();
    if (pairs.size() == 1) {
        return "sites " + std::to_string(earlier) + " and " + std::to_string(site) +
               " coincide modulo the lattice; remove one";
    }
    return std::to_string(pairs.size()) + " sites coincide with earlier ones modulo the lattice: " +
           coincidence_list(pairs, [](int s) { return "site " + std::to_string(s); }) +
           "; remove them";
}

}  // namespace

std::string coincidence_list(const std::vector<CoincidentSite>& pairs,
                             const std::function<std::string(int)>& name) {
    std::string text;
    for (std::size_t k = 0; k < std::min(pairs.size(), kMostListed); ++k) {
        text += (k == 0 ? "" : ", ") + name(pairs[k].site) + " with " + name(pairs[k].earlier);
    }
    if (pairs.size() <= kMostListed) return text;
    return text + " and " + std::to_string(pairs.size() - kMostListed) + " more";
}

DuplicateSites::DuplicateSites(std::vector<CoincidentSite> pairs)
    : InvalidInput(duplicates_text(pairs)), pairs_(std::move(pairs)) {}

Error::Error(std::string what) : std::runtime_error(printable_line(std::move(what))) {}

}  // namespace pcvt
