#include "mesher/plane/symmetry/symmetric_objective.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/base/block_matrix.hpp"

namespace pcvt::plane {
namespace {

using PlaneMatrix = Eigen::Matrix2d;

/// The block of E of a site.
/// @param to_frame  maps reduced coordinates to the frame.
std::array<double, 4> block_of(const MoveTie& tie, const SiteOrbit& orbit,
                               const PlaneMatrix& to_frame) {
    PlaneMatrix m;
    m << tie.matrix[0], tie.matrix[1], tie.matrix[2], tie.matrix[3];
    if (orbit.freedom == 2) {
        const PlaneMatrix turn = to_frame * m * to_frame.inverse();
        return {turn(0, 0), turn(0, 1), turn(1, 0), turn(1, 1)};
    }
    // The tie maps the direction of the representative to that of the site.
    const Vec2 along = to_frame * (m * Vec2(orbit.along[0], orbit.along[1]));
    const Vec2 scaled = std::sqrt(2.0) * along.normalized();
    return {scaled.x(), 0, scaled.y(), 0};
}

PlaneMatrix matrix(const std::array<double, 4>& block) {
    return (PlaneMatrix() << block[0], block[1], block[2], block[3]).finished();
}

}  // namespace

OrbitEmbedding tie_orbits(const SymmetricSites& sites, MovingDelaunay& delaunay) {
    const auto n = static_cast<std::size_t>(delaunay.n_sites());
    std::vector<SiteId> number(n);
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) number[delaunay.original_id(s)] = s;
    OrbitEmbedding embedding;
    embedding.order = sites.group.order();
    // Number the orbits that can move.
    std::vector<int> pair(sites.orbits.size(), -1);
    for (std::size_t k = 0; k < sites.orbits.size(); ++k) {
        const SiteOrbit& orbit = sites.orbits[k];
        if (orbit.freedom == 0) continue;
        pair[k] = static_cast<int>(embedding.representative.size());
        embedding.representative.push_back(number[orbit.representative]);
        embedding.n_sites.push_back(orbit.n_sites);
    }
    // Give each site its block and its tie.
    const ReducedFrame& frame = delaunay.frame();
    const PlaneMatrix to_frame = (PlaneMatrix() << frame.ax, frame.bx, 0, frame.by).finished();
    std::vector<MoveTie> ties(n);
    embedding.pair.resize(n);
    embedding.block.resize(n);
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        const SiteId id = delaunay.original_id(s);
        const SiteOrbit& orbit = sites.orbits[sites.orbit[id]];
        ties[s] = {number[sites.ties[id].representative], sites.ties[id].matrix};
        embedding.pair[s] = pair[sites.orbit[id]];
        if (orbit.freedom > 0) embedding.block[s] = block_of(ties[s], orbit, to_frame);
    }
    delaunay.tie_moves(std::move(ties));
    return embedding;
}

SymmetricObjective::SymmetricObjective(Objective& all, OrbitEmbedding embedding)
    : all_(all), embedding_(std::move(embedding)) {
    direction_.resize(all.n_variables());
}

/// At least one pair, because vectors of optimisers are not empty.
Eigen::Index SymmetricObjective::n_variables() const {
    return 2 * std::max<Eigen::Index>(1, std::ssize(embedding_.representative));
}

template <class Vector>
void SymmetricObjective::expand(const Vector& z, Vector& x) const {
    using Number = typename Vector::Scalar;
    x.resize(all_.n_variables());
    for (std::size_t s = 0; s < embedding_.pair.size(); ++s) {
        const auto at = static_cast<Eigen::Index>(2 * s);
        const Eigen::Index from = 2 * Eigen::Index{embedding_.pair[s]};
        x.template segment<2>(at).setZero();
        if (from < 0) continue;
        const Vec2 move =
            matrix(embedding_.block[s]) * z.template segment<2>(from).template cast<double>();
        x.template segment<2>(at) = move.cast<Number>();
    }
}

template <class Vector>
void SymmetricObjective::fold(const Vector& g, Vector& folded) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(n_variables());
    for (std::size_t s = 0; s < embedding_.pair.size(); ++s) {
        const Eigen::Index to = 2 * Eigen::Index{embedding_.pair[s]};
        if (to < 0) continue;
        const Vec2 own =
            g.template segment<2>(static_cast<Eigen::Index>(2 * s)).template cast<double>();
        sum.segment<2>(to) += matrix(embedding_.block[s]).transpose() * own;
    }
    folded = sum.cast<typename Vector::Scalar>();
}

bool SymmetricObjective::evaluate(const Eigen::VectorXf& direction, double t,
                                  Evaluation& evaluation) {
    if (t != 0) {
        // The undoing of an earlier trial uses its direction.
        if (pending_) all_.reject();
        expand(direction, direction_);
        pending_ = true;
    }
    if (!all_.evaluate(direction_, t, evaluation_)) return false;
    if (t == 0) pending_ = false;
    evaluation.value = evaluation_.value;
    evaluation.residual = evaluation_.residual;
    evaluation.rms_residual = evaluation_.rms_residual;
    fold(evaluation_.gradient, evaluation.gradient);
    if (evaluation_.preconditioned.size() > 0) {
        fold(evaluation_.preconditioned, evaluation.preconditioned);
        evaluation.preconditioned /= static_cast<float>(embedding_.order);
    }
    return true;
}

void SymmetricObjective::accept() {
    all_.accept();
    pending_ = false;
}

void SymmetricObjective::reject() {
    all_.reject();
    pending_ = false;
}

/// g lies in the range of E, so g = E E^T g / c.
Evaluation SymmetricObjective::expanded(const Evaluation& evaluation) const {
    Evaluation all{.value = evaluation.value,
                   .gradient = {},
                   .residual = evaluation.residual,
                   .rms_residual = evaluation.rms_residual};
    expand(evaluation.gradient, all.gradient);
    all.gradient /= embedding_.order;
    return all;
}

bool SymmetricObjective::precondition(Evaluation& evaluation) {
    Evaluation all = expanded(evaluation);
    if (!all_.precondition(all)) return false;
    fold(all.preconditioned, evaluation.preconditioned);
    evaluation.preconditioned /= static_cast<float>(embedding_.order);
    return true;
}

void SymmetricObjective::lloyd_step(const Evaluation& evaluation,
                                    Eigen::VectorXf& direction) const {
    Eigen::VectorXf steps;
    all_.lloyd_step(expanded(evaluation), steps);
    fold(steps, direction);
    direction /= static_cast<float>(embedding_.order);
}

/// Row A of E^T H E is m_A times the sum over the row of its representative a, E_a^T H_aj E_j,
/// since H commutes with the group.
void SymmetricObjective::hessian(BlockMatrix& hessian) const {
    BlockMatrix all;
    all_.hessian(all);
    const auto n_pairs = embedding_.representative.size();
    std::vector<int> n_entries(std::max<std::size_t>(1, n_pairs), 0);
    const auto is_entry = [&](std::size_t p, int k) {
        const int column = embedding_.pair[all.column[k]];
        return column >= 0 && column != static_cast<int>(p);
    };
    for (std::size_t p = 0; p < n_pairs; ++p) {
        const SiteId a = embedding_.representative[p];
        for (int k = all.row_begin[a]; k < all.row_begin[a + 1]; ++k)
            n_entries[p] += is_entry(p, k);
    }
    hessian.resize(n_entries);
    hessian.annihilates_translations = all.annihilates_translations && embedding_.order == 1;
    if (n_pairs == 0) hessian.diagonal[0] = {1, 0, 0, 1};
    for (std::size_t p = 0; p < n_pairs; ++p) {
        const SiteId a = embedding_.representative[p];
        const PlaneMatrix from = embedding_.n_sites[p] * matrix(embedding_.block[a]).transpose();
        const auto& own = all.diagonal[a];
        PlaneMatrix diagonal = (PlaneMatrix() << own[0], own[2], own[1], own[3]).finished();
        diagonal = from * diagonal * matrix(embedding_.block[a]);
        int next = hessian.row_begin[p];
        for (int k = all.row_begin[a]; k < all.row_begin[a + 1]; ++k) {
            const SiteId j = all.column[k];
            if (embedding_.pair[j] < 0) continue;
            const BlockMatrix::Block& h = all.block[k];
            const PlaneMatrix folded = from * (PlaneMatrix() << h[0], h[2], h[1], h[3]).finished() *
                                       matrix(embedding_.block[j]);
            if (!is_entry(p, k)) {
                diagonal += folded;
                continue;
            }
            hessian.column[next] = embedding_.pair[j];
            for (int m = 0; m < 4; ++m) {
                hessian.block[next][m] = static_cast<float>(folded(m % 2, m / 2));
            }
            ++next;
        }
        hessian.diagonal[p] = {diagonal(0, 0), diagonal(1, 0), diagonal(0, 1), diagonal(1, 1)};
    }
}

}  // namespace pcvt::plane
