#pragma once

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

}  // namespace pcvt
