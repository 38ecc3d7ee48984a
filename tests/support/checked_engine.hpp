#pragma once

#include <string>

#include "mesher/energy/energy.hpp"

namespace pcvt::testing {

/// What an engine went through.
struct EngineTally {
    std::int64_t moves = 0;
    /// Moves after which two sites coincided.
    std::int64_t undefined = 0;
    std::int64_t flips = 0;
    std::int64_t rebuilds = 0;
    /// Moves that inverted triangles and were repaired without a build.
    std::int64_t local_repairs = 0;
    /// Predicates asked by the engine, and those that left the filter.
    std::int64_t predicates = 0;
    std::int64_t exact = 0;

    EngineTally& operator+=(const EngineTally& other);
};

/// A MovingDelaunay with its energy, compared with its twins after everything that it does.
class CheckedEngine {
   public:
    explicit CheckedEngine(const Sites& sites);

    const MovingDelaunay& delaunay() const { return delaunay_; }
    const Energy& energy() const { return energy_; }
    const EngineTally& tally() const { return tally_; }
    /// The first difference from the twins, in words, and only its words from then on.
    const std::string& fault() const { return fault_; }

    /// Steps and evaluates. Where two sites then coincide, or the move is not finite, it is back at
    /// the old place, compared as well.
    /// @pre settled: after each `move` follows `settle` or `step_back`.
    /// @returns whether the engine stands at the new place.
    bool move(const Eigen::VectorXf& direction, double t = 1);
    void step_back();
    void settle() { delaunay_.settle(); }
    /// Ends the engine: compares what it releases.
    void release();

   private:
    void require(const std::string& fault);
    bool evaluate();
    void require_arrived(const Points& from, const Eigen::VectorXf& direction, double t);
    void compare();

    Sites original_;
    Workers workers_{1};
    MovingDelaunay delaunay_;
    EnergyPass pass_;
    Energy energy_;
    /// Where the sites settled last, and where they went from there.
    Points home_;
    Eigen::VectorXf direction_;
    EngineTally tally_;
    std::string fault_;
};

}  // namespace pcvt::testing
