#include "plugin/cli/terminal/console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "io/bytes/output_error.hpp"

namespace pcvt::cli {

void print(const std::string& text) {
    errno = 0;
    const bool taken = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!taken || std::fflush(stdout) != 0) {
        if (errno == EPIPE) return;
        throw OutputError(std::string("standard output: ") + std::strerror(errno));
    }
}

void print_after_files(const std::function<std::string()>& text) {
    try {
        print(text());
    } catch (const std::bad_alloc&) {
        throw NoMemoryAfterFiles();
    } catch (const OutputError& error) {
        throw OutputError(std::string(error.what()) + "; the files are written");
    }
}

}  // namespace pcvt::cli
