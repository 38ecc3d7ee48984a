#include "plugin/cli/terminal/cancel_signal.hpp"

#include <atomic>
#include <csignal>

namespace pcvt::cli {
namespace {

/// Several threads look at it.
std::atomic<int> noted_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void note_signal(int number) { noted_signal = number; }

}  // namespace

void catch_cancel_signals() {
    struct sigaction action = {};
    action.sa_handler = note_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int cancel_signal() { return noted_signal; }

void ignore_signals_of_writes() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace pcvt::cli
