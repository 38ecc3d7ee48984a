#include "plugin/cli/terminal/status_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace pcvt::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenDrawings{100};
/// The width of a terminal that does not state it.
constexpr int kUsualColumns = 80;
/// Some characters from this first byte of UTF-8 on (U+1000) take two columns.
constexpr unsigned char kWide = 0xE1;

int terminal_columns() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : kUsualColumns;
}

/// The columns of the character that begins with this byte; 0 inside of a character.
int columns_of(unsigned char byte) {
    if ((byte & 0xC0U) == 0x80U) return 0;
    return byte >= kWide ? 2 : 1;
}

std::string printable(std::string text) {
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    };
    std::replace_if(text.begin(), text.end(), is_control, '?');
    return text;
}

std::string cut(const std::string& text, int columns) {
    std::size_t end = 0;
    for (int used = 0; end < text.size(); ++end) {
        used += columns_of(static_cast<unsigned char>(text[end]));
        if (used > columns) break;
    }
    return text.substr(0, end);
}

}  // namespace

int columns_of(const std::string& text) {
    int columns = 0;
    for (const char c : text) columns += columns_of(static_cast<unsigned char>(c));
    return columns;
}

std::string fit_line(const std::vector<std::string>& parts, int columns) {
    std::string line;
    for (const std::string& part : parts) {
        const std::string text = (line.empty() ? "" : "  ") + printable(part);
        if (line.empty()) {
            line = cut(text, columns);
        } else if (columns_of(line) + columns_of(text) <= columns) {
            line += text;
        }
    }
    return line;
}

StatusLine::StatusLine(bool wanted)
    : shown_(wanted && isatty(STDERR_FILENO) == 1), start_(Clock::now()), last_drawn_(start_) {}

StatusLine::~StatusLine() { clear(); }

bool StatusLine::due(bool is_new_phase) {
    if (!shown_) return false;
    const Clock::time_point now = Clock::now();
    const bool at_once = is_new_phase && drawn_ > 0;
    if (!at_once && now - last_drawn_ < kBetweenDrawings) return false;
    last_drawn_ = now;
    return true;
}

void StatusLine::draw(const std::vector<std::string>& parts) {
    if (!shown_) return;
    // In the last column some terminals begin a new line.
    const int most = terminal_columns() - 1;
    const std::string line = fit_line(parts, most);
    const int columns = columns_of(line);
    // Spaces overwrite the rest of the previous line: dumb terminals lack "clear to the end".
    const int rest = std::max(0, std::min(drawn_, most) - columns);
    drawn_ = columns;
    std::fprintf(stderr, "\r%s%*s", line.c_str(), rest, "");
    std::fflush(stderr);
}

void StatusLine::clear() {
    if (drawn_ == 0) return;
    std::fprintf(stderr, "\r%*s\r", std::min(drawn_, terminal_columns() - 1), "");
    std::fflush(stderr);
    drawn_ = 0;
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
