#pragma once

#include "tests/mutants/mutants.hpp"

namespace pcvt::testing {

/// The characters that separate the words of VTK's XML files, beside blanks.
inline constexpr std::string_view kXmlSeparators = "<>\"=/";

/// Names the words of VTK's XML files: those of a tag by the tag, the values of an array by the
/// array. Data in base64 have no names.
class XmlNamer {
   public:
    LineNames operator()(const std::vector<std::string_view>& words);

   private:
    LineNames names_of_tag(const std::vector<std::string_view>& words);

    std::string array_;
    bool is_binary_ = false;
};

}  // namespace pcvt::testing
