#include "plugin/job_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "io/triangle_elements.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

[[noreturn]] void refuse_extension(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    const bool later =
        !extension.empty() && (later_extensions() + " ").find(extension + " ") != std::string::npos;
    const std::string what = later ? "the format " + extension + " is not available yet"
                             : extension.empty() ? "no extension"
                                                 : "unknown extension " + extension;
    throw InvalidInput("-o " + path + ": " + what + "; take one of " + output_extensions());
}

const char* kind_suffix(TileKind kind) {
    switch (kind) {
        case TileKind::kCells:
            return "-voronoi";
        case TileKind::kTriangles:
            return "-delaunay";
        case TileKind::kGrains:
            return "-grains";
    }
    return "";
}

void add_output(const Job& job, const std::string& path, std::vector<JobFile>& files) {
    if (lower_case_extension(path) == ".txt") {
        files.push_back({{path}, nullptr, -1});
        return;
    }
    const TileFormat* format = find_tile_format(path);
    if (format == nullptr) refuse_extension(path);
    for (std::size_t m = 0; m < job.meshes.size(); ++m) {
        if (format->triangles_only) require_triangles(job.meshes[m], "-o " + path);
        const std::string suffix = job.meshes.size() > 1 ? kind_suffix(job.meshes[m]) : "";
        files.push_back({format->paths(with_suffix(path, suffix)), format, static_cast<int>(m)});
    }
}

/// One name for a file, however it is written.
std::string identity(const std::string& path) {
    std::error_code ignored;
    fs::path canonical = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    if (ignored) canonical = fs::path(path).lexically_normal();
    return canonical.string();
}

/// Every path of the job once: the inputs, the files, the report.
class PathBook {
   public:
    void add_input(const std::string& path) { book_.emplace(identity(path), "an input"); }
    void add_output(const std::string& path) {
        const auto [entry, fresh] = book_.emplace(identity(path), "another output");
        if (!fresh) {
            throw InvalidInput(path + " is " + entry->second + " as well; take another name");
        }
    }

   private:
    std::map<std::string, std::string> book_;
};

}  // namespace

std::string output_extensions() {
    std::string all;
    for (const TileFormat& format : tile_formats()) all += format.extension + " ";
    return all + ".txt";
}

std::string readable_extensions() {
    std::string all;
    for (const TileFormat& format : tile_formats()) {
        if (format.decode == nullptr) continue;
        all += (all.empty() ? "" : " ") + format.extension;
    }
    return all;
}

std::string later_extensions() { return ".nc .foam"; }

std::string with_suffix(const std::string& path, const std::string& suffix) {
    const std::size_t extension = fs::path(path).extension().string().size();
    return path.substr(0, path.size() - extension) + suffix + path.substr(path.size() - extension);
}

std::vector<JobFile> plan_files(const Job& job) {
    std::vector<JobFile> files;
    for (const std::string& path : job.outputs) add_output(job, path, files);
    PathBook book;
    for (const std::string& path : job.inputs) book.add_input(path);
    for (const JobFile& file : files) {
        for (const std::string& path : file.paths) book.add_output(path);
    }
    if (!job.report.empty()) book.add_output(job.report);
    return files;
}

}  // namespace pcvt
