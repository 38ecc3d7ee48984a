#include "plugin/cli/terminal/cancel_signal.hpp"

#include <csignal>

namespace pcvt::cli {
namespace {

volatile std::sig_atomic_t noted_signal = 0;

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

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace pcvt::cli
