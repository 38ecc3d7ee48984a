#include "io/outputs/run_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <utility>

#include "io/bytes/output_error.hpp"
#include "io/outputs/file_calls.hpp"

namespace pcvt {
namespace {

/// Keeps a temporary name below 255 bytes, the longest name of a file.
constexpr std::size_t kLongestStem = 200;
constexpr std::string_view kMark = ".pcvt-";
constexpr std::string_view kNew = ".new";
constexpr std::string_view kOld = ".old";
constexpr std::string_view kLetters = "0123456789abcdefghijklmnopqrstuvwxyz";
constexpr std::size_t kTokenLength = 8;
/// More than the journal of a set of 100,000 files.
constexpr off_t kMostBytes = off_t(1) << 26;
/// How often a new token is taken, where a parallel run owns the name.
constexpr int kTokenAttempts = 100;

/// Returns letters and digits that differ from all recent results in this process, and almost
/// surely from all others.
std::string fresh_token() {
    static std::atomic<std::uint64_t> counter{0};
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    std::uint64_t value =
        (static_cast<std::uint64_t>(now) ^ static_cast<std::uint64_t>(::getpid()) << 40U) +
        counter.fetch_add(1) * 0x9E3779B97F4A7C15U;
    value = (value ^ value >> 31U) * 0xBF58476D1CE4E5B9U;
    value ^= value >> 29U;
    std::string token;
    for (std::size_t k = 0; k < kTokenLength; ++k, value /= kLetters.size()) {
        token += kLetters[value % kLetters.size()];
    }
    return token;
}

bool is_token(std::string_view text) {
    return text.size() == kTokenLength &&
           text.find_first_not_of(kLetters) == std::string_view::npos;
}

}  // namespace

std::string run_file_name(std::string_view token) { return std::string(kMark).append(token); }

std::string temporary_leaf(const std::string& name, std::string_view token, std::size_t k) {
    return ("." + name.substr(0, kLongestStem)).append(kMark).append(token) + "-" +
           std::to_string(k) + std::string(kNew);
}

std::optional<std::string> run_file_token(std::string_view leaf) {
    if (!leaf.starts_with(kMark)) return {};
    leaf.remove_prefix(kMark.size());
    if (!is_token(leaf)) return {};
    return std::string(leaf);
}

std::optional<std::string> temporary_token(std::string_view leaf) {
    if (!leaf.starts_with('.') || !leaf.ends_with(kNew)) return {};
    leaf.remove_suffix(kNew.size());
    const std::size_t mark = leaf.rfind(kMark);
    if (mark == std::string_view::npos || mark == 0) return {};
    leaf.remove_prefix(mark + kMark.size());
    const std::string_view token = leaf.substr(0, kTokenLength);
    if (!is_token(token) || leaf.size() < kTokenLength + 2 || leaf[kTokenLength] != '-') return {};
    const std::string_view number = leaf.substr(kTokenLength + 1);
    if (number.find_first_not_of("0123456789") != std::string_view::npos) return {};
    return std::string(token);
}

std::string backup_path(const std::string& temporary) {
    return temporary.substr(0, temporary.size() - kNew.size()).append(kOld);
}

RunFile::RunFile(std::string folder, std::string token)
    : folder_(std::move(folder)),
      token_(std::move(token)),
      path_(folder_ + "/" + run_file_name(token_)) {}

RunFile::RunFile(RunFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      token_(std::move(other.token_)),
      path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      owner_(std::exchange(other.owner_, RunFileOwner::kNobody)) {}

RunFile::~RunFile() { release(); }

RunFile RunFile::create(const std::string& folder, const std::string& target) {
    for (int attempt = 0;; ++attempt) {
        RunFile run(folder, fresh_token());
        int error = create_file(run.path_.c_str(), run.file_);
        if (error == 0) {
            run.owner_ = RunFileOwner::kThisProcess;
            error = try_lock(run.file_);
            // Where there are no locks, other runs cannot lock either and do not touch the file.
            if (error == 0 || lacks_locks(error)) return run;
            run.remove();
        }
        if (attempt == kTokenAttempts || (error != EEXIST && error != EWOULDBLOCK)) {
            throw OutputError(target + ": cannot write: " + reason_of(error));
        }
    }
}

RunFile RunFile::open(const std::string& folder, const std::string& token) {
    RunFile run(folder, token);
    const int error = open_file(run.path_.c_str(), run.file_);
    if (error == ENOENT) return run;
    run.owner_ = RunFileOwner::kLivingRun;
    // A file of another user may say anything about the files of this one.
    if (error != 0 || !is_of_this_user(run.file_)) return run;
    if (try_lock(run.file_) == 0) run.owner_ = RunFileOwner::kThisProcess;
    return run;
}

std::optional<std::string> RunFile::content_of(const std::string& folder,
                                               const std::string& token) {
    RunFile run(folder, token);
    const int error = open_file(run.path_.c_str(), run.file_);
    if (error == ENOENT || error == ENOTDIR) return "";
    if (error != 0) return {};
    return is_of_this_user(run.file_) ? run.read() : "";
}

std::optional<std::string> RunFile::read() const {
    struct stat status {};
    if (::fstat(file_, &status) != 0 || status.st_size > kMostBytes) return {};
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t n = 0;
    while (n < bytes.size()) {
        const ssize_t more = ::pread(file_, bytes.data() + n, bytes.size() - n, off_t(n));
        if (more < 0 && errno == EINTR) continue;
        if (more <= 0) return {};
        n += static_cast<std::size_t>(more);
    }
    return bytes;
}

int RunFile::write(std::string_view bytes) noexcept { return overwrite(file_, bytes); }

int RunFile::clear() noexcept {
    if (::ftruncate(file_, 0) == 0) return sync_file(file_), 0;
    const char invalid = '\0';
    if (::pwrite(file_, &invalid, 1, 0) == 1) return sync_file(file_), 0;
    return remove_name(path_.c_str());
}

void RunFile::remove() noexcept {
    remove_name(path_.c_str());
    release();
}

void RunFile::release() noexcept {
    close_file(file_);
    owner_ = RunFileOwner::kNobody;
}

}  // namespace pcvt
