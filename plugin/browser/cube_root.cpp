// cbrt() with the bits of glibc, from its file sysdeps/ieee754/dbl-64/s_cbrt.c (LGPL-2.1-or-later):
// emscripten's own one rounds about half of all results to another double.
#include <cmath>

extern "C" double cbrt(double x) {
    constexpr double kRoot = 1.2599210498948731648;        // of 2
    constexpr double kSquareRoot = 1.5874010519681994748;  // of 4
    constexpr double kFactors[] = {1 / kSquareRoot, 1 / kRoot, 1, kRoot, kSquareRoot};
    if (x == 0 || !std::isfinite(x)) return x + x;
    int exponent = 0;
    const double m = std::frexp(std::fabs(x), &exponent);
    double u = 0.784932344976639262 - 0.145263899385486367 * m;
    u = 1.83469277483613086 - u * m;
    u = 2.44693122563534430 - u * m;
    u = 2.11499494167371287 - u * m;
    u = 1.50819193781584896 - u * m;
    u = 0.354895765043919860 + u * m;
    const double cube = u * u * u;
    const double y = u * (cube + 2 * m) / (2 * cube + m) * kFactors[2 + exponent % 3];
    return std::ldexp(x > 0 ? y : -y, exponent / 3);
}
