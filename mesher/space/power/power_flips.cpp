#include "mesher/space/power/power_flips.hpp"

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {

bool PowerFlips::is_locally_regular(int facet) const {
    const auto [p, q, r, s] = tetrahedra().tetrahedron(facet / 4);
    return !violates_regularity(gram(), weighted_image(p), weighted_image(q), weighted_image(r),
                                weighted_image(s), weighted_image(tetrahedra().apex_across(facet)));
}

std::vector<int> PowerFlips::irregular_facets() const {
    std::vector<int> facets;
    for (int f = 0; f < tetrahedra().n_facets(); ++f) {
        checkpoint_each(f);
        if (f < tetrahedra().opposite(f) && !is_locally_regular(f)) facets.push_back(f);
    }
    return facets;
}

bool PowerFlips::note_blocked(const std::array<Corner, 3>& triangle, int inner) {
    hidden_ = triangle[(inner + 2) % 3].site;
    return false;
}

}  // namespace pcvt::space
