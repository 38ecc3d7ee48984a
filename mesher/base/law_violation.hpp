#pragma once

#include <string>

#include "mesher/base/error.hpp"

namespace pcvt {

/// A tile violates one of its laws; the message states the law, the place and the amount.
class NotATile : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// Boundary edges or triangles have no partner within the tolerance.
class SeamMismatch : public NotATile {
   public:
    SeamMismatch(const std::string& what, double mismatch) : NotATile(what), mismatch_(mismatch) {}

    /// The largest distance of such an edge or triangle from the nearest image of another, in one
    /// coordinate, length units. Infinite if it was not measured.
    double mismatch() const { return mismatch_; }

   private:
    double mismatch_;
};

/// The name of the laws of sites, in the plane and in space, in messages.
inline constexpr const char* kSiteLaw = "of the sites";

/// The message of a violation, "law <law>: <what>".
std::string violation_in_words(const std::string& law, const std::string& what);

/// Throws NotATile with violation_in_words().
///
/// Example usage:
///   throw_violation("(2), seam", "edge " + edge_in_words(3, 4) + " has no partner");
[[noreturn]] void throw_violation(const std::string& law, const std::string& what);

/// Formats an amount for a message: "1.23e-09".
std::string in_words(double amount);
/// Formats an edge for a message: "3 -> 4".
std::string edge_in_words(int from, int to);

}  // namespace pcvt
