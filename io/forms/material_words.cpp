#include "io/forms/material_words.hpp"

#include <algorithm>
#include <utility>

#include "io/forms/note_table.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/phase_fractions.hpp"

namespace pcvt {
namespace {

void take_names(const LineScanner& scanner, std::span<const std::string_view> words,
                CellMaterials& materials) {
    if (words.empty() || !materials.phase_names.empty()) {
        scanner.throw_bad_file("the phases are unclear; name them once");
    }
    for (const std::string_view word : words) materials.phase_names.emplace_back(word);
    try {
        require_phase_names(materials.phase_names);
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
}

void take_site_phases(const LineScanner& scanner, std::span<const std::string_view> words,
                      CellMaterials& materials) {
    const int n_phases = static_cast<int>(materials.phase_names.size());
    for (const std::string_view word : words) {
        const int phase = scanner.integer(word);
        if (phase < 0 || phase >= n_phases) {
            scanner.throw_bad_file("there is no phase " + in_quotes(word) +
                                   "; name the phases first, and correct the number");
        }
        materials.site_phase.push_back(phase);
    }
}

void take_angles(const LineScanner& scanner, std::span<const std::string_view> words,
                 CellMaterials& materials) {
    if (words.size() != 3) {
        scanner.throw_bad_file("an orientation has 3 angles; write phi1, Phi and phi2");
    }
    const BungeAngles angles{scanner.number(words[0]), scanner.number(words[1]),
                             scanner.number(words[2])};
    try {
        materials.site_orientation.push_back(checked_angles(angles));
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
}

void require_count(const std::string& name, std::size_t found, std::int64_t n_sites,
                   const char* what) {
    if (found == 0 || std::cmp_equal(found, n_sites)) return;
    throw BadFile(name + ": there are " + what + " of " + std::to_string(found) + " sites for " +
                  std::to_string(n_sites) + " sites; give one each or none");
}

}  // namespace

void append_materials(std::string& text, std::string_view mark, const CellMaterials& materials) {
    const auto begin = [&](const char* key) { text.append(mark).append(key); };
    if (!materials.phase_names.empty()) {
        begin("phases");
        for (const std::string& phase : materials.phase_names) text += ' ' + phase;
        text += '\n';
    }
    for (std::size_t s = 0; s < materials.site_phase.size(); ++s) {
        if (s % kSitesALine == 0) begin("site_phases");
        text += ' ';
        append_number(text, materials.site_phase[s]);
        if ((s + 1) % kSitesALine == 0 || s + 1 == materials.site_phase.size()) text += '\n';
    }
    for (const BungeAngles& angles : materials.site_orientation) {
        begin("angles");
        for (const double angle : {angles.phi1, angles.Phi, angles.phi2}) {
            text += ' ';
            append_number(text, angle);
        }
        text += '\n';
    }
}

bool take_material(const LineScanner& scanner, std::string_view key,
                   std::span<const std::string_view> words, CellMaterials& materials) {
    if (key == "phases") {
        take_names(scanner, words, materials);
    } else if (key == "site_phases") {
        take_site_phases(scanner, words, materials);
    } else if (key == "angles") {
        take_angles(scanner, words, materials);
    } else {
        return false;
    }
    return true;
}

void require_materials(const std::string& name, const CellMaterials& materials,
                       std::int64_t n_sites) {
    if (!materials.phase_names.empty() && materials.site_phase.empty()) {
        throw BadFile(name + ": there are phases, but no site has one; give both or none");
    }
    require_count(name, materials.site_phase.size(), n_sites, "phases");
    require_count(name, materials.site_orientation.size(), n_sites, "orientations");
}

CellMaterials shown_phases(const plane::Tile& tile, const std::vector<MaterialRun>& materials) {
    const std::string prefix = phase_group("");
    const int n_faces = tile.n_faces();
    if (tile.face_site.empty() || std::ssize(tile.face_site) != n_faces) return {};
    if (materials.empty() || materials.front().first_face > 0) return {};
    // An id of a site is at most the number of faces, so that a wrong one takes no memory.
    const SiteId last = *std::max_element(tile.face_site.begin(), tile.face_site.end());
    const SiteId first = *std::min_element(tile.face_site.begin(), tile.face_site.end());
    if (first < 0 || last >= tile.n_faces()) return {};
    CellMaterials shown{.site_phase = std::vector<int>(static_cast<std::size_t>(last) + 1, -1)};
    for (std::size_t k = 0; k < materials.size(); ++k) {
        const int begin = materials[k].first_face;
        const int end = k + 1 < materials.size() ? materials[k + 1].first_face : n_faces;
        if (begin == end) continue;
        if (!materials[k].name.starts_with(prefix)) return {};
        const std::string name = materials[k].name.substr(prefix.size());
        auto found = std::find(shown.phase_names.begin(), shown.phase_names.end(), name);
        if (found == shown.phase_names.end()) {
            found = shown.phase_names.insert(found, name);
        }
        const int phase = static_cast<int>(found - shown.phase_names.begin());
        for (int f = begin; f < end; ++f) {
            int& of_site = shown.site_phase[tile.face_site[f]];
            if (of_site >= 0 && of_site != phase) return {};
            of_site = phase;
        }
    }
    const auto& phases = shown.site_phase;
    return std::find(phases.begin(), phases.end(), -1) == phases.end() ? shown : CellMaterials{};
}

}  // namespace pcvt
