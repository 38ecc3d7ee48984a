#include "io/forms/site_orbits.hpp"

#include <algorithm>

#include "io/bytes/bad_file.hpp"
#include "io/forms/note_table.hpp"

namespace pcvt {

void append_site_orbits(std::string& text, std::string_view mark,
                        std::span<const int> site_orbits) {
    append_note(text, mark,
                {.word = "site_orbits",
                 .numbers = std::vector<int>(site_orbits.begin(), site_orbits.end())},
                0);
}

void require_site_orbits(const std::string& name, const std::vector<int>& site_orbits,
                         std::int64_t n_sites, bool states_all) {
    const auto n = static_cast<std::int64_t>(site_orbits.size());
    if (n > n_sites || (states_all && n < n_sites)) {
        throw BadFile(name + ": there are " + std::to_string(n) + " orbits of " +
                      std::to_string(n_sites) + " sites; give one each or none");
    }
    const auto last = site_orbits.end();
    // Sites without an element may be the first of their orbits.
    if (!states_all && std::find(site_orbits.begin(), last, -1) != last) return;
    int n_orbits = 0;
    for (const int orbit : site_orbits) {
        if (orbit < 0 || orbit > n_orbits) {
            throw BadFile(name +
                          ": the orbits are not counted in the order of their first sites; " +
                          "write the file again with pcvt");
        }
        n_orbits = std::max(n_orbits, orbit + 1);
    }
}

}  // namespace pcvt
