#include "io/run_files/density_expression.hpp"

#include <algorithm>
#include <utility>
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
    explicit ExpressionDensity(const FormulaProgram& program) : evaluate_(program) {
        for (int k = 0; k < program.n_variables(); ++k) {
            if (program.uses(k)) used_.push_back(k);
        }
    }

    void operator()(std::span<const plane::DensityPoint> points, std::span<double> rho) {
        const auto block = static_cast<std::size_t>(evaluate_.block());
        for (std::size_t from = 0; from < points.size(); from += block) {
            const std::size_t n = std::min(points.size() - from, block);
            const plane::DensityPoint* const here = points.data() + from;
            for (const int k : used_) {
                double* const variable = evaluate_.variable(k);
                for (std::size_t i = 0; i < n; ++i) variable[i] = here[i].*kCoordinates[k];
            }
            std::copy_n(evaluate_(static_cast<int>(n)), n, rho.data() + from);
        }
    }

   private:
    FormulaEvaluator evaluate_;
    /// The variables of the formula.
    std::vector<int> used_;
};

}  // namespace

plane::Density expression_density(const std::string& expression) {
    return {[program = read_formula(expression, density_variables())]() -> plane::DensityFunction {
        return ExpressionDensity(program);
    }};
}

}  // namespace pcvt
