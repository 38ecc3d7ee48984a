#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pcvt {

/// One file of an output. A format may write companions beside the file that the user named.
struct EncodedFile {
    std::string path;
    std::string bytes;
};

/// The list of one file; from braces its bytes would be copied.
inline std::vector<EncodedFile> only_file(std::string path, std::string bytes) {
    std::vector<EncodedFile> files;
    files.push_back({std::move(path), std::move(bytes)});
    return files;
}

/// Requires that files are, byte for byte, those that pcvt writes for the content that was read
/// from them. Companions may be missing.
/// @throws BadFile  naming the first line that differs.
void require_same_bytes(const std::vector<EncodedFile>& files,
                        const std::vector<EncodedFile>& wanted);

}  // namespace pcvt
