#include "plugin/checks/tolerance_check.hpp"

#include <cmath>

#include "io/bytes/readable_number.hpp"
#include "io/bytes/text.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt::checks {
namespace {

/// Each proof with a wider tolerance may show edges that fit less well.
constexpr int kMostProofs = 4;

/// A number of two digits that is a little larger, so that rounding does not count.
double rounded_up(double number) {
    const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
    return parse_number(figure(std::ceil(number * 1.01 / unit) * unit));
}

}  // namespace

std::string tolerance_advice(const SeamMismatch& fault, const SeamProof& prove) {
    double mismatch = fault.mismatch();
    double tolerance = 0;
    for (int k = 0; k < kMostProofs && std::isfinite(mismatch) && mismatch > tolerance; ++k) {
        tolerance = rounded_up(mismatch);
        try {
            const double found = prove(tolerance);
            return "; the tile is periodic within " + in_words(found) + ", so --tolerance " +
                   figure(tolerance) + " accepts it";
        } catch (const SeamMismatch& next) {
            mismatch = next.mismatch();
        } catch (const InvalidInput&) {
            // The file has another fault, too.
            break;
        }
    }
    return "";
}

}  // namespace pcvt::checks
