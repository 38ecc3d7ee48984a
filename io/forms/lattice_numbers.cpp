#include "io/forms/lattice_numbers.hpp"

#include "io/bytes/text.hpp"
#include "io/forms/tile_file.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {

std::vector<int> offset_in_name(std::string_view name) {
    std::vector<int> numbers;
    if (!name.starts_with(kSeamSet)) return numbers;
    name.remove_prefix(kSeamSet.size() - 1);
    while (name.starts_with('_')) {
        name.remove_prefix(1);
        const std::string_view word = name.substr(0, name.find('_'));
        try {
            numbers.push_back(parse_integer(word));
        } catch (const InvalidInput&) {
            return {};
        }
        if (numbers.back() < -kLargestOffset || numbers.back() > kLargestOffset) return {};
        name.remove_prefix(word.size());
    }
    return numbers;
}

}  // namespace pcvt
