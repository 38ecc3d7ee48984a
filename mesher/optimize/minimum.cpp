#include "mesher/optimize/minimum.hpp"

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

}  // namespace pcvt
