#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/json_writer.hpp"
#include "mesher/optimize/minimum.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt {

// Keys that the reports of the plane and of space share. They are never renamed, because programs
// read them.

/// The key `minimum`: yes, no or unknown; null if the run did not determine it.
inline void append_minimum(JsonWriter& json, const std::optional<Minimum>& minimum) {
    json.member("minimum", minimum ? std::optional(minimum_name(*minimum)) : std::nullopt);
}

/// The numbers of cells by their number of sides or faces.
inline void append_counts(JsonWriter& json, const char* key, const std::map<int, int>& counts) {
    json.object(key, [&] {
        for (const auto& [sides, n_cells] : counts) json.member(std::to_string(sides), n_cells);
    });
}

/// The last keys of a pattern. The smallest eigenvalue of its Hessian over the largest one is null
/// for one site.
inline void append_verdict(JsonWriter& json, double energy, const LatticeStability& stability) {
    json.member("energy", energy);
    json.member("minimum", minimum_name(stability.minimum));
    json.member("smallest_eigenvalue", stability.smallest);
}

/// The key `duplicates` of runs that leave out sites which coincide with earlier ones.
inline void append_duplicates(JsonWriter& json, Duplicates duplicates,
                              const DroppedSites& dropped) {
    if (duplicates != Duplicates::kDrop) return;
    const auto append_pairs = [&](const char* key, const std::vector<CoincidentSite>& pairs) {
        json.list(key, pairs, [&](const CoincidentSite& pair) {
            json.value(std::array{pair.site, pair.earlier});
        });
    };
    json.object("duplicates", [&] {
        json.member("dropped", dropped.sites.size());
        append_pairs("sites", dropped.sites);
        if (!dropped.lines.empty()) append_pairs("lines", dropped.lines);
    });
}

}  // namespace pcvt
