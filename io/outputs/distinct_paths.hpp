#pragma once

#include <map>
#include <string>

namespace pcvt {

/// Every path of a run once: its inputs and its outputs, under whatever names.
class DistinctPaths {
   public:
    void add_input(const std::string& path);
    /// @throws InvalidInput if the path is an input or another output as well, if one of them would
    ///         be a folder of the other, or if the name holds a control character.
    void add_output(const std::string& path);

   private:
    std::map<std::string, std::string> book_;
};

}  // namespace pcvt
