#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/outputs/file_moves.hpp"

namespace pcvt {

/// The complete list of the moves of a set, as one of its run files stores it. It is valid once its
/// checksum is, which makes its last byte on the disk the point of no return of a commit. The other
/// run files of the set hold a pointer to it.
struct Journal {
    struct Folder {
        /// Absolute; empty for the folder of the journal itself, so that this folder may be
        /// renamed.
        std::string path;
        /// The token of the set in that folder.
        std::string token;
    };
    struct Move {
        FileMove::Kind kind = FileMove::Kind::kNewFile;
        std::size_t folder = 0;
        /// The name of the temporary file in the folder.
        std::string temporary;
        /// The target, relative to the folder.
        std::string target;
        FileStamp fresh;
        FileStamp old;
    };
    std::vector<Folder> folders;
    std::vector<Move> moves;
};

std::string encode_journal(const Journal& journal);
/// Returns nothing for bytes that are not a complete journal, and for one that names anything
/// outside of its folders.
std::optional<Journal> decode_journal(std::string_view bytes);

/// The pointer to the run file that holds the journal.
std::string encode_pointer(const std::string& run_file);
std::optional<std::string> decode_pointer(std::string_view bytes);

}  // namespace pcvt
