#include "plugin/cli/terminal/status_line.hpp"

#include <unistd.h>

#include <cstdio>

namespace pcvt::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenDrawings{100};

}  // namespace

StatusLine::StatusLine(bool wanted)
    : shown_(wanted && isatty(STDERR_FILENO) == 1), start_(Clock::now()), last_drawn_(start_) {}

StatusLine::~StatusLine() { clear(); }

bool StatusLine::due() {
    if (!shown_) return false;
    const Clock::time_point now = Clock::now();
    if (now - last_drawn_ < kBetweenDrawings) return false;
    last_drawn_ = now;
    return true;
}

void StatusLine::draw(std::string line) {
    const std::size_t length = line.size();
    // Spaces overwrite the rest of the previous line: dumb terminals know no "clear to the end".
    if (length < width_) line.append(width_ - length, ' ');
    width_ = length;
    std::fprintf(stderr, "\r%s", line.c_str());
    std::fflush(stderr);
}

void StatusLine::clear() {
    if (width_ == 0) return;
    std::fprintf(stderr, "\r%s\r", std::string(width_, ' ').c_str());
    std::fflush(stderr);
    width_ = 0;
}

double StatusLine::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string duration_in_words(double seconds) {
    char text[32];
    if (seconds < 100) {
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    } else if (seconds < 6000) {
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    } else {
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    }
    return text;
}

}  // namespace pcvt::cli
