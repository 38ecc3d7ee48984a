#include "mesher/space/energy/energy_pass.hpp"

#include <optional>
#include <utility>

#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

/// Corrections for more tetrahedra than this share cost more than another pass.
constexpr double kMostCorrectedShare = 0.1;

}  // namespace

bool EnergyPass::evaluate(Energy& energy) {
    Suspects wrong = violations(energy);
    if (!wrong.empty() && !restore(std::move(wrong), energy)) {
        if (!moving_.rebuild()) return false;
        if (!violations(energy).empty()) {
            throw InternalError("a new build in space is not Delaunay");
        }
    }
    moving_.certify();
    return true;
}

Suspects EnergyPass::violations(Energy& energy) {
    return moving_.violations(
        sums_.run(moving_.tetrahedra(), moving_.coordinates(), moving_.frame(), workers_, energy));
}

bool EnergyPass::restore(Suspects wrong, Energy& energy) {
    std::optional<ExchangedTetrahedra> exchanged = moving_.restore(std::move(wrong));
    if (!exchanged) return false;
    return correct(std::move(*exchanged), energy) || violations(energy).empty();
}

bool EnergyPass::correct(ExchangedTetrahedra exchanged, Energy& energy) const {
    const bool pays =
        double(exchanged.added.size()) < kMostCorrectedShare * moving_.tetrahedra().n_tetrahedra();
    return pays && correct_for_exchange(std::move(exchanged), moving_.coordinates(),
                                        moving_.frame(), energy);
}

}  // namespace pcvt::space
