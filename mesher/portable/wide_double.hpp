#pragma once

namespace pcvt {

/// A number of twice the digits of a double: the sum of two doubles, with a relative error below
/// 1e-30 for one operation on numbers between 1e-150 and 1e150. It takes the place of `long
/// double`, whose digits differ between machines (T. J. Dekker, Numerische Mathematik 18, 1971).
/// Eigen's vectors and matrices may consist of it.
///
/// Example usage (1e-20, which doubles lose):
///
///     const WideDouble one = 1;
///     const double rest = double((one + 1e-20) - one);
class WideDouble {
   public:
    WideDouble(double value = 0) : high_(value) {}
    explicit operator double() const { return high_; }

    WideDouble operator-() const { return {-high_, -low_}; }
    friend WideDouble operator+(const WideDouble& x, const WideDouble& y) {
        const double sum = x.high_ + y.high_;
        const double part = sum - x.high_;
        const double error = (x.high_ - (sum - part)) + (y.high_ - part);
        return near(sum, error + (x.low_ + y.low_));
    }
    friend WideDouble operator-(const WideDouble& x, const WideDouble& y) { return x + -y; }
    friend WideDouble operator*(const WideDouble& x, const WideDouble& y) {
        const double product = x.high_ * y.high_;
        const auto [p, q] = halves(x.high_);
        const auto [r, s] = halves(y.high_);
        const double error = ((p * r - product) + p * s + q * r) + q * s;
        return near(product, error + (x.high_ * y.low_ + x.low_ * y.high_));
    }
    friend WideDouble operator/(const WideDouble& x, const WideDouble& y) {
        const double quotient = x.high_ / y.high_;
        const WideDouble rest = x - y * quotient;
        return near(quotient, rest.high_ / y.high_);
    }
    WideDouble& operator+=(const WideDouble& x) { return *this = *this + x; }
    WideDouble& operator-=(const WideDouble& x) { return *this = *this - x; }
    WideDouble& operator*=(const WideDouble& x) { return *this = *this * x; }
    WideDouble& operator/=(const WideDouble& x) { return *this = *this / x; }

   private:
    WideDouble(double high, double low) : high_(high), low_(low) {}

    /// @pre |small| <= |large|, up to a few bits.
    static WideDouble near(double large, double small) {
        const double sum = large + small;
        return {sum, small - (sum - large)};
    }
    struct Halves {
        double upper;
        double lower;
    };
    /// Two numbers of 26 bits, whose products are exact.
    static Halves halves(double x) {
        const double shifted = 0x1.0000002p27 * x;
        const double upper = shifted - (shifted - x);
        return {upper, x - upper};
    }

    double high_;
    double low_ = 0;
};

}  // namespace pcvt
