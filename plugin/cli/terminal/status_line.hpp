#pragma once

#include <chrono>
#include <string>

namespace pcvt::cli {

/// One line on standard error, redrawn at most ten times a second and cleared at the end. Silent if
/// standard error is no terminal.
///
///   StatusLine line(true);
///   if (line.due()) line.draw("half done");
class StatusLine {
   public:
    /// @param wanted  false: silent also on a terminal.
    explicit StatusLine(bool wanted);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// Whether it is time to draw again.
    bool due();
    void draw(std::string line);
    /// Clears the line on the terminal.
    void clear();
    /// Seconds since the construction.
    double seconds() const;

   private:
    using Clock = std::chrono::steady_clock;

    bool shown_;
    Clock::time_point start_;
    Clock::time_point last_drawn_;
    std::size_t width_ = 0;
};

/// "12 s", "8 min", "2.5 h".
std::string duration_in_words(double seconds);

}  // namespace pcvt::cli
