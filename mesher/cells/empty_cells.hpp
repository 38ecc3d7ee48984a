#pragma once

#include <string>
#include <vector>

#include "mesher/base/error.hpp"

namespace pcvt {

/// Sites whose power cells are empty, because their weights are too small beside those of their
/// neighbours: all of them, or as many as are named.
class EmptyCells : public InvalidInput {
   public:
    static constexpr std::size_t kMostNamed = 20;

    /// @param sites  ids from 0, at least one.
    explicit EmptyCells(std::vector<int> sites);

    const std::vector<int>& sites() const { return sites_; }

   private:
    std::vector<int> sites_;
};

/// A cell that is too small beside the spacing to have corners that differ.
class TinyCell : public InvalidInput {
   public:
    /// @param site    an id from 0.
    /// @param remedy  the end of the message.
    TinyCell(int site, const std::string& remedy);

    int site() const { return site_; }

   private:
    int site_;
};

}  // namespace pcvt
