#pragma once

namespace pcvt {

// Functions of angles from only additions, multiplications, divisions and square roots, which IEEE
// 754 rounds correctly: the same bits on every machine, unlike those of the system's library.
//
// Example usage:
//
//     const CosSin phi = cos_sin_of_degrees(45);

struct CosSin {
    double cos;
    double sin;
};

/// The absolute error of both is below 3e-16; at multiples of 90 degrees it is zero.
/// @param degrees  finite.
CosSin cos_sin_of_degrees(double degrees);

/// The angle with the cosine 1 - 2 u, degrees; the relative error is below 1e-15.
/// @param u  in (0, 1).
double degrees_of_cosine(double u);

/// The absolute error of both is below 4e-16 for |radians| <= 1e5. Beyond, it grows as that of a
/// turn of 2 pi in double precision.
CosSin cos_sin(double radians);
double portable_sin(double radians);
double portable_cos(double radians);
double portable_tan(double radians);

// Inverse functions, radians; the error is below 1e-15 times the larger of 1 and the value. Values
// out of the domain give NaN.
double portable_acos(double cosine);
/// The angle of (x, y) in [-pi, pi].
double portable_atan2(double y, double x);

}  // namespace pcvt
