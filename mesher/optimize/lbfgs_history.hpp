#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"
#include "mesher/optimize/packed_vectors.hpp"

namespace pcvt {

/// The memory of L-BFGS: the last 5 pairs of step s and change of gradient y, and the product of a
/// gradient with the inverse Hessian that these pairs approximate.
///
/// The class is made for large n, where memory traffic determines the time: vectors are stored at
/// 16 bits a number, and an iteration sweeps over them twice. The first sweep, after an evaluation,
/// computes the dot products of the new gradient with all of them. From these follow the products
/// between all pairs, and from only these products the coefficients of the two-loop recursion (J.
/// Nocedal 1980; W. Chen, Z. Wang, J. Zhou 2014). The second sweep combines the next direction and
/// rounds it to its stored value. A step is therefore known exactly, and a change of gradient to 1
/// / 65,534 of the largest number of its block. With a preconditioner M the initial Hessian is M,
/// and z = M^-1 y, the change of the preconditioned gradient, is stored in place of y. Each pair
/// stores its direction and the scale t with s = t * direction. Sums over blocks are in double
/// precision and bit for bit the same for any number of workers.
///
/// Use within a line search:
///
///     history.begin(here);
///     history.direction() = first_direction;
///     const auto [slope, largest_move] = history.compute_direction();
///     // ... evaluate the objective at t * direction() into `there` ...
///     const double slope_there = history.directional_derivative(there);
///     history.append_pair(t);
class LbfgsHistory {
   public:
    static constexpr int kPairs = 5;

    LbfgsHistory(Eigen::Index n_variables, Workers& workers);

    /// Clears all pairs; the next line search begins at the point `here`.
    void begin(const Evaluation& here);
    /// Whether the history holds no pair.
    bool empty() const { return slots_.empty(); }

    /// The direction of the line search. While the history is empty the caller fills it in, and
    /// compute_direction rounds it.
    Eigen::VectorXf& direction() { return direction_; }

    /// A direction d at the gradient g.
    struct Direction {
        /// g.d with the stored gradient, accurate to about 1e-5 |g| |d|.
        double slope;
        /// The largest |(d_2i, d_2i+1)|.
        double largest_move;
    };
    /// Sets direction() to minus the approximate inverse Hessian times the gradient at the
    /// beginning of the search. With an empty history it only measures the direction that the
    /// caller filled in.
    Direction compute_direction();

    /// Returns the slope along direction() at a trial point and stores the trial's products.
    double directional_derivative(const Evaluation& there);

    /// Accepts the trial point that was measured last, t * direction() away; the next line search
    /// begins there. Appends the pair of this step, or clears all pairs if the curvature along the
    /// step is weak.
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
    /// Vector here_ is the gradient where the search begins, the other vector that at the last
    /// trial point.
    PackedVectors gradients_;
    /// The preconditioned gradients at the same points, once evaluations return them.
    std::optional<PackedVectors> preconditioned_;
    int here_ = 0;
    /// Slots of the pairs, the oldest first, and the slot of the current direction.
    std::vector<int> slots_;
    int trial_ = 0;

    /// Scales and dot products of the pairs: s = scale * stored direction; s.y and y.z between
    /// pairs; s.g and z.g with the gradient at the end of the last pair, and (`_there`) with that
    /// of the last trial point.
    PerSlot<double> scale_{};
    PerSlot<PerSlot<double>> sy_{};
    PerSlot<PerSlot<double>> yz_{};
    PerSlot<double> sg_{};
    PerSlot<double> zg_{};
    PerSlot<double> sg_there_{};
    PerSlot<double> zg_there_{};
    /// The slope along the direction where the search begins.
    double slope_ = 0;
};

}  // namespace pcvt
