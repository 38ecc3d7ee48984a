#include "mesher/space/power/power_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/space/power/power_flips.hpp"

namespace pcvt::space {
namespace {

/// Volumes are corrected where fewer than this share of the tetrahedra is exchanged; else a second
/// pass costs less.
constexpr double kMostCorrected = 0.1;
/// After flips of this share of the tetrahedra, most of them lie far from their neighbours in
/// memory.
constexpr double kPowerFlipsUntilSorting = 0.3;
/// The shortest part of a way.
constexpr double kShortestPart = 0x1p-24;

}  // namespace

void PowerDiagram::start() {
    // The moving tetrahedra outlive the way that begins here.
    base_ = std::shared_ptr<const TorusTetrahedra>(std::shared_ptr<const void>(),
                                                   &moving_->tetrahedra());
    base_weights_ = Eigen::VectorXd::Zero(n_sites());
    base_flips_unsorted_ = 0;
}

void PowerDiagram::start(const PowerDiagram& other) {
    base_ = other.tetrahedra_;
    base_weights_ = other.weights_;
    base_flips_unsorted_ = other.n_flips_unsorted_;
}

void PowerDiagram::copy_from(const TorusTetrahedra& other) {
    if (tetrahedra_ == nullptr || tetrahedra_.use_count() > 1) {
        tetrahedra_ = std::make_shared<TorusTetrahedra>(other);
    } else {
        *tetrahedra_ = other;
    }
}

/// Names a site whose weight is so much smaller than the largest one that it has no cell: no point
/// is farther from an image of a site than half of the sum of the reduced periods.
std::optional<SiteId> PowerDiagram::site_without_cell(const Eigen::VectorXd& weights) const {
    const Frame& frame = moving_->frame();
    const double farthest =
        (frame.ax + std::hypot(frame.bx, frame.by) +
         std::sqrt(frame.cx * frame.cx + frame.cy * frame.cy + frame.cz * frame.cz)) /
        2;
    Eigen::Index least = 0;
    const double range = weights.maxCoeff() - weights.minCoeff(&least);
    if (range <= farthest * farthest) return std::nullopt;
    return static_cast<SiteId>(least);
}

/// Flips from tetrahedra that are regular for weights not far away, and measures the volumes.
PowerDiagram::Outcome PowerDiagram::flip_to(const Eigen::VectorXd& weights) {
    const WeightedTetrahedra weighted{*tetrahedra_, moving_->coordinates(), moving_->frame(),
                                      weights};
    std::vector<int> suspects = sums_.run(weighted, *workers_, volumes_);
    if (suspects.empty()) return Outcome::kRegular;
    // The facets at cells of negative volume come last, where the flips begin: a hidden site is
    // found before the other facets are flipped.
    const auto is_at_cell = [&](int f) {
        const Tetrahedron t = tetrahedra_->tetrahedron(f / 4);
        return std::all_of(t.begin(), t.end(),
                           [&](const Corner& c) { return volumes_[c.site] > 0; });
    };
    std::stable_partition(suspects.begin(), suspects.end(), is_at_cell);
    Eigen::VectorXd gram_weights = weights * moving_->frame().gram_per_square;
    for (double& w : gram_weights) w = rounded_weight(w);
    PowerFlips flips(*tetrahedra_, moving_->coordinates(), moving_->frame().gram, gram_weights);
    const bool done = flips.flip(suspects);
    counts_.n_flips += flips.n_flips();
    n_flips_unsorted_ += flips.n_flips();
    if (!done) {
        hidden_ = flips.hidden();
        return hidden_ ? Outcome::kHidden : Outcome::kStuck;
    }
    if (flips.n_flips() == 0) return Outcome::kRegular;
    ExchangedTetrahedra exchanged = flips.take_exchanged();
    const int n_tetrahedra = tetrahedra_->n_tetrahedra();
    if (double(n_flips_unsorted_) > kPowerFlipsUntilSorting * n_tetrahedra) {
        tetrahedra_->sort();
        n_flips_unsorted_ = 0;
    }
    if (double(exchanged.added.size()) < kMostCorrected * n_tetrahedra &&
        correct_volumes(std::move(exchanged), weighted, volumes_)) {
        return Outcome::kRegular;
    }
    sums_.run(weighted, *workers_, volumes_);
    return Outcome::kRegular;
}

bool PowerDiagram::go_to(const Eigen::VectorXd& weights) {
    copy_from(*base_);
    n_flips_unsorted_ = base_flips_unsorted_;
    Outcome outcome = flip_to(weights);
    if (outcome != Outcome::kStuck) return outcome == Outcome::kRegular;
    // Halve the way; `last` are the tetrahedra at `reached`.
    std::shared_ptr<const TorusTetrahedra> last = base_;
    double reached = 0;
    for (double part = 0.5; reached < 1;) {
        ++counts_.n_halvings;
        copy_from(*last);
        const double next = std::min(1.0, reached + part);
        outcome =
            flip_to(next == 1 ? weights
                              : Eigen::VectorXd(base_weights_ + next * (weights - base_weights_)));
        if (outcome == Outcome::kHidden) return false;
        if (outcome == Outcome::kStuck) {
            part /= 2;
            if (part < kShortestPart) return false;
            continue;
        }
        reached = next;
        if (reached < 1) last = tetrahedra_;
    }
    return true;
}

bool PowerDiagram::set_weights(Eigen::VectorXd weights) {
    if (base_ == nullptr) {
        base_ = std::move(tetrahedra_);
        base_weights_ = std::move(weights_);
        base_flips_unsorted_ = n_flips_unsorted_;
    }
    weights_ = std::move(weights);
    hidden_.reset();
    if (!weights_.allFinite()) return false;
    if (weights_.maxCoeff() * moving_->frame().gram_per_square >= kLargestWeight) return false;
    hidden_ = site_without_cell(weights_);
    const bool regular = !hidden_ && go_to(weights_);
    base_.reset();
    if (hidden_) ++counts_.n_hidden;
    return regular;
}

PeriodicDelaunay weighted_delaunay(MovingTetrahedra& moving, const PowerDiagram& diagram) {
    const double unit = moving.unit();
    Eigen::VectorXd weights(diagram.n_sites());
    for (SiteId s = 0; s < diagram.n_sites(); ++s) {
        weights[moving.original_id(s)] = diagram.weights()[s] * (unit * unit);
    }
    PeriodicDelaunay result = moving.release(diagram.tetrahedra());
    result.weights = std::move(weights);
    return result;
}

}  // namespace pcvt::space
