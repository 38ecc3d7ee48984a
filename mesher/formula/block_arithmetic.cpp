#include "mesher/formula/block_arithmetic.hpp"

#include "mesher/base/target_clones.hpp"
#include "mesher/formula/number_parts.hpp"

namespace pcvt {
namespace {

/// The largest whole number that is at most x + 1/2.
PCVT_IN_LANES double rounded(double x) {
    const double above = x + 0.5;
    const double near = nearest_whole_of_any(above);
    return near - (near > above ? 1.0 : 0.0);
}

}  // namespace

PCVT_TARGET_CLONES void block_add(const double* __restrict a, const double* __restrict b,
                                  double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] + b[k];
}

PCVT_TARGET_CLONES void block_subtract(const double* __restrict a, const double* __restrict b,
                                       double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] - b[k];
}

PCVT_TARGET_CLONES void block_multiply(const double* __restrict a, const double* __restrict b,
                                       double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] * b[k];
}

PCVT_TARGET_CLONES void block_divide(const double* __restrict a, const double* __restrict b,
                                     double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] / b[k];
}

PCVT_TARGET_CLONES void block_less(const double* __restrict a, const double* __restrict b,
                                   double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] < b[k] ? 1.0 : 0.0;
}

PCVT_TARGET_CLONES void block_less_or_equal(const double* __restrict a, const double* __restrict b,
                                            double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] <= b[k] ? 1.0 : 0.0;
}

PCVT_TARGET_CLONES void block_equal(const double* __restrict a, const double* __restrict b,
                                    double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] == b[k] ? 1.0 : 0.0;
}

PCVT_TARGET_CLONES void block_differ(const double* __restrict a, const double* __restrict b,
                                     double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] != b[k] ? 1.0 : 0.0;
}

PCVT_TARGET_CLONES void block_and(const double* __restrict a, const double* __restrict b,
                                  double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = ((a[k] != 0) & (b[k] != 0)) ? 1.0 : 0.0;
}

PCVT_TARGET_CLONES void block_or(const double* __restrict a, const double* __restrict b,
                                 double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = ((a[k] != 0) | (b[k] != 0)) ? 1.0 : 0.0;
}

PCVT_TARGET_CLONES void block_min(const double* __restrict a, const double* __restrict b,
                                  double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = b[k] < a[k] ? b[k] : a[k];
}

PCVT_TARGET_CLONES void block_max(const double* __restrict a, const double* __restrict b,
                                  double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] < b[k] ? b[k] : a[k];
}

PCVT_TARGET_CLONES void block_negative(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = -x[k];
}

PCVT_TARGET_CLONES void block_abs(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = x[k] >= 0 ? x[k] : -x[k];
}

PCVT_TARGET_CLONES void block_sign(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) {
        y[k] = (x[k] > 0 ? 1.0 : 0.0) - (x[k] < 0 ? 1.0 : 0.0);
    }
}

PCVT_TARGET_CLONES void block_round(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = rounded(x[k]);
}

PCVT_TARGET_CLONES void block_squared_difference(const double* __restrict a,
                                                 const double* __restrict b, double* __restrict y,
                                                 int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = (a[k] - b[k]) * (a[k] - b[k]);
}

PCVT_TARGET_CLONES void block_add_product(const double* __restrict a, const double* __restrict b,
                                          const double* __restrict c, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = c[k] + a[k] * b[k];
}

PCVT_TARGET_CLONES void block_add_squared_difference(const double* __restrict a,
                                                     const double* __restrict b,
                                                     const double* __restrict c,
                                                     double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = c[k] + (a[k] - b[k]) * (a[k] - b[k]);
}

PCVT_TARGET_CLONES void block_choose(const double* __restrict a, const double* __restrict b,
                                     const double* __restrict c, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = a[k] != 0 ? b[k] : c[k];
}

}  // namespace pcvt
