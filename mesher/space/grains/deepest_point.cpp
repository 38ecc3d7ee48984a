#include "mesher/space/grains/deepest_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcvt::space {
namespace {

/// Coefficients below this part of the largest one are rounding.
constexpr double kRounding = 1e-14;

/// A linear program in D variables with absolute values of at most 1.
template <int D>
struct Program {
    using Point = std::array<double, D>;
    /// normal . x <= height.
    struct Row {
        Point normal;
        double height;
    };
    std::vector<Row> rows = {};
    /// Its product with x shall be large.
    Point objective = {};
};

template <std::size_t D>
double product(const std::array<double, D>& a, const std::array<double, D>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < D; ++k) sum += a[k] * b[k];
    return sum;
}

double solve_line(const Program<1>& program) {
    double low = -1;
    double high = 1;
    for (const auto& [normal, height] : program.rows) {
        if (normal[0] > kRounding) high = std::min(high, height / normal[0]);
        if (normal[0] < -kRounding) low = std::max(low, height / normal[0]);
    }
    // Where rounding leaves nothing, both are the same.
    return program.objective[0] > 0 ? high : low;
}

/// The program on the plane of row n, with the rows before it, without the variable of the largest
/// coefficient.
template <int D>
class OnPlane {
   public:
    OnPlane(const Program<D>& program, std::size_t n) : row_(program.rows[n]) {
        for (int k = 1; k < D; ++k) {
            if (std::abs(row_.normal[k]) > std::abs(row_.normal[gone_])) gone_ = k;
        }
        left.objective = reduced(program.objective);
        for (std::size_t k = 0; k < n; ++k) add(program.rows[k]);
        for (const double sign : {1.0, -1.0}) {
            typename Program<D>::Row bound{{}, 1};
            bound.normal[gone_] = sign;
            add(bound);
        }
    }

    typename Program<D>::Point whole(const typename Program<D - 1>::Point& x) const {
        typename Program<D>::Point all{};
        double sum = row_.height;
        for (int k = 0, from = 0; k < D; ++k) {
            if (k == gone_) continue;
            all[k] = x[from++];
            sum -= row_.normal[k] * all[k];
        }
        all[gone_] = sum / row_.normal[gone_];
        return all;
    }

    Program<D - 1> left = {};

   private:
    typename Program<D - 1>::Point reduced(const typename Program<D>::Point& normal) const {
        typename Program<D - 1>::Point other{};
        for (int k = 0, to = 0; k < D; ++k) {
            if (k == gone_) continue;
            other[to++] = normal[k] - normal[gone_] / row_.normal[gone_] * row_.normal[k];
        }
        return other;
    }
    void add(const typename Program<D>::Row& row) {
        const double factor = row.normal[gone_] / row_.normal[gone_];
        left.rows.push_back({reduced(row.normal), row.height - factor * row_.height});
    }

    const typename Program<D>::Row row_;
    int gone_ = 0;
};

template <int D>
typename Program<D>::Point solve(const Program<D>& program) {
    if constexpr (D == 1) {
        return {solve_line(program)};
    } else {
        typename Program<D>::Point x{};
        for (int k = 0; k < D; ++k) x[k] = program.objective[k] < 0 ? -1 : 1;
        for (std::size_t n = 0; n < program.rows.size(); ++n) {
            const auto& [normal, height] = program.rows[n];
            if (product(normal, x) <= height) continue;
            const double largest =
                std::abs(*std::max_element(normal.begin(), normal.end(), [](double a, double b) {
                    return std::abs(a) < std::abs(b);
                }));
            if (largest <= kRounding) continue;
            const OnPlane<D> plane(program, n);
            x = plane.whole(solve(plane.left));
        }
        return x;
    }
}

/// Mixes rows, always in the same way: the cost is proportional to their number for most orders.
template <class Row>
void mix(std::vector<Row>& rows) {
    std::uint64_t state = 1;
    for (std::size_t k = rows.size(); k > 1; --k) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        std::swap(rows[k - 1], rows[(state >> 33) % k]);
    }
}

}  // namespace

Vec3 deepest_point(const std::vector<HalfSpace>& half_spaces, const Vec3& near, double extent) {
    Program<4> program{.objective = {0, 0, 0, 1}};
    for (const auto& [normal, height] : half_spaces) {
        const double above = normal.x() * near.x() + normal.y() * near.y() + normal.z() * near.z();
        program.rows.push_back(
            {{normal.x(), normal.y(), normal.z(), 1}, (height - above) / extent});
    }
    mix(program.rows);
    const std::array<double, 4> x = solve(program);
    return near + extent * Vec3(x[0], x[1], x[2]);
}

}  // namespace pcvt::space
