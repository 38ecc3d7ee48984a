#include "io/forms/file_tetrahedra.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/forms/entity_mesh.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kFileCorners = 4;
/// As the proof of tetrahedra compares positions.
constexpr double kMiddleUlps = 4;

[[noreturn]] void refuse_element(const FileTetrahedra& found, int t, int node,
                                 const std::string& complaint) {
    throw BadFile(found.name + ":" + std::to_string(found.lines[t]) + ": node " +
                  std::to_string(node + found.index_base) + " " + complaint);
}

double middle_tolerance(const space::TetrahedralMesh& mesh) {
    double largest = 0;
    for (const space::Vec3& p : mesh.points)
        largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
    return kMiddleUlps * std::numeric_limits<double>::epsilon() * largest;
}

/// A node in the middle of an edge of an element.
struct MiddleUse {
    int low;
    int high;
    int node;
    int element;
    friend auto operator<=>(const MiddleUse&, const MiddleUse&) = default;
};

/// Requires that the middle nodes come behind the corners, each in the middle of its edge.
/// @returns  all uses, by their edges.
std::vector<MiddleUse> middle_uses(const FileTetrahedra& found, int n_corners,
                                   const space::TetrahedralMesh& mesh) {
    const double tolerance = middle_tolerance(mesh);
    std::vector<MiddleUse> uses;
    for (int t = 0; t < found.elements.size(); ++t) {
        checkpoint_each(t);
        const auto nodes = found.elements.nodes[t];
        for (std::size_t k = 0; k < space::kEdgeCorners.size(); ++k) {
            const auto& [i, j] = space::kEdgeCorners[k];
            const auto [low, high] = std::minmax(nodes[i], nodes[j]);
            const int node = nodes[kFileCorners + k];
            if (node < n_corners) {
                refuse_element(found, t, node,
                               "is in the middle of an edge, but not behind all corners; write "
                               "the file again with pcvt");
            }
            const space::Vec3& p = mesh.points[low];
            const space::Vec3 middle = p + (mesh.points[high] - p) / 2;
            if (!((mesh.points[node] - middle).lpNorm<Eigen::Infinity>() <= tolerance)) {
                refuse_element(found, t, node,
                               "is not in the middle of its edge; take straight edges");
            }
            uses.push_back({low, high, node, t});
        }
    }
    cancellable_sort(uses.begin(), uses.end());
    return uses;
}

/// Requires one node for each edge, and one edge for each node behind the corners.
void require_one_each(const FileTetrahedra& found, const std::vector<MiddleUse>& uses,
                      std::size_t n_middles) {
    std::size_t n_edges = 0;
    for (std::size_t k = 0; k < uses.size(); ++k) {
        const bool again =
            k > 0 && uses[k].low == uses[k - 1].low && uses[k].high == uses[k - 1].high;
        if (!again) ++n_edges;
        if (!again || uses[k].node == uses[k - 1].node) continue;
        refuse_element(found, uses[k].element, uses[k].node,
                       "is the second one in the middle of its edge; let the tetrahedra share one");
    }
    if (n_edges == n_middles) return;
    throw BadFile(found.name + ": has " + std::to_string(n_middles) + " nodes in the middle of " +
                  std::to_string(n_edges) + " edges; write the file again with pcvt");
}

}  // namespace

void place_tetrahedra(const FileTetrahedra& found, space::TetrahedralMesh& mesh) {
    int n_corners = 0;
    for (int t = 0; t < found.elements.size(); ++t) {
        checkpoint_each(t);
        std::array<int, kFileCorners>& corners = mesh.tetrahedra.emplace_back();
        std::copy_n(found.elements.nodes[t].begin(), kFileCorners, corners.begin());
        n_corners = std::max(n_corners, *std::max_element(corners.begin(), corners.end()) + 1);
    }
    if (found.elements.kind != ElementKind::kTetrahedron10) return;
    const auto n = static_cast<std::size_t>(n_corners);
    require_one_each(found, middle_uses(found, n_corners, mesh), mesh.points.size() - n);
    mesh.order = 2;
    mesh.points.resize(n);
    if (!mesh.point_site.empty()) mesh.point_site.resize(n);
}

std::vector<space::Vec3> points_by_number(const std::string& name,
                                          const std::vector<NumberedPoint>& nodes) {
    std::vector<space::Vec3> points(nodes.size());
    std::vector<char> is_known(nodes.size(), 0);
    for (const auto& [number, line, position] : nodes) {
        const std::string place = name + ":" + std::to_string(line) + ": ";
        if (number < 1 || std::cmp_greater(number, points.size())) {
            throw BadFile(place + std::to_string(number) + " is not a number from 1 to " +
                          std::to_string(points.size()) + "; correct it");
        }
        if (std::exchange(is_known[number - 1], 1) != 0) {
            throw BadFile(place + "node " + std::to_string(number) + " occurs twice");
        }
        points[number - 1] = {position[0], position[1], position[2]};
    }
    return points;
}

bool states_tetrahedra(std::string_view text) {
    const std::string comment = "pcvt kind " + std::string(kTetrahedraKind);
    const std::size_t at = text.find(comment);
    if (at == std::string_view::npos) return false;
    const std::string_view rest = text.substr(at + comment.size());
    return rest.starts_with('\n') || rest.starts_with('\r');
}

void require_sorted_cells(const std::string& name, const space::TetrahedralMesh& mesh) {
    const std::vector<SiteId>& cells = mesh.cell;
    for (std::size_t t = 0; t < cells.size(); ++t) {
        const SiteId before = t == 0 ? -1 : cells[t - 1];
        if (cells[t] == before + 1 || (t > 0 && cells[t] == before)) continue;
        throw BadFile(name +
                      ": the tetrahedra are not sorted by the sites of their cells, or a cell has "
                      "none; write the file again with pcvt");
    }
}

}  // namespace pcvt
