#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"
#include "tests/support/refusal.hpp"

namespace pcvt::testing {

/// Returns the message of the BadFile that read() throws, or an empty string if it does not throw.
template <class Read>
std::string fault_in(const Read& read) {
    return refusal_of<BadFile>(read);
}

/// Returns the text with its first `piece`, which must exist, replaced.
inline std::string exchanged(std::string text, const std::string& piece, const std::string& other) {
    const auto place = text.find(piece);
    EXPECT_NE(place, std::string::npos) << piece;
    return place == std::string::npos ? text : text.replace(place, piece.size(), other);
}

/// Returns the files with the first `piece` replaced in each one whose path ends with `name`.
inline std::vector<EncodedFile> exchanged(std::vector<EncodedFile> files, const std::string& name,
                                          const std::string& piece, const std::string& other) {
    for (EncodedFile& file : files) {
        if (file.path.ends_with(name)) file.bytes = exchanged(file.bytes, piece, other);
    }
    return files;
}

}  // namespace pcvt::testing
