#include "io/run_files/area_reader.hpp"

#include <algorithm>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "mesher/cells/target_areas.hpp"

namespace pcvt {
namespace {

/// Sizes whose squares are numbers.
constexpr double kLeastSize = 1e-150;
constexpr double kLargestSize = 1e150;

double parse_size(const LineScanner& scanner, std::string_view word) {
    const double size = scanner.number(word);
    if (size >= kLeastSize && size <= kLargestSize) return size;
    scanner.throw_bad_file(in_quotes(word) +
                           " is no size of a cell; give a number from 1e-150 to 1e150");
}

BadFile at_line(const AreaFile& file, int line, const std::string& complaint) {
    return BadFile(file.name + ":" + std::to_string(line) + ": " + complaint);
}

}  // namespace

AreaFile parse_areas(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text with one area a line");
    AreaFile file{name, {}, {}};
    std::vector<double> sizes;
    bool are_diameters = false;
    LineScanner scanner(name, text);
    while (scanner.next()) {
        const std::vector<std::string_view> words = words_before_comment(scanner);
        if (words.empty()) continue;
        if (words.size() > 1) {
            scanner.throw_bad_file("this line has " + std::to_string(words.size()) +
                                   " words; write one area a line");
        }
        if (words[0] == "diameter" && sizes.empty() && !are_diameters) {
            are_diameters = true;
            continue;
        }
        sizes.push_back(parse_size(scanner, words[0]));
        file.lines.push_back(scanner.line());
    }
    if (sizes.empty()) throw BadFile(name + ": holds no area; give one a line, one for each site");
    file.areas = Eigen::Map<const Eigen::VectorXd>(sizes.data(), std::ssize(sizes));
    if (are_diameters) file.areas = areas_of_diameters(file.areas);
    return file;
}

AreaFile read_areas(const std::string& path) {
    return parse_areas(path, read_whole_file(path, kSiteInput));
}

void require_areas(const AreaFile& file, int n_sites) {
    const auto n = static_cast<int>(file.areas.size());
    if (n < n_sites) {
        throw at_line(file, file.lines.back(),
                      "the last of " + std::to_string(n) + " areas, but there are " +
                          std::to_string(n_sites) + " sites; give one area for each site");
    }
    if (n > n_sites) {
        throw at_line(file, file.lines[static_cast<std::size_t>(n_sites)],
                      "area " + std::to_string(n_sites + 1) + ", but there are " +
                          std::to_string(n_sites) + " sites; give one area for each site");
    }
    Eigen::Index smallest = 0;
    const Eigen::VectorXd relative = file.areas / file.areas.maxCoeff();
    if (relative.minCoeff(&smallest) >= kLeastArea * relative.mean()) return;
    throw at_line(file, file.lines[static_cast<std::size_t>(smallest)],
                  "the area is below 1e-6 of the mean; give a larger one");
}

}  // namespace pcvt
