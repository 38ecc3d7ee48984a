#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"
#include "mesher/optimize/packed_vectors.hpp"

namespace pcvt {

/// The memory of L-BFGS: the last 5 pairs of step s and change of gradient y, and the product with
/// the inverse Hessian that they stand for.
///
/// Made for large n, where time is memory traffic: the vectors are stored at 16 bits a number, and
/// an iteration sweeps over them twice. The first sweep, after an evaluation, takes the dot
/// products of the new gradient with all of them; from these follow the products of all pairs with
/// each other, and from those alone the two-loop recursion (J. Nocedal 1980), as coefficients (W.
/// Chen, Z. Wang, J. Zhou 2014). The second sweep combines the next direction, rounded to what is
/// stored: so a step is known exactly, a change of gradient to a 65,534th of the largest near it.
/// With a preconditioner M the Hessian is taken for M at first, and z = M^-1 y, which is the change
/// of the preconditioned gradient, is stored in place of y. Of a pair t, with s = t * direction, is
/// stored beside the direction. Sums over blocks are double, and the same bits for any number of
/// workers.
class LbfgsHistory {
   public:
    static constexpr int kPairs = 5;

    LbfgsHistory(Eigen::Index n_variables, Workers& workers);

    /// Forgets all pairs; the next search begins at the point `here`.
    void begin(const Evaluation& here);
    /// Whether there is no pair.
    bool empty() const { return slots_.empty(); }

    /// The direction of the search. While the history is empty, the caller fills it in, and aim
    /// rounds it.
    Eigen::VectorXf& direction() { return direction_; }

    /// A direction d at the gradient g.
    struct Direction {
        /// g.d, with g as it is stored: to some 1e-5 of |g| |d|.
        double slope;
        /// The largest |(d_2i, d_2i+1)|.
        double largest_move;
    };
    /// Makes direction() the product of minus the approximate inverse Hessian with the gradient
    /// where the search begins; of an empty history, only measures what the caller filled in.
    Direction compute_direction();

    /// The slope along direction() at a trial point.
    double directional_derivative(const Evaluation& there);

    /// The next search begins at the point that was looked at last, t * direction() from here. Adds
    /// the pair of this step, or where the curvature along it is weak forgets all pairs.
    void append_pair(double t);

   private:
    struct Coefficients;

    Coefficients two_loops() const;
    void make_room_for_trial();
    static int step(int slot) { return 2 * slot; }
    static int change(int slot) { return 2 * slot + 1; }

    template <class T>
    using PerSlot = std::array<T, kPairs>;

    Workers& workers_;
    Eigen::Index n_variables_;
    Eigen::VectorXf direction_;
    PackedVectors packed_;
    /// Where the search begins, vector here_, and at the point looked at last, the other one.
    PackedVectors gradients_;
    /// The same, once an evaluation has them.
    std::optional<PackedVectors> preconditioned_;
    int here_ = 0;
    /// Slots of the pairs, the oldest first, and the slot of the direction.
    std::vector<int> slots_;
    int trial_ = 0;

    /// Of the pairs: s = scale * the direction stored; s.y, y.z for pairs of pairs; s.g and z.g at
    /// the gradient where the last pair ended, and at the point looked at last.
    PerSlot<double> scale_{};
    PerSlot<PerSlot<double>> sy_{};
    PerSlot<PerSlot<double>> yz_{};
    PerSlot<double> sg_{};
    PerSlot<double> zg_{};
    PerSlot<double> sg_there_{};
    PerSlot<double> zg_there_{};
    /// Along the direction, where the search begins.
    double slope_ = 0;
};

}  // namespace pcvt
