#include "tests/support/mutation.hpp"

#include <algorithm>
#include <array>

namespace pcvt::testing {
namespace {

constexpr std::array<const char*, 12> kExtremes{
    "-1",  "0",    "2147483647", "-2147483648", "99999999999", "18446744073709551615", "1e999",
    "nan", "-0.0", "",           "1e-320",      "\n"};

std::size_t below(std::size_t n, std::mt19937_64& random) { return n == 0 ? 0 : random() % n; }

void exchange_word(std::string& bytes, std::mt19937_64& random) {
    const std::size_t at = below(bytes.size(), random);
    const std::size_t begin = std::min(bytes.find_first_of("0123456789", at), bytes.size());
    const std::size_t end = std::min(bytes.find_first_not_of("0123456789", begin), bytes.size());
    bytes.replace(begin, end - begin, kExtremes[below(kExtremes.size(), random)]);
}

void mutate_once(std::string& bytes, std::mt19937_64& random) {
    const std::size_t at = below(bytes.size(), random);
    const std::size_t length = below(1 + bytes.size() / 8, random);
    switch (random() % 4) {
        case 0:
            if (!bytes.empty()) bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes.erase(at, length);
            break;
        case 2:
            bytes.insert(at, bytes.substr(below(bytes.size(), random), length));
            break;
        default:
            exchange_word(bytes, random);
    }
}

}  // namespace

std::string mutated(std::string bytes, std::mt19937_64& random) {
    const std::size_t faults = 1 + random() % 4;
    for (std::size_t k = 0; k < faults; ++k) mutate_once(bytes, random);
    return bytes;
}

}  // namespace pcvt::testing
