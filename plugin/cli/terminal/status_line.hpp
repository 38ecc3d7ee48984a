#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace pcvt::cli {

/// One line on standard error, redrawn at most ten times a second, but at once for a new phase, and
/// cleared at the end. Silent if standard error is not a terminal.
///
///   StatusLine line(true);
///   if (line.due()) line.draw({"half done", "12 s left"});
class StatusLine {
   public:
    /// @param wanted  false: silent also on a terminal.
    explicit StatusLine(bool wanted);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// Whether it is time to draw again.
    /// @param is_new_phase  true: a line that is on the terminal is drawn again at once.
    bool due(bool is_new_phase = false);
    /// Draws the parts that fit_line() keeps in the width of the terminal.
    void draw(const std::vector<std::string>& parts);
    /// Clears the line on the terminal.
    void clear();
    /// Seconds since the construction.
    double seconds() const;

   private:
    using Clock = std::chrono::steady_clock;

    bool shown_;
    Clock::time_point start_;
    Clock::time_point last_drawn_;
    /// Columns of the line on the terminal.
    int drawn_ = 0;
};

/// The first part, cut if it is too long, and those of the others that fit behind it, with two
/// blanks between them. Control characters become question marks.
/// @param columns  the most columns of the line.
std::string fit_line(const std::vector<std::string>& parts, int columns);

/// The columns that a UTF-8 text takes on a terminal; at least that many for rare characters.
int columns_of(const std::string& text);

/// "12 s", "8 min", "2.5 h".
std::string duration_in_words(double seconds);

}  // namespace pcvt::cli
