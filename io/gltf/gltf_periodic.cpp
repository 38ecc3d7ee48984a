#include "io/gltf/gltf_periodic.hpp"

#include <utility>

#include "io/forms/site_notes.hpp"

namespace pcvt {
namespace {

constexpr const char* kPeriodic = "extras.periodic.";

/// The numbers of a note of the tile: a number, or a list.
std::vector<double> listed_numbers(const GltfDocument& document, const SiteNote& note,
                                   const Json& value) {
    const bool is_list = value.is_array();
    std::vector<double> numbers;
    for (std::size_t k = 0; k < (is_list ? value.size() : 1); ++k) {
        const Json& number = is_list ? value[k] : value;
        if (is_list == (note.n_parts > 1) && number.is_number()) {
            numbers.push_back(number.get<double>());
            continue;
        }
        document.throw_bad_file(kPeriodic + std::string(note.member) + " is not " +
                                std::string(note.parts));
    }
    return numbers;
}

std::vector<double> note_numbers(const GltfDocument& document, const SiteNote& note,
                                 const Json& value) {
    if (!note.of_each_site) return listed_numbers(document, note, value);
    const std::size_t accessor = document.count(value, std::string(note.member));
    const std::vector<float> numbers = document.floats(accessor, note.n_parts);
    return {numbers.begin(), numbers.end()};
}

/// Reads the edges of holes, [v, w] each, by the names of the holes.
void read_holes(const GltfDocument& document, const Json& holes, SiteNotes& notes) {
    for (const JsonMember& hole : holes.members()) {
        for (const Json& edge : hole.value) {
            const std::vector<double> ends = GltfDocument::number_list(edge, 2);
            if (ends.empty()) {
                document.throw_bad_file(kPeriodic + std::string("holes is not of edges [v, w]"));
            }
            try {
                notes.add_hole_edge(hole.name, ends[0], ends[1]);
            } catch (const InvalidInput& fault) {
                document.throw_bad_file(kPeriodic + std::string("holes: ") + fault.what());
            }
        }
    }
}

void give_notes(const GltfDocument& document, SiteNotes notes, plane::Tile& tile) {
    try {
        std::move(notes).give_to(tile);
    } catch (const InvalidInput& fault) {
        document.throw_bad_file(fault.what());
    }
}

}  // namespace

void read_site_notes(const GltfDocument& document, const Json& periodic, plane::Tile& tile) {
    SiteNotes notes{.short_edges = 0};
    bool is_stated = false;
    for (const SiteNote& note : site_notes()) {
        const Json& value = GltfDocument::member(periodic, std::string(note.member));
        if (value.is_null()) continue;
        is_stated = true;
        const std::vector<double> numbers = note_numbers(document, note, value);
        try {
            take_note(note, numbers, notes);
        } catch (const InvalidInput& fault) {
            document.throw_bad_file(kPeriodic + std::string(note.member) + ": " + fault.what());
        }
    }
    read_holes(document, GltfDocument::member(periodic, "holes"), notes);
    if (!is_stated && notes.holes.empty()) return;
    if (is_stated && (notes.positions.empty() || tile.sites().empty())) {
        document.throw_bad_file(
            "extras.periodic has periods without sitePositions, or positions of sites without ids");
    }
    give_notes(document, std::move(notes), tile);
}

}  // namespace pcvt
