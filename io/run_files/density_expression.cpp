#include "io/run_files/density_expression.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "io/run_files/formula.hpp"

namespace pcvt {
namespace {

const std::vector<std::string>& density_variables() {
    static const std::vector<std::string> names{"x", "y", "u", "v"};
    return names;
}
/// The coordinates in the order of these names.
constexpr double plane::DensityPoint::*kCoordinates[] = {
    &plane::DensityPoint::x, &plane::DensityPoint::y, &plane::DensityPoint::u,
    &plane::DensityPoint::v};

/// A formula for one thread.
class ExpressionDensity {
   public:
    explicit ExpressionDensity(const FormulaProgram& program)
        : evaluate_(program),
          uses_{program.uses(0), program.uses(1), program.uses(2), program.uses(3)} {}

    /// The coordinates by columns: x and y, unless the formula only uses u and v.
    static std::array<bool, 4> columns_of(const FormulaProgram& program) {
        const bool has_uv = program.uses(2) || program.uses(3);
        const bool has_xy = program.uses(0) || program.uses(1) || !has_uv;
        return {has_xy, has_xy, has_uv, has_uv};
    }

    void operator()(std::span<const plane::DensityPoint> points, std::span<double> rho) {
        const auto block = static_cast<std::size_t>(evaluate_.block());
        for (std::size_t from = 0; from < points.size(); from += block) {
            const std::size_t n = std::min(points.size() - from, block);
            const plane::DensityPoint* const here = points.data() + from;
            for (int k = 0; k < 4; ++k) {
                if (!uses_[static_cast<std::size_t>(k)]) continue;
                double* const variable = evaluate_.variable(k);
                for (std::size_t i = 0; i < n; ++i) variable[i] = here[i].*kCoordinates[k];
            }
            std::copy_n(evaluate_(static_cast<int>(n)), n, rho.data() + from);
        }
    }
    void operator()(const plane::PointColumns& points, double* rho) {
        evaluate_(points.coordinate.data(), rho, points.n);
    }

   private:
    FormulaEvaluator evaluate_;
    std::array<bool, 4> uses_;
};

}  // namespace

plane::Density expression_density(const std::string& expression) {
    return {[program = read_formula(expression, density_variables())]() -> plane::DensityFunction {
        return {ExpressionDensity(program), ExpressionDensity(program),
                ExpressionDensity::columns_of(program)};
    }};
}

}  // namespace pcvt
