#include "mesher/cells/area_law.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "mesher/base/error.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

struct LawRow {
    LawComponent::Kind kind;
    std::string_view word;
    bool has_spread;
};

constexpr std::array kLaws{LawRow{LawComponent::Kind::kEqual, "equal", false},
                           LawRow{LawComponent::Kind::kLognormal, "lognormal", true},
                           LawRow{LawComponent::Kind::kGamma, "gamma", true}};

/// The row whose word the text begins with, up to ':' or, within a mixture, '@' or a blank.
const LawRow* find_law(std::string_view text, std::string_view ends) {
    const std::string_view word = text.substr(0, text.find_first_of(ends));
    for (const LawRow& row : kLaws) {
        if (row.word == word) return &row;
    }
    return nullptr;
}

std::string_view without_blanks(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// Reads the parts of a mixture from left to right.
class MixtureReader {
   public:
    explicit MixtureReader(const std::string& text) : text_(text), rest_(text) {}

    AreaLaw read() {
        AreaLaw law{.components = {}};
        do {
            law.components.push_back(component());
        } while (takes('+'));
        if (!rest_.empty()) refuse_form();
        scale_shares(law);
        return law;
    }

   private:
    [[noreturn]] void refuse(const std::string& fault) const {
        throw InvalidInput("'" + text_ + "': " + fault);
    }
    [[noreturn]] void refuse_form() const {
        refuse(
            "a mixture of laws of sizes is SHARE*LAW@MEAN+SHARE*LAW@MEAN, such as "
            "0.7*lognormal:0.3@1+0.3*gamma:0.2@3");
    }

    /// Skips blanks and the character, if it follows.
    bool takes(char sign) {
        rest_ = without_blanks(rest_);
        if (rest_.empty() || rest_.front() != sign) return false;
        rest_.remove_prefix(1);
        return true;
    }
    void require(char sign) {
        if (!takes(sign)) refuse_form();
    }
    double number() {
        rest_ = without_blanks(rest_);
        double value = 0;
        const auto [end, error] = read_decimal(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) refuse_form();
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    LawComponent component() {
        LawComponent law{.share = number()};
        if (!(law.share > 0)) refuse("a share in a mixture of laws of sizes is not above 0");
        require('*');
        rest_ = without_blanks(rest_);
        const LawRow* const row = find_law(rest_, ":@ ");
        if (row == nullptr) refuse_form();
        rest_.remove_prefix(row->word.size());
        law.kind = row->kind;
        if (row->has_spread) {
            require(':');
            law.spread = number();
            if (!(law.spread > 0 && law.spread <= kMostSpread)) {
                refuse("the spread of a law of sizes is not above 0 and at most 2");
            }
        }
        require('@');
        law.mean = number();
        if (!(law.mean >= 1 / kMostMeanDiameter && law.mean <= kMostMeanDiameter)) {
            refuse("the mean diameter of a law of sizes is not between 1e-9 and 1e9");
        }
        return law;
    }

    void scale_shares(AreaLaw& law) const {
        double sum = 0;
        for (const LawComponent& component : law.components) sum += component.share;
        if (!(std::abs(sum - 1) <= kShareRounding)) {
            std::array<char, 32> digits{};
            char* const end = write_decimal(digits.data(), digits.data() + digits.size(), sum,
                                            std::chars_format::general, 4);
            refuse("the shares of the laws of sizes sum to " + std::string(digits.data(), end) +
                   "; make it 1");
        }
        for (LawComponent& component : law.components) component.share /= sum;
    }

    const std::string& text_;
    std::string_view rest_;
};

/// Whether a law follows the first sign `*`, or a number precedes it.
bool names_mixture(std::string_view text) {
    const std::size_t times = text.find('*');
    if (times == std::string_view::npos) return false;
    if (find_law(without_blanks(text.substr(times + 1)), ":@+ ") != nullptr) return true;
    double share = 0;
    const auto [end, error] = read_decimal(text.data(), text.data() + times, share);
    return error == std::errc{} &&
           without_blanks({end, times - static_cast<std::size_t>(end - text.data())}).empty();
}

}  // namespace

bool names_area_law(const std::string& text) {
    return find_law(text, ":@+") != nullptr || names_mixture(text);
}

AreaLaw parse_area_law(const std::string& text) {
    if (names_mixture(text)) return MixtureReader(text).read();
    const LawRow* const row = find_law(text, ":");
    if (row == nullptr) {
        throw InvalidInput("'" + text +
                           "' is not a law of sizes; choose equal, lognormal:S, gamma:S or a "
                           "mixture such as 0.7*lognormal:0.3@1+0.3*gamma:0.2@3");
    }
    LawComponent law{.kind = row->kind};
    const std::size_t colon = text.find(':');
    if (!row->has_spread) {
        if (colon == std::string::npos) return {{law}};
        throw InvalidInput("'" + text + "': equal sizes have no spread; write 'equal'");
    }
    const char* const end = text.data() + text.size();
    const char* const begin = colon == std::string::npos ? end : text.data() + colon + 1;
    const auto [stop, error] = read_decimal(begin, end, law.spread);
    if (error == std::errc{} && stop == end && law.spread > 0 && law.spread <= kMostSpread) {
        return {{law}};
    }
    throw InvalidInput("'" + text + "': write '" + std::string(row->word) +
                       ":S' as a law of sizes, where S, the standard deviation of the diameters "
                       "over their mean, is above 0 and at most 2");
}

}  // namespace pcvt
