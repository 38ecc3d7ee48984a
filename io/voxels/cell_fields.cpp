#include "io/voxels/cell_fields.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kFieldBlanks = " \t\r\n";

/// The arrays, with the numbers of a tuple in the plane and in space.
struct FieldForm {
    std::string_view name;
    int width;
    int width_in_space;
};
constexpr std::array<FieldForm, 4> kForms{
    {{"PeriodicLattice", 2, 3}, {"SitePositions", 2, 3}, {"SiteWeights", 1, 1}, {"Metric", 2, 4}}};

constexpr const char* kRemedy = "write the file again with pcvt";

}  // namespace

bool CellFields::begin(const XmlScanner& scanner) {
    const std::string name(scanner.attribute("Name").value_or(""));
    const auto* const row = std::find_if(kForms.begin(), kForms.end(),
                                         [&](const FieldForm& form) { return form.name == name; });
    if (row == kForms.end()) return false;
    const std::string_view format = scanner.attribute("format").value_or("ascii");
    // Other programs may have written the array again in such a form, which is not read here.
    if (format == "binary" || format == "appended") return false;
    const std::optional<double> n_tuples = number_attribute(scanner, "NumberOfTuples");
    const double width = number_attribute(scanner, "NumberOfComponents").value_or(1);
    const bool has_width = width == row->width || width == row->width_in_space;
    if (format != "ascii" || scanner.attribute("type") != "Float64" || !has_width || !n_tuples) {
        scanner.throw_bad_file(
            scanner.line(),
            "the array " + name + " has not the type, format or size of its kind; " + kRemedy);
    }
    const auto [field, is_new] =
        fields_.emplace(name, Field{scanner.line(), width, *n_tuples * width, {}});
    if (!is_new) {
        scanner.throw_bad_file(scanner.line(), "the array " + name + " is there twice; remove one");
    }
    last_ = &field->second;
    return true;
}

void CellFields::refuse(const std::string& file, const std::string& name,
                        const std::string& complaint) const {
    const auto found = fields_.find(name);
    const int line = found == fields_.end() ? 1 : found->second.line;
    throw BadFile(file + ":" + std::to_string(line) + ": " + complaint);
}

/// The numbers of an array; empty if there is none.
std::vector<double> CellFields::numbers(const std::string& file, const std::string& name) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) return {};
    std::vector<double> values;
    try {
        for (const std::string_view word : words_of(found->second.text)) {
            values.push_back(parse_number(word));
        }
    } catch (const InvalidInput& fault) {
        refuse(file, name, fault.what());
    }
    if (static_cast<double>(values.size()) != found->second.n_numbers) {
        refuse(file, name,
               "the array " + name + " has not as many numbers as its tag states; " + kRemedy);
    }
    return values;
}

bool CellFields::are_in_space() const {
    return std::any_of(fields_.begin(), fields_.end(),
                       [](const auto& named) { return named.second.width == 3; });
}

CellFields::Numbers CellFields::all_numbers(const std::string& file, std::size_t dimension) const {
    Numbers all{.lattice = numbers(file, "PeriodicLattice"),
                .sites = numbers(file, "SitePositions"),
                .weights = numbers(file, "SiteWeights"),
                .metric = numbers(file, "Metric")};
    if (all.lattice.empty() || all.sites.empty()) {
        throw BadFile(file + ": has not both of the arrays PeriodicLattice and SitePositions; " +
                      kRemedy + ", or remove the arrays of the sites");
    }
    const auto width = static_cast<double>(dimension);
    for (const char* const name : {"PeriodicLattice", "SitePositions"}) {
        if (fields_.at(name).width == width) continue;
        refuse(file, name,
               "the lattice and the sites have not equally many coordinates; correct "
               "them");
    }
    if (all.lattice.size() != dimension * dimension) {
        refuse(file, "PeriodicLattice",
               std::string("the lattice has not ") + (dimension == 2 ? "two" : "three") +
                   " vectors; correct it");
    }
    if (!all.weights.empty() && all.weights.size() != all.sites.size() / dimension) {
        refuse(file, "SiteWeights", "there is not one weight a site; correct them");
    }
    return all;
}

space::VoxelCells CellFields::cells_in_space(const std::string& file) const {
    const auto [lattice, sites, weights, metric] = all_numbers(file, 3);
    if (!metric.empty() && metric.size() != 4) {
        refuse(file, "Metric", "the metric has not a ratio and an axis; correct it");
    }
    const auto n = static_cast<Eigen::Index>(sites.size() / 3);
    try {
        const space::Lattice periods({lattice[0], lattice[1], lattice[2]},
                                     {lattice[3], lattice[4], lattice[5]},
                                     {lattice[6], lattice[7], lattice[8]});
        const space::Points points = Eigen::Map<const space::Points>(sites.data(), 3, n);
        // Refuses too many sites, and sites that coincide or lie too far away.
        const space::Sites checked(periods, points);
        return {.lattice = periods,
                .sites = points,
                .weights =
                    Eigen::Map<const Eigen::VectorXd>(weights.data(), Eigen::Index(weights.size())),
                .metric = metric.empty()
                              ? space::Metric()
                              : space::Metric(metric[0], {metric[1], metric[2], metric[3]})};
    } catch (const InvalidInput& fault) {
        refuse(file, "SitePositions", fault.what());
    }
}

plane::VoxelCells CellFields::cells(const std::string& file) const {
    const auto [lattice, sites, weights, metric] = all_numbers(file, 2);
    if (!metric.empty() && metric.size() != 2) {
        refuse(file, "Metric", "the metric has not a ratio and an angle; correct it");
    }
    const auto n = static_cast<Eigen::Index>(sites.size() / 2);
    try {
        const plane::Lattice periods({lattice[0], lattice[1]}, {lattice[2], lattice[3]});
        const plane::Points points = Eigen::Map<const plane::Points>(sites.data(), 2, n);
        // Refuses too many sites, and sites that coincide or lie too far away.
        const plane::Sites checked(periods, points);
        return {.lattice = periods,
                .sites = points,
                .weights =
                    Eigen::Map<const Eigen::VectorXd>(weights.data(), Eigen::Index(weights.size())),
                .metric = metric.empty() ? plane::Metric() : plane::Metric(metric[0], metric[1])};
    } catch (const InvalidInput& fault) {
        refuse(file, "SitePositions", fault.what());
    }
}

std::optional<double> number_attribute(const XmlScanner& scanner, std::string_view key) {
    const std::optional<std::string_view> word = scanner.attribute(key);
    if (!word) return {};
    try {
        return parse_number(*word);
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(scanner.line(), fault.what());
    }
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (true) {
        checkpoint_each(static_cast<long>(words.size()));
        text.remove_prefix(std::min(text.find_first_not_of(kFieldBlanks), text.size()));
        if (text.empty()) return words;
        words.push_back(text.substr(0, text.find_first_of(kFieldBlanks)));
        text.remove_prefix(words.back().size());
    }
}

}  // namespace pcvt
