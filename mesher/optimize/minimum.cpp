#include "mesher/optimize/minimum.hpp"

#include <numbers>

#include "mesher/portable/portable_angles.hpp"

namespace pcvt {

const char* minimum_name(Minimum minimum) {
    switch (minimum) {
        case Minimum::kYes:
            return "yes";
        case Minimum::kNo:
            return "no";
        case Minimum::kUnknown:
            return "unknown";
    }
    return "";
}

LatticeStability decided_stability(double smallest, double largest) {
    const double ratio = smallest / largest;
    const Minimum minimum = ratio > kCertainEigenvalue    ? Minimum::kYes
                            : ratio < -kCertainEigenvalue ? Minimum::kNo
                                                          : Minimum::kUnknown;
    return {minimum, ratio};
}

double one_minus_cosine(std::int64_t k, int n) {
    const double sine = portable_sin(std::numbers::pi * static_cast<double>(k % n) / n);
    return 2 * sine * sine;
}

}  // namespace pcvt
