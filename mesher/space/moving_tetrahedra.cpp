#include "mesher/space/moving_tetrahedra.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/tetrahedra_untangling.hpp"
#include "mesher/space_base/hilbert_curve.hpp"

namespace pcvt {
namespace {

/// A local repair that moves back more sites than this share, and more than this number, costs more
/// than a new build.
constexpr double kMostHeldShare = 0.2;
constexpr std::size_t kMostHeldAtLeast = 16;

/// Corrections for more tetrahedra than this share cost more than another pass.
constexpr double kMostCorrectedShare = 0.1;

/// After flips of this share of the tetrahedra, most of them lie far from their neighbours in
/// memory.
constexpr double kFlipsUntilSorting = 0.1;

double unit_near(double length) {
    int exponent = 0;
    std::frexp(length, &exponent);
    return std::ldexp(1.0, exponent);
}

Points3 in_order(const Points3& coordinates, const std::vector<SiteId>& order) {
    Points3 ordered(3, coordinates.cols());
    for (Eigen::Index s = 0; s < coordinates.cols(); ++s)
        ordered.col(s) = coordinates.col(order[s]);
    return ordered;
}

bool is_empty(const SpaceSuspects& suspects) {
    return suspects.tetrahedra.empty() && suspects.facets.empty();
}

}  // namespace

MovingTetrahedra::MovingTetrahedra(const SpaceSites& sites)
    : lattice_(sites.lattice()),
      reduction_(sites.reduction()),
      gram_(gram_of(reduction_.reduced)),
      unit_(unit_near(sites.spacing())),
      spacing_(sites.spacing() / unit_),
      frame_(reduction_.reduced, unit_),
      order_(hilbert_order(sites.coordinates())),
      coordinates_(in_order(sites.coordinates(), order_)),
      tetrahedra_(space_tetrahedra(wrapped_sites())) {}

bool MovingTetrahedra::step(const Eigen::VectorXf& direction, double t) {
    constexpr double kFarthest = 2;
    Points3 moved(3, n_sites());
    bool valid = true;
    for (SiteId s = 0; s < n_sites(); ++s) {
        checkpoint_each(s);
        const auto d = direction.segment<3>(kNumbersPerSite * Eigen::Index{s}).cast<double>();
        const Vec3 move = frame_.to_lattice(t * d);
        valid = valid && move.cwiseAbs().maxCoeff() <= kFarthest;
        moved.col(s) = coordinates_.col(s) + snapped_displacement(move);
    }
    if (!valid) return false;
    before_ = std::move(coordinates_);
    coordinates_ = std::move(moved);
    settled_ = false;
    keep_in_range();
    return true;
}

void MovingTetrahedra::step_back() {
    coordinates_ = std::move(before_);
    settled_ = true;
    keep_in_range();
}

void MovingTetrahedra::keep_in_range() {
    std::vector<Offset3> change(static_cast<std::size_t>(n_sites()));
    bool changes = false;
    for (SiteId s = 0; s < n_sites(); ++s) {
        const Vec3 whole = coordinates_.col(s).array().floor();
        if (whole.minCoeff() >= -1 && whole.maxCoeff() <= 1) continue;
        coordinates_.col(s) -= whole;
        if (!settled_) before_.col(s) -= whole;
        if (valid_.cols() > 0) valid_.col(s) -= whole;
        change[s] = {int(whole.x()), int(whole.y()), int(whole.z())};
        changes = true;
    }
    if (changes) tetrahedra_.add_to_offsets(change);
}

bool MovingTetrahedra::evaluate(Workers& workers, SpaceEnergy& energy) {
    const auto find_violations = [&] {
        return violations(pass_.run(tetrahedra_, coordinates_, frame_, workers, energy));
    };
    SpaceSuspects wrong = find_violations();
    if (!is_empty(wrong)) {
        const Restored restored = restore(std::move(wrong), energy);
        const bool certified =
            restored == Restored::kEnergy ||
            (restored == Restored::kTriangulation && is_empty(find_violations()));
        if (!certified) {
            valid_.resize(3, 0);
            if (!rebuild()) return false;
            if (!is_empty(find_violations())) {
                throw InternalError("a new build in space is not Delaunay");
            }
        }
        keep_sorted();
    }
    valid_ = coordinates_;
    return true;
}

void MovingTetrahedra::keep_sorted() {
    const auto limit = static_cast<std::int64_t>(kFlipsUntilSorting * tetrahedra_.n_tetrahedra());
    if (n_flips_ - n_flips_sorted_ <= limit) return;
    tetrahedra_.sort();
    n_flips_sorted_ = n_flips_;
}

SpaceSuspects MovingTetrahedra::violations(SpaceSuspects suspects) const {
    std::erase_if(suspects.tetrahedra,
                  [this](int t) { return is_positive(tetrahedra_, coordinates_, t); });
    // The test of a facet needs positive tetrahedra.
    if (!suspects.tetrahedra.empty()) return suspects;
    std::erase_if(suspects.facets, [this](int f) {
        return is_locally_delaunay(tetrahedra_, coordinates_, gram_, f);
    });
    return suspects;
}

MovingTetrahedra::Restored MovingTetrahedra::restore(SpaceSuspects wrong, SpaceEnergy& energy) {
    if (wrong.tetrahedra.empty()) return restore_by_flips(wrong.facets, energy);
    const bool done = untangle(wrong.tetrahedra, std::move(wrong.facets));
    return done ? Restored::kTriangulation : Restored::kNothing;
}

/// The flips test all facets of the tetrahedra that they add, and the pass certified the others.
MovingTetrahedra::Restored MovingTetrahedra::restore_by_flips(const std::vector<int>& facets,
                                                              SpaceEnergy& energy) {
    TetrahedraFlips flips(tetrahedra_, coordinates_, gram_);
    const bool done = flips.flip(facets);
    n_flips_ += flips.n_flips();
    if (!done) return Restored::kNothing;
    ExchangedTetrahedra exchanged = flips.take_exchanged();
    const bool pays =
        double(exchanged.added.size()) < kMostCorrectedShare * tetrahedra_.n_tetrahedra();
    return pays && correct_space_energy(std::move(exchanged), coordinates_, frame_, energy)
               ? Restored::kEnergy
               : Restored::kTriangulation;
}

bool MovingTetrahedra::untangle(const std::vector<int>& inverted, std::vector<int> facets) {
    if (valid_.cols() == 0) return false;
    const auto share = static_cast<std::size_t>(kMostHeldShare * n_sites());
    TetrahedraUntangling untangling(tetrahedra_, valid_, coordinates_, gram_);
    const bool done =
        untangling.run(inverted, std::move(facets), std::max(share, kMostHeldAtLeast));
    n_flips_ += untangling.n_flips();
    return done;
}

bool MovingTetrahedra::rebuild() {
    const SpaceSites sites = wrapped_sites();
    if (sites.duplicates().first >= 0) return false;
    // The sites before the step get the same offsets.
    if (!settled_) before_ -= coordinates_ - sites.coordinates();
    coordinates_ = sites.coordinates();
    tetrahedra_ = space_tetrahedra(sites);
    n_flips_sorted_ = n_flips_;
    ++n_rebuilds_;
    return true;
}

SpaceDelaunay MovingTetrahedra::release() {
    std::vector<Offset3> change(static_cast<std::size_t>(n_sites()));
    Points3 coordinates(3, n_sites());
    for (SiteId s = 0; s < n_sites(); ++s) {
        change[s] = wrap(coordinates_.col(s)).whole;
        coordinates.col(order_[s]) = coordinates_.col(s);
    }
    tetrahedra_.add_to_offsets(change);
    tetrahedra_.renumber_sites(order_);
    return {SpaceSites(lattice_, reduction_, std::move(coordinates)), std::move(tetrahedra_)};
}

}  // namespace pcvt
