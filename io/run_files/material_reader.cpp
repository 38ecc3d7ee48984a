#include "io/run_files/material_reader.hpp"

#include <algorithm>

#include "io/bytes/input_file.hpp"
#include "io/run_files/material_file.hpp"

namespace pcvt {
namespace {

bool is_file_name(std::string_view line) {
    return line.ends_with(".yaml") || line.ends_with(".yml") || line.ends_with(".YAML") ||
           line.ends_with(".YML");
}

std::string_view trimmed(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(kBlanks) + 1 - begin);
}

}  // namespace

ElasticChoices read_elastic_choices(std::string_view text, std::vector<std::string>& files) {
    std::string entries;
    ElasticChoices of_files;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
        if (is_file_name(line)) {
            files.emplace_back(line);
            add_material_file(files.back(), read_whole_file(files.back(), kMaterialInput),
                              of_files);
        } else {
            entries += std::string(line) + "\n";
        }
    }
    if (trimmed(entries).find_first_not_of('\n') == std::string_view::npos && !files.empty()) {
        return of_files;
    }
    ElasticChoices choices = parse_elastic_choices(entries);
    choices.of_files = std::move(of_files.of_files);
    require_one_choice(choices);
    return choices;
}

}  // namespace pcvt
