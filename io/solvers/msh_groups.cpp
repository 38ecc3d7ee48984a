#include "io/solvers/msh_groups.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/text.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

/// The words of a curve or a surface before its physical groups: its tag and its bounds.
constexpr std::size_t kBeforeGroups = 7;

/// One side of an edge, and the cell of its triangle.
struct TriangleSide {
    int low;
    int high;
    SiteId site;
    /// The line of its triangle.
    int line;
    friend auto operator<=>(const TriangleSide&, const TriangleSide&) = default;
};

bool same_edge(const TriangleSide& s, const TriangleSide& t) {
    return s.low == t.low && s.high == t.high;
}

/// The sites of the triangles by rising number.
std::vector<NumberedItems::SiteOf> sorted_sites(const NumberedItems& items) {
    std::vector<NumberedItems::SiteOf> sites = items.triangle_sites;
    cancellable_stable_sort(sites.begin(), sites.end(),
                            [](const auto& s, const auto& t) { return s.number < t.number; });
    return sites;
}

std::optional<SiteId> site_of(const std::vector<NumberedItems::SiteOf>& sorted, int number) {
    const auto found = std::lower_bound(
        sorted.begin(), sorted.end(), number,
        [](const NumberedItems::SiteOf& s, int wanted) { return s.number < wanted; });
    if (found == sorted.end() || found->number != number) return std::nullopt;
    return found->site;
}

/// @pre each triangle has a site.
std::vector<TriangleSide> sorted_sides(const NumberedItems& items) {
    const std::vector<NumberedItems::SiteOf> stated = sorted_sites(items);
    std::vector<TriangleSide> sides;
    sides.reserve(3 * items.triangles.size());
    for (const NumberedItems::Triangle& triangle : items.triangles) {
        const SiteId site = *site_of(stated, triangle.number);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle.nodes[k], triangle.nodes[(k + 1) % 3]);
            sides.push_back({low, high, site, triangle.line});
        }
    }
    cancellable_sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace

void MshGroups::parse_names(MshRows& rows) {
    for (int n = (rows.next_row(1), rows.count(0)); n > 0; --n) {
        const int dimension = (rows.next_row(3), rows.integer(0));
        std::string_view name = rows.words()[2];
        if (name.size() < 2 || name.front() != '"' || name.back() != '"') {
            rows.throw_bad_file("the name of the group is not in quotes; correct it");
        }
        name = name.substr(1, name.size() - 2);
        if (dimension < kMshCurves || dimension > kMshSurfaces) continue;
        has_cells_ = has_cells_ || (dimension == kMshSurfaces && name.starts_with(kCellSet));
        names_[dimension - 1][rows.integer(1)] = name;
    }
}

void MshGroups::parse_entities(MshRows& rows) {
    rows.next_row(4);
    const std::array<int, 3> n{rows.count(0), rows.count(1), rows.count(2)};
    for (int k = 0; k < n[0]; ++k) rows.next_row();
    for (const int dimension : {kMshCurves, kMshSurfaces}) {
        for (int k = 0; k < n[dimension]; ++k) {
            if (rows.next_row().size() < kBeforeGroups + 2) {
                rows.throw_bad_file("the entity has too few numbers; write the file again");
            }
            if (rows.count(kBeforeGroups) == 0) continue;
            groups_[dimension - 1][rows.integer(0)] = rows.integer(kBeforeGroups + 1);
        }
    }
}

const std::string& MshGroups::name_of(int dimension, int entity) const {
    static const std::string none;
    const auto group = groups_[dimension - 1].find(entity);
    if (group == groups_[dimension - 1].end()) return none;
    const auto name = names_[dimension - 1].find(group->second);
    return name == names_[dimension - 1].end() ? none : name->second;
}

std::optional<std::string> MshGroups::fault_of_cells(const NumberedItems& items,
                                                     const std::vector<int>& surfaces) const {
    const std::vector<NumberedItems::SiteOf> stated = sorted_sites(items);
    for (std::size_t f = 0; f < surfaces.size(); ++f) {
        const NumberedItems::Triangle& triangle = items.triangles[f];
        const std::string& group = name_of(kMshSurfaces, surfaces[f]);
        const std::optional<SiteId> site = site_of(stated, triangle.number);
        if (site && group == std::string(kCellSet) + std::to_string(*site)) continue;
        return std::to_string(triangle.line) + ": the triangle is in the physical group " +
               in_quotes(group) + ", but its cell_id is " +
               (site ? std::to_string(*site) : "missing");
    }
    return std::nullopt;
}

std::optional<std::string> MshGroups::fault_of_boundary(const NumberedItems& items,
                                                        const std::vector<MshLine>& lines) const {
    const std::vector<TriangleSide> sides = sorted_sides(items);
    std::vector<std::pair<int, int>> boundary;
    for (const MshLine& line : lines) {
        if (name_of(kMshCurves, line.curve) != kGrainBoundarySet) continue;
        const auto [low, high] = std::minmax(line.from, line.to);
        boundary.emplace_back(low, high);
        const auto first =
            std::lower_bound(sides.begin(), sides.end(), TriangleSide{low, high, -1, 0});
        if (sides.end() - first >= 2 && same_edge(first[0], {low, high, 0, 0}) &&
            same_edge(first[1], first[0]))
            continue;
        return std::to_string(line.line) +
               ": the line of grain_boundary is not between two triangles";
    }
    cancellable_sort(boundary.begin(), boundary.end());
    for (std::size_t k = 1; k < sides.size(); ++k) {
        const TriangleSide& side = sides[k];
        if (!same_edge(sides[k - 1], side) || sides[k - 1].site == side.site) continue;
        const std::pair edge(side.low, side.high);
        if (std::binary_search(boundary.begin(), boundary.end(), edge)) continue;
        return std::to_string(side.line) + ": the edge from node " + std::to_string(side.low) +
               " to node " + std::to_string(side.high) +
               " lies between two cells, but not in the group grain_boundary";
    }
    return std::nullopt;
}

std::optional<std::string> MshGroups::fault(const std::string& name, const NumberedItems& items,
                                            const std::vector<int>& surfaces,
                                            const std::vector<MshLine>& lines) const {
    if (!has_cells_) return std::nullopt;
    std::optional<std::string> found = fault_of_cells(items, surfaces);
    if (!found) found = fault_of_boundary(items, lines);
    if (!found) return std::nullopt;
    return name + ":" + *found + "; write the file again with pcvt";
}

}  // namespace pcvt
