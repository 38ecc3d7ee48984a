#pragma once

#include <chrono>

#include "plugin/job/run_summary.hpp"

namespace pcvt {

/// Adds up the seconds of each stage of a run.
///
///   Stopwatch watch;
///   build();
///   watch.stop(&JobSeconds::build);
class Stopwatch {
   public:
    explicit Stopwatch(const JobSeconds& before = {}) : seconds_(before) {}

    /// Adds the time since the last stop to `stage`.
    void stop(double JobSeconds::*stage) {
        const Clock::time_point now = Clock::now();
        const double lap = std::chrono::duration<double>(now - last_).count();
        seconds_.*stage += lap;
        seconds_.total += lap;
        last_ = now;
    }
    const JobSeconds& seconds() const { return seconds_; }

   private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    JobSeconds seconds_;
};

}  // namespace pcvt
