#include "plugin/job/available_memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <vector>

namespace pcvt {
namespace {

constexpr double kKilobyte = 1024;

/// The number after `field` in a file of the form "field number" a line.
std::optional<double> number_of(const std::string& path, const std::string& field) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(field)) continue;
        return std::strtod(line.c_str() + field.size(), nullptr);
    }
    return std::nullopt;
}

/// The number that a file of a control group holds on its own; `nullopt` for "max".
std::optional<double> only_number(const std::string& path) {
    std::ifstream file(path);
    double number = 0;
    if (file >> number) return number;
    return std::nullopt;
}

std::optional<double> available_in_machine() {
    const auto kilobytes = number_of("/proc/meminfo", "MemAvailable:");
    if (!kilobytes) return std::nullopt;
    return kKilobyte * (*kilobytes + number_of("/proc/meminfo", "SwapFree:").value_or(0));
}

std::optional<double> available_address_space() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
    const double used = kKilobyte * number_of("/proc/self/status", "VmSize:").value_or(0);
    return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

/// The names of the files of a control group, in its two versions.
struct GroupFiles {
    const char* root;
    /// Before the path of the group in /proc/self/cgroup.
    const char* controller;
    const char* limit;
    const char* used;
    /// The field of memory.stat for the memory that the kernel takes back when it is needed.
    const char* cache;
};
constexpr GroupFiles kGroupFiles[] = {
    {"/sys/fs/cgroup", "0::", "/memory.max", "/memory.current", "inactive_file "},
    {"/sys/fs/cgroup/memory", ":memory:", "/memory.limit_in_bytes", "/memory.usage_in_bytes",
     "total_inactive_file "},
};

/// The folders of the groups that hold this process, the innermost first.
std::vector<std::string> group_folders(const GroupFiles& files) {
    std::vector<std::string> folders;
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        const std::size_t at = line.find(files.controller);
        if (at == std::string::npos) continue;
        std::string path = line.substr(line.find('/', at));
        while (path.size() > 1) {
            folders.push_back(files.root + path);
            path.resize(std::max<std::size_t>(1, path.rfind('/')));
        }
    }
    // Within a container the group of the container is the root.
    folders.emplace_back(files.root);
    return folders;
}

std::optional<double> available_in_groups() {
    std::optional<double> least;
    for (const GroupFiles& files : kGroupFiles) {
        for (const std::string& folder : group_folders(files)) {
            const auto limit = only_number(folder + files.limit);
            if (!limit) continue;
            const double used = only_number(folder + files.used).value_or(0) -
                                number_of(folder + "/memory.stat", files.cache).value_or(0);
            least = std::min(least.value_or(*limit), std::max(0.0, *limit - used));
        }
    }
    return least;
}

}  // namespace

std::optional<double> available_memory() {
    std::optional<double> least;
    for (const auto& part :
         {available_in_machine(), available_address_space(), available_in_groups()}) {
        if (part) least = std::min(least.value_or(*part), *part);
    }
    return least;
}

std::optional<double> peak_memory() {
    const auto kilobytes = number_of("/proc/self/status", "VmHWM:");
    if (!kilobytes) return std::nullopt;
    return kKilobyte * *kilobytes;
}

}  // namespace pcvt
