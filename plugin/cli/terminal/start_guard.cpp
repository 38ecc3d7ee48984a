#include "plugin/cli/terminal/start_guard.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

namespace pcvt::cli {
namespace {

/// The handler that this module replaces.
std::terminate_handler usual_end = nullptr;
bool main_has_begun = false;

/// Whether std::terminate() was called for lack of memory: by bad_alloc, or where not even memory
/// for an exception was left.
bool is_out_of_memory() {
    const std::exception_ptr exception = std::current_exception();
    if (!exception) return true;
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

[[noreturn]] void end_out_of_memory() {
    // Buffers of stdio and destructors may need memory.
    const bool written = ::write(STDERR_FILENO, kOutOfMemory, std::strlen(kOutOfMemory)) > 0 &&
                         ::write(STDERR_FILENO, "\n", 1) > 0;
    static_cast<void>(written);
    ::_exit(kOutOfMemoryCode);
}

void end_by_terminate() {
    if (is_out_of_memory()) end_out_of_memory();
    usual_end();
}

void end_by_abort(int) { end_out_of_memory(); }

/// A library has printed the reason.
void end_by_exit() {
    if (!main_has_begun) ::_exit(kOutOfMemoryCode);
}

void begin_start_guard() {
    usual_end = std::set_terminate(end_by_terminate);
    std::signal(SIGABRT, end_by_abort);
    std::atexit(end_by_exit);
}

/// The functions of this section of a program run before the initialisers of its libraries.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kFirstOfAll)() = begin_start_guard;

}  // namespace

void begin_main() {
    main_has_begun = true;
    std::signal(SIGABRT, SIG_DFL);
}

void end_start_guard() { std::set_terminate(usual_end); }

}  // namespace pcvt::cli
