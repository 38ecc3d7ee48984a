#include "io/run_files/material_file.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/bytes/text.hpp"
#include "io/run_files/yaml_reader.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

constexpr const char* kFileForm =
    "write phase: {NAME: {mechanical: {elastic: {type: Hooke, C_11: ..., C_12: ..., C_44: ...}}}}";

/// Keys of each set of constants, in the order of ElasticConstants.
constexpr std::array<std::array<std::string_view, 5>, 3> kKeys{
    {{"E", "nu"}, {"C_11", "C_12", "C_44"}, {"C_11", "C_12", "C_13", "C_33", "C_44"}}};

std::string lower_case(std::string_view text) {
    std::string word(text);
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word;
}

std::string place(const std::string& name, int line) {
    return name + ":" + std::to_string(line) + ": ";
}

/// Whether a key is a constant, and not one of its coefficients of the temperature.
bool is_constant(std::string_view key) {
    return key == "E" || lower_case(key) == "nu" ||
           (key.starts_with("C_") && key.find(',') == std::string_view::npos);
}

/// The value of a constant, by its key without regard to the case of nu.
const YamlValue* find_constant(const YamlValue& elastic, std::string_view key) {
    const auto found =
        std::find_if(elastic.members.begin(), elastic.members.end(), [&](const auto& member) {
            return member.first == key || (key == "nu" && lower_case(member.first) == key);
        });
    return found == elastic.members.end() ? nullptr : &found->second;
}

/// The constants with all keys of a set, if these are the constants of the law.
std::optional<std::vector<double>> numbers_of(const YamlValue& elastic,
                                              std::span<const std::string_view> keys) {
    const auto n_constants =
        std::count_if(elastic.members.begin(), elastic.members.end(),
                      [](const auto& member) { return is_constant(member.first); });
    std::vector<double> numbers;
    for (const std::string_view key : keys) {
        if (key.empty()) break;
        const YamlValue* const value = find_constant(elastic, key);
        if (value == nullptr) return std::nullopt;
        numbers.push_back(parse_number(value->text));
    }
    if (std::ssize(numbers) != n_constants) return std::nullopt;
    return numbers;
}

/// The constants of a law.
/// @throws InvalidInput with the remedy.
ElasticConstants constants_of(const YamlValue& elastic) {
    const YamlValue* const type = elastic.find("type");
    if (type != nullptr && lower_case(type->text) != "hooke") {
        throw InvalidInput("the elastic law " + in_quotes(type->text) +
                           " is not supported; take the type Hooke");
    }
    // In braces a decimal comma ends an entry: {C_12: 60,5} is C_12: 60 and a key 5.
    for (const auto& [key, value] : elastic.members) {
        if (!value.text.empty() || value.is_mapping || value.is_list) continue;
        throw InvalidInput("the key " + in_quotes(key) +
                           " has no value; give it one, and write decimals with a point");
    }
    for (const auto& keys : kKeys) {
        if (auto numbers = numbers_of(elastic, keys)) return checked_constants(std::move(*numbers));
    }
    throw InvalidInput(
        "the constants are not those of a material that pcvt knows; give C_11, C_12, C_44, or "
        "C_11, C_12, C_13, C_33, C_44, or E, nu");
}

/// A material of a file, or its fault.
FileMaterial material_of(const std::string& file, const std::string& phase,
                         const YamlValue& value) {
    FileMaterial material{.name = phase, .file = file};
    const YamlValue* const mechanical = value.find("mechanical");
    const YamlValue* const elastic = mechanical == nullptr ? nullptr : mechanical->find("elastic");
    if (elastic == nullptr || !elastic->is_mapping) {
        material.fault =
            place(file, value.line) + "the phase " + in_quotes(phase) +
            " has no elastic constants; add mechanical: {elastic: {type: Hooke, C_11: ...}}";
        return material;
    }
    try {
        material.constants = constants_of(*elastic);
    } catch (const InvalidInput& error) {
        material.fault = place(file, elastic->line) + error.what();
    }
    return material;
}

}  // namespace

void add_material_file(const std::string& name, std::string_view text, ElasticChoices& choices) {
    const YamlValue file = parse_yaml(name, text);
    const YamlValue* const phases = file.find("phase");
    if (phases == nullptr || !phases->is_mapping || phases->members.empty()) {
        throw BadFile(name + ": holds no phase; " + kFileForm);
    }
    for (const auto& [phase, value] : phases->members) {
        choices.of_files.push_back(material_of(name, phase, value));
    }
}

}  // namespace pcvt
