#pragma once

#include <string>
#include <vector>

#include "io/colours/colouring.hpp"

namespace pcvt {

/// The words of a legend of values.
struct ValueWords {
    /// The beginning of the classes' names, before their number.
    std::string name;
    int digits;
    /// Follows the values.
    std::string unit;
};

/// Classes of one ratio of values, which are given by their logarithms to the base 2: up to
/// kValueClasses, of the least ratio of 2^(1/16), 2^(1/8), 2^(1/4), ... that suffices.
///
/// Example usage:
///     const ValueClasses sizes(octaves, {"size", 2, " h"});
///     for (const double octave : octaves) colours.class_of.push_back(sizes.of(octave));
///     colours.classes = sizes.classes();
class ValueClasses {
   public:
    /// @param octaves  of all values that the legend counts, at least one.
    ValueClasses(const std::vector<double>& octaves, const ValueWords& words);

    /// The index of the class of a value.
    int of(double octave) const;
    const std::vector<ColourClass>& classes() const { return classes_; }

   private:
    double width_;
    int lowest_ = 0;
    std::vector<ColourClass> classes_;
};

}  // namespace pcvt
