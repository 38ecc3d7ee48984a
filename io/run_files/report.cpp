#include "io/run_files/report.hpp"

#include <utility>

#include "io/bytes/json.hpp"
#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

std::string word(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string word(int value) { return std::to_string(value); }

std::string word(const std::string& value) {
    std::string json;
    append_json_string(json, value);
    return json;
}

std::string word(const plane::Vec2& v) { return "[" + word(v.x()) + ", " + word(v.y()) + "]"; }

std::string word(const Report::Grains& grains) {
    std::string corners;
    for (const Report::SharpCorner& corner : grains.sharp_corners) {
        corners += corners.empty() ? "[" : ", ";
        corners += "[" + word(corner.site) + ", " + word(corner.point.x()) + ", " +
                   word(corner.point.y()) + ", " + word(corner.angle) + "]";
    }
    return "{\"triangles\": " + word(grains.triangles) +
           ", \"smallest_angle\": " + word(grains.smallest_angle) +
           ", \"sharp_corners\": " + (corners.empty() ? "[]" : corners + "]") + "}";
}

template <class Number>
std::string word(const std::optional<Number>& value) {
    return value ? word(*value) : "null";
}

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

std::string word(const plane::Lattice& lattice) {
    return "[" + word(lattice.a()) + ", " + word(lattice.b()) + "]";
}

/// The last keys of a pattern of the plane or of space.
template <class Pattern>
std::string verdict_words(const Pattern& pattern) {
    return ", \"minimum\": " + word(pattern.minimum) +
           ", \"smallest_eigenvalue\": " + word(pattern.smallest_eigenvalue);
}

std::string word(const Report::Pattern& pattern) {
    const auto [a, b, d] = pattern.hermite;
    return "{\"basis\": " + word(pattern.basis) + ", \"hermite\": [" + word(a) + ", " + word(b) +
           ", " + word(d) + "], \"energy\": " + word(pattern.energy) + verdict_words(pattern) + "}";
}

std::string word(const Report::Areas& areas) {
    return "{\"law\": " + word(areas.law) +
           (areas.scale ? ", \"scale\": " + word(*areas.scale) : "") +
           ", \"std_over_mean\": " + word(areas.std_over_mean) +
           ", \"largest_relative_error\": " + word(areas.largest_relative_error) +
           ", \"largest_relative_mesh_error\": " + word(areas.largest_relative_mesh_error) +
           ", \"newton_steps\": " + word(areas.newton_steps) +
           ", \"circularity_mean\": " + word(areas.circularity_mean) +
           ", \"circularity_std\": " + word(areas.circularity_std) + "}";
}

std::string word(const Report::Aspect& aspect) {
    return "{\"ratio\": " + word(aspect.ratio) + ", \"degrees\": " + word(aspect.degrees) + "}";
}

std::string word(const Report::Phase& phase) {
    return "{\"name\": " + word(phase.name) + ", \"wanted\": " + word(phase.wanted) +
           ", \"reached\": " + word(phase.reached) + ", \"cells\": " + word(phase.cells) + "}";
}

std::string word(const Report::Symmetry& symmetry) {
    return "{\"group\": " + word(symmetry.group) +
           ", \"orbits\": " + std::to_string(symmetry.orbits) + "}";
}

std::string word(const Report::Inclusions& inclusions) {
    std::string fibres;
    for (const auto& [x, y, radius] : inclusions.fibres) {
        fibres +=
            (fibres.empty() ? "[" : ", [") + word(x) + ", " + word(y) + ", " + word(radius) + "]";
    }
    return "{\"source\": " + word(inclusions.source) +
           ", \"shapes\": " + std::to_string(inclusions.shapes) +
           (fibres.empty() ? "" : ", \"fibres\": [" + fibres + "]") +
           ", \"chords\": " + std::to_string(inclusions.chords) +
           ", \"fixed_sites\": " + std::to_string(inclusions.fixed_sites) +
           ", \"held_sites\": " + std::to_string(inclusions.held_sites) +
           (inclusions.holes.empty() ? "" : ", \"holes\": " + word(inclusions.holes)) + "}";
}

std::string word(const Report::Walls& walls) {
    return "{\"sides\": " + word(walls.sides) + ", \"cells\": " + word(walls.cells) +
           ", \"sites\": " + std::to_string(walls.sites) + "}";
}

std::string word(const std::vector<Report::Phase>& phases) {
    std::string text;
    for (const Report::Phase& phase : phases) text += (text.empty() ? "[" : ", ") + word(phase);
    return text + "]";
}

std::string word(const Report::Orientations& orientations) {
    const auto range = [](const std::array<double, 2>& angles) {
        return "[" + word(angles[0]) + ", " + word(angles[1]) + "]";
    };
    return "{\"phi1\": " + range(orientations.phi1) + ", \"Phi\": " + range(orientations.Phi) +
           ", \"phi2\": " + range(orientations.phi2) + "}";
}

std::string word(const std::vector<Report::Material>& materials) {
    std::string text;
    for (const auto& [name, constants] : materials) {
        text += (text.empty() ? "[{\"name\": " : ", {\"name\": ") + word(name);
        for (const auto& [key, value] : constants) text += ", \"" + key + "\": " + word(value);
        text += "}";
    }
    return text + "]";
}

std::string word(bool value) { return value ? "true" : "false"; }

std::string word(const std::array<std::array<double, 3>, 3>& vectors) {
    std::string text;
    for (const auto& [x, y, z] : vectors) {
        text += (text.empty() ? "[[" : ", [") + word(x) + ", " + word(y) + ", " + word(z) + "]";
    }
    return text + "]";
}

std::string word(const SpaceReport::Pattern& pattern) {
    std::string form;
    for (const int entry : pattern.hermite) form += (form.empty() ? "[" : ", ") + word(entry);
    return "{\"basis\": " + word(pattern.basis) + ", \"hermite\": " + form +
           "], \"energy\": " + word(pattern.energy) + verdict_words(pattern) + "}";
}

std::string word(const SpaceReport::Seconds& s) {
    return "{\"optimize\": " + word(s.optimize) + ", \"write\": " + word(s.write) +
           ", \"total\": " + word(s.total) + "}";
}

std::string word(const std::vector<CoincidentSite>& pairs) {
    std::string text;
    for (const auto& [site, earlier] : pairs) {
        text += (text.empty() ? "[[" : ", [") + word(site) + ", " + word(earlier) + "]";
    }
    return text.empty() ? "[]" : text + "]";
}

std::string word(const DroppedSites& dropped) {
    const auto n = static_cast<int>(dropped.sites.size());
    return "{\"dropped\": " + word(n) + ", \"sites\": " + word(dropped.sites) +
           (dropped.lines.empty() ? "" : ", \"lines\": " + word(dropped.lines)) + "}";
}

/// The keys with their values.
using Entries = std::vector<std::pair<std::string, std::string>>;

/// An object with one key per line.
std::string object_text(const Entries& entries) {
    std::string text;
    for (const auto& [key, value] : entries) {
        text += (text.empty() ? "{\n  \"" : ",\n  \"") + key + "\": " + value;
    }
    return text + "\n}\n";
}

}  // namespace

std::string encode_report(const Report& report) {
    // The keys of every run.
    Entries entries{
        {"version", word(report.version)},
        {"sites", std::to_string(report.sites)},
        {"lattice", word(report.lattice)},
        {"seed", std::to_string(report.seed)},
        {"solver", word(report.solver)},
        {"start", word(report.start)},
        {"stop", word(report.stop)},
        {"iterations", std::to_string(report.iterations)},
        {"evaluations", std::to_string(report.evaluations)},
        {"hessians", std::to_string(report.hessians)},
        {"cg_products", std::to_string(report.cg_products)},
        {"energy", word(report.energy)},
        {"energy_bound", word(report.energy_bound)},
        {"residual", word(report.residual)},
        {"minimum", word(report.minimum)},
        {"hexagons", std::to_string(report.hexagons)},
        {"valences", word(report.valences)},
        {"mirrors", word(report.mirrors)},
        {"threads", std::to_string(report.threads)},
        {"seconds", word(report.seconds)},
        {"files", word(report.files)},
    };
    // The keys that only some runs have.
    if (!report.found.empty()) entries.emplace_back("found", word(report.found));
    if (report.pattern) entries.emplace_back("pattern", word(*report.pattern));
    if (report.box_shortest_edge) {
        entries.emplace_back("box_shortest_edge", word(*report.box_shortest_edge));
    }
    if (report.grains) entries.emplace_back("grains", word(*report.grains));
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
    if (report.areas) entries.emplace_back("areas", word(*report.areas));
    if (report.aspect) entries.emplace_back("aspect", word(*report.aspect));
    if (report.symmetry) entries.emplace_back("symmetry", word(*report.symmetry));
    if (report.inclusions) entries.emplace_back("inclusions", word(*report.inclusions));
    if (report.walls) entries.emplace_back("walls", word(*report.walls));
    if (!report.phases.empty()) entries.emplace_back("phases", word(report.phases));
    if (report.duplicates) entries.emplace_back("duplicates", word(*report.duplicates));
    if (report.orientations) entries.emplace_back("orientations", word(*report.orientations));
    if (!report.materials.empty()) entries.emplace_back("materials", word(report.materials));
    return object_text(entries);
}

std::string encode_report(const SpaceReport& report) {
    Entries entries;
    const auto add = [&entries](const char* key, const auto& value) {
        entries.emplace_back(key, word(value));
    };
    add("version", report.version);
    add("sites", report.sites);
    add("lattice", report.lattice);
    entries.emplace_back("seed", std::to_string(report.seed));
    add("solver", report.solver);
    add("start", report.start);
    add("stop", report.stop);
    add("iterations", report.iterations);
    add("evaluations", report.evaluations);
    add("energy", report.energy);
    add("energy_bound", report.energy_bound);
    add("residual", report.residual);
    add("rms_residual", report.rms_residual);
    add("minimum", report.minimum);
    add("faces", report.faces);
    add("removed_edges", report.removed_edges);
    add("volume", report.volume);
    add("boundary_pairs", report.boundary_pairs);
    add("translations", report.translations);
    add("boundary_is_manifold", report.boundary_is_manifold);
    add("threads", report.threads);
    add("seconds", report.seconds);
    add("files", report.files);
    if (report.pattern) add("pattern", *report.pattern);
    if (report.duplicates) add("duplicates", *report.duplicates);
    return object_text(entries);
}

}  // namespace pcvt
