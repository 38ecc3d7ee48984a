#include "plugin/job/distinct_paths.hpp"

#include <filesystem>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

/// One name for a file, however it is written.
std::string identity(const std::string& path) {
    std::error_code ignored;
    fs::path canonical = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    if (ignored) canonical = fs::path(path).lexically_normal();
    return canonical.string();
}

}  // namespace

void DistinctPaths::add_input(const std::string& path) {
    book_.emplace(identity(path), "an input");
}

void DistinctPaths::add_output(const std::string& path) {
    const auto [entry, fresh] = book_.emplace(identity(path), "another output");
    if (!fresh) {
        throw InvalidInput(path + " is " + entry->second + " as well; choose another name");
    }
}

}  // namespace pcvt
