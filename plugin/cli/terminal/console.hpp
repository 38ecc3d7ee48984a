#pragma once

#include <functional>
#include <new>
#include <string>

namespace pcvt::cli {

/// A number with six digits for readers: print("energy " + figure(energy) + "\n").
std::string figure(double value);

/// A number of things for readers: "1 site", "2 sites".
std::string counted(long n, const std::string& thing);

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
