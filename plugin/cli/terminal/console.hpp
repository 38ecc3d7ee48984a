#pragma once

#include <functional>
#include <new>
#include <string>

namespace pcvt::cli {

/// Writes `text` to standard output. A reader that has closed the pipe, as `head` does, wants no
/// more: that is not a failure.
/// @throws OutputError if the write fails.
void print(const std::string& text);

/// Lack of memory once files are written.
class NoMemoryAfterFiles : public std::bad_alloc {
   public:
    const char* what() const noexcept override {
        return "out of memory for the summary; the files are written";
    }
};

/// Makes a text and prints it once files are written, which the message of a failure adds.
/// @throws OutputError, NoMemoryAfterFiles
void print_after_files(const std::function<std::string()>& text);

}  // namespace pcvt::cli
