#pragma once

#include <string>

#include "mesher/plane/energy/energy.hpp"

namespace pcvt::testing {

/// Statistics of an engine's moves.
struct EngineTally {
    std::int64_t moves = 0;
    /// Moves after which two sites coincided.
    std::int64_t undefined = 0;
    std::int64_t flips = 0;
    std::int64_t rebuilds = 0;
    /// Moves that inverted triangles and were repaired without a build.
    std::int64_t local_repairs = 0;
    /// Predicates evaluated by the engine, and the number that the filter did not decide.
    std::int64_t predicates = 0;
    std::int64_t exact = 0;

    EngineTally& operator+=(const EngineTally& other);
};

/// A MovingDelaunay with its energy that is compared with the references (engine_twin.hpp) after
/// every operation.
class CheckedEngine {
   public:
    explicit CheckedEngine(const plane::Sites& sites);

    const plane::MovingDelaunay& delaunay() const { return delaunay_; }
    const Energy& energy() const { return energy_; }
    const EngineTally& tally() const { return tally_; }
    /// A description of the first difference from the references; it does not change afterwards.
    const std::string& fault() const { return fault_; }

    /// Steps and evaluates. If two sites then coincide, or the move is not finite, the engine steps
    /// back and compares the old state as well.
    /// @pre settled: each `move` is followed by `settle` or `step_back`.
    /// @returns whether the engine is at the new position.
    bool move(const Eigen::VectorXf& direction, double t = 1);
    void step_back();
    void settle() { delaunay_.settle(); }
    /// Releases the sites and the triangulation and compares them; ends the engine.
    void release();

   private:
    void require(const std::string& fault);
    bool evaluate();
    void require_arrived(const plane::Points& from, const Eigen::VectorXf& direction, double t);
    void compare();

    plane::Sites original_;
    Workers workers_{1};
    plane::MovingDelaunay delaunay_;
    plane::EnergyPass pass_;
    Energy energy_;
    /// The positions where the sites settled last, and their move from there.
    plane::Points home_;
    Eigen::VectorXf direction_;
    EngineTally tally_;
    std::string fault_;
};

}  // namespace pcvt::testing
