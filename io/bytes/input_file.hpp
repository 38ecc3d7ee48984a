#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

/// The most that is read of a file of some kind.
struct InputLimit {
    std::uint64_t bytes;
    /// The same number for messages.
    const char* words;
    /// The end of the message.
    const char* remedy;
    /// The reader refuses a text at its first NUL byte, and reads nothing after it.
    bool ends_at_nul;
};
constexpr std::uint64_t kMebibyte = std::uint64_t(1) << 20;
constexpr InputLimit kTileInput{4096 * kMebibyte, "4 GiB", "give a smaller mesh", false};
constexpr InputLimit kSiteInput{16384 * kMebibyte, "16 GiB", "give fewer sites", true};
constexpr InputLimit kMaterialInput{64 * kMebibyte, "64 MiB", "give the section phase alone", true};
constexpr InputLimit kTableInput{1024 * kMebibyte, "1 GiB", "give fewer runs", true};
/// More than the size of the largest picture with 64 bits a pixel, not compressed.
constexpr InputLimit kPictureInput{256 * kMebibyte, "256 MiB", "scale the image down", false};
constexpr InputLimit kStandardInput{1024 * kMebibyte, "1 GiB", "give a file", true};

/// Returns all bytes of a regular file. Every file that pcvt reads is opened here: folders, pipes,
/// devices and sockets are refused at once, because they have no end or never give a byte.
///
/// Example usage:
///     const std::string bytes = read_whole_file("sites.txt", kSiteInput);
///
/// @throws BadFile        `path: cannot read: reason; give a readable file`.
/// @throws LimitExceeded  the file is larger than the limit.
std::string read_whole_file(const std::string& path, const InputLimit& limit = kTileInput);

/// Returns all bytes of standard input, up to kStandardInput, from a terminal, a file or a pipe.
/// @throws BadFile, LimitExceeded as read_whole_file() does.
std::string read_standard_input();

/// Returns whether the file consists of exactly these bytes. The file is read block by block,
/// because a second copy of a large file in memory would cost more than the reading.
/// @throws BadFile as read_whole_file() does.
bool file_holds(const std::string& path, std::string_view bytes);

}  // namespace pcvt
