#include "io/report.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "io/text.hpp"

namespace pcvt {
namespace {

std::string word(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string word(int value) { return std::to_string(value); }

std::string word(const std::string& value) {
    return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <class Number>
std::string word(const std::optional<Number>& value) {
    return value ? word(*value) : "null";
}

std::string word(const Vec2& v) { return "[" + word(v.x()) + ", " + word(v.y()) + "]"; }

std::string word(const std::map<int, int>& counts) {
    std::string text;
    for (const auto& [key, count] : counts) {
        text += text.empty() ? "{" : ", ";
        text += "\"" + std::to_string(key) + "\": " + std::to_string(count);
    }
    return text.empty() ? "{}" : text + "}";
}

std::string word(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& entry : words) text += (text.empty() ? "[" : ", ") + word(entry);
    return text.empty() ? "[]" : text + "]";
}

std::string word(const Report::Seconds& s) {
    return "{\"build\": " + word(s.build) + ", \"optimize\": " + word(s.optimize) +
           ", \"write\": " + word(s.write) + ", \"total\": " + word(s.total) + "}";
}

}  // namespace

std::string encode_report(const Report& report) {
    std::vector<std::pair<std::string, std::string>> entries{
        {"version", word(report.version)},
        {"sites", std::to_string(report.sites)},
        {"lattice", "[" + word(report.lattice.a()) + ", " + word(report.lattice.b()) + "]"},
        {"seed", std::to_string(report.seed)},
        {"solver", word(report.solver)},
        {"start", word(report.start)},
        {"stop", word(report.stop)},
        {"iterations", std::to_string(report.iterations)},
        {"evaluations", std::to_string(report.evaluations)},
        {"energy", word(report.energy)},
        {"energy_bound", word(report.energy_bound)},
        {"residual", word(report.residual)},
        {"hexagons", std::to_string(report.hexagons)},
        {"valences", word(report.valences)},
        {"mirrors", word(report.mirrors)},
        {"threads", std::to_string(report.threads)},
        {"seconds", word(report.seconds)},
        {"files", word(report.files)},
    };
    if (report.density) {
        const Report::Density& density = *report.density;
        entries.insert(entries.end(), {{"density", word(density.name)},
                                       {"density_least", word(density.least)},
                                       {"density_greatest", word(density.greatest)},
                                       {"density_evaluations", word(density.evaluations_per_site)},
                                       {"mass", word(density.mass)},
                                       {"mass_deviation", word(density.mass_deviation)},
                                       {"expected_energy", word(density.expected_energy)},
                                       {"spacing_deviation", word(density.spacing_deviation)},
                                       {"quadrature_error", word(density.quadrature_error)},
                                       {"rough_cells", word(density.rough_cells)}});
    }
    std::string text;
    for (const auto& [key, value] : entries) {
        text += (text.empty() ? "{\n  \"" : ",\n  \"") + key + "\": " + value;
    }
    return text + "\n}\n";
}

}  // namespace pcvt
