#pragma once

#include <string>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// The characters of a number that Abaqus and CalculiX read; they ignore all further ones.
inline constexpr std::size_t kFixedWidth = 20;

/// Numbers of at most 20 characters: the shortest that read back as the value where they fit, else
/// the nearest that fit.
class FixedWidthNumbers {
   public:
    /// @param largest  the largest number to come, by its absolute value; above 0.
    explicit FixedWidthNumbers(double largest);

    /// @returns false, and does not change `text`, where the value would be off by more than half
    ///          an ulp of the largest number.
    /// @throws InternalError if it is not finite.
    bool append(std::string& text, double value) const;

   private:
    double allowed_;
};

}  // namespace pcvt
