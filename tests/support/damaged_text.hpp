#pragma once

#include <gtest/gtest.h>

#include <string>

#include "io/tiles/tile_file.hpp"

namespace pcvt::testing {

/// What BadFile says that read() throws; empty where it throws none.
template <class Read>
std::string fault_in(const Read& read) {
    try {
        read();
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

/// The text with the first `piece`, which must be there, exchanged.
inline std::string exchanged(std::string text, const std::string& piece, const std::string& other) {
    const auto place = text.find(piece);
    EXPECT_NE(place, std::string::npos) << piece;
    return place == std::string::npos ? text : text.replace(place, piece.size(), other);
}

}  // namespace pcvt::testing
