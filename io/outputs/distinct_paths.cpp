#include "io/outputs/distinct_paths.hpp"

#include <algorithm>
#include <filesystem>

#include "io/bytes/text.hpp"
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

/// Line ends and the like, which text formats cannot hold in a name.
bool is_control_character(char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7F;
}

}  // namespace

void DistinctPaths::add_input(const std::string& path) {
    book_.emplace(identity(path), "an input");
}

void DistinctPaths::add_output(const std::string& path) {
    if (std::any_of(path.begin(), path.end(), is_control_character)) {
        throw InvalidInput("output " + in_quotes(path) +
                           ": the name holds a control character; choose another name");
    }
    const std::string name = identity(path);
    const auto [entry, fresh] = book_.emplace(name, "another output");
    if (!fresh) {
        throw InvalidInput(path + " is " + entry->second + " as well; choose another name");
    }
    const auto below = book_.lower_bound(name + "/");
    bool nests = below != book_.end() && below->first.starts_with(name + "/");
    for (fs::path above = name; above.has_relative_path() && !nests;) {
        above = above.parent_path();
        nests = book_.contains(above.string());
    }
    if (nests) {
        throw InvalidInput(path +
                           " lies in another file of the run, or holds one; choose another name");
    }
}

}  // namespace pcvt
