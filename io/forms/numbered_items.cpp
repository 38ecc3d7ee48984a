#include "io/forms/numbered_items.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/forms/file_tile_builder.hpp"
#include "io/forms/midside_nodes.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt {
namespace {

/// A printed translation is rounded, and so are the period vectors.
constexpr double kTranslationUlps = 4;

[[noreturn]] void throw_bad_file(const std::string& name, int line, const std::string& complaint) {
    throw BadFile(name + ":" + std::to_string(line) + ": " + complaint);
}

template <class Item>
void sort_by_number(std::vector<Item>& items, const std::string& name, const char* word) {
    cancellable_stable_sort(items.begin(), items.end(),
                            [](const Item& s, const Item& t) { return s.number < t.number; });
    const auto twice =
        std::adjacent_find(items.begin(), items.end(),
                           [](const Item& s, const Item& t) { return s.number == t.number; });
    if (twice == items.end()) return;
    throw_bad_file(name, (twice + 1)->line,
                   std::string(word) + " " + std::to_string(twice->number) +
                       " is given twice; number each one once");
}

/// Place of a number among sorted items; refused, at the line that names it, if it is not there.
template <class Item>
int place(const std::vector<Item>& items, int number, const std::string& name, int line,
          const char* word) {
    const auto guess = static_cast<std::size_t>(std::int64_t{number} - 1);
    if (guess < items.size() && items[guess].number == number) return static_cast<int>(guess);
    const auto found =
        std::lower_bound(items.begin(), items.end(), number,
                         [](const Item& item, int wanted) { return item.number < wanted; });
    if (found == items.end() || found->number != number) {
        throw_bad_file(name, line,
                       std::string(word) + " " + std::to_string(number) +
                           " does not exist; correct the number");
    }
    return static_cast<int>(found - items.begin());
}

plane::Offset offset_of(const plane::Lattice& lattice, const plane::Vec2& translation,
                        const std::string& name, int line) {
    const plane::Vec2 periods = lattice.to_lattice(translation);
    if (periods.allFinite() && periods.cwiseAbs().maxCoeff() < kLargestOffset) {
        const plane::Offset offset{static_cast<int>(std::lround(periods.x())),
                                   static_cast<int>(std::lround(periods.y()))};
        const plane::Vec2 exact = lattice.translation(offset);
        const double largest = std::max({translation.cwiseAbs().maxCoeff(),
                                         std::abs(offset.i) * lattice.a().cwiseAbs().maxCoeff(),
                                         std::abs(offset.j) * lattice.b().cwiseAbs().maxCoeff()});
        const double tolerance =
            kTranslationUlps * std::numeric_limits<double>::epsilon() * largest;
        if ((exact - translation).cwiseAbs().maxCoeff() <= tolerance) return offset;
    }
    throw_bad_file(
        name, line,
        "the nodes are tied by the translation (" + in_words(translation.x()) + ", " +
            in_words(translation.y()) +
            "), which is not a lattice vector; correct the periods, or write the file again");
}

class Resolver {
   public:
    Resolver(FileTileBuilder& file, const std::optional<plane::Lattice>& lattice)
        : numbered_(file.numbered), file_(file) {
        if (!file_.lattice) file_.lattice = lattice;
        sort_by_number(numbered_.nodes, file_.name, "node");
        sort_by_number(numbered_.triangles, file_.name, "element");
    }

    void resolve() {
        for (const NumberedItems::Node& node : numbered_.nodes) file_.points.push_back(node.point);
        for (const NumberedItems::Triangle& triangle : numbered_.triangles) {
            std::vector<int> corners;
            for (const int number : triangle.nodes) corners.push_back(node(number, triangle.line));
            file_.add_face(corners, triangle.line);
        }
        take_sites();
        if (file_.lattice) take_pairs();
        if (is_second_order()) {
            require_middles_of_edges();
            remove_midside_nodes(file_, std::nullopt, plane::Precision::kDouble);
        }
    }

   private:
    int node(int number, int line) const {
        return place(numbered_.nodes, number, file_.name, line, "node");
    }

    /// All triangles have six nodes; refused where only some have.
    bool is_second_order() const {
        const auto& triangles = numbered_.triangles;
        const auto other =
            std::find_if(triangles.begin(), triangles.end(), [&](const NumberedItems::Triangle& t) {
                return t.nodes.size() != triangles.front().nodes.size();
            });
        if (other != triangles.end()) {
            throw_bad_file(file_.name, other->line,
                           "triangles of two orders; give a mesh of one order");
        }
        return !triangles.empty() && triangles.front().nodes.size() == 6;
    }

    void require_middles_of_edges() const {
        const std::vector<MidsideNode> edges = file_midside_nodes(file_);
        for (const NumberedItems::Edge& edge : numbered_.edges) {
            const auto [low, high] =
                std::minmax({node(edge.nodes[0], edge.line), node(edge.nodes[1], edge.line)});
            const auto found =
                std::lower_bound(edges.begin(), edges.end(), std::make_pair(low, high),
                                 [](const MidsideNode& e, const std::pair<int, int>& ends) {
                                     return std::make_pair(e.low, e.high) < ends;
                                 });
            if (found != edges.end() && found->low == low && found->high == high && edge.middle &&
                found->node == node(*edge.middle, edge.line)) {
                continue;
            }
            throw_bad_file(
                file_.name, edge.line,
                "the line is not an edge of a triangle with its mid-side node; correct its nodes");
        }
    }

    void take_sites() {
        if (!file_.sites.empty()) return;
        const bool of_nodes = !numbered_.node_sites.empty();
        const auto& sites = of_nodes ? numbered_.node_sites : numbered_.triangle_sites;
        file_.sites.assign(sites.size(), -1);
        for (const NumberedItems::SiteOf& item : sites) {
            const int owner = of_nodes ? node(item.number, item.line)
                                       : place(numbered_.triangles, item.number, file_.name,
                                               item.line, "element");
            if (owner >= static_cast<int>(sites.size()) || file_.sites[owner] >= 0) {
                throw_bad_file(file_.name, item.line,
                               "the sites are ambiguous; give each item one site");
            }
            file_.sites[owner] = item.site;
        }
    }

    void take_pairs() {
        for (const NumberedItems::Link& link : numbered_.links) {
            file_.vertex_pairs.push_back(
                {node(link.master, link.line), node(link.slave, link.line),
                 offset_of(*file_.lattice, link.translation, file_.name, link.line)});
        }
        for (const NumberedItems::Edge& edge : numbered_.edges) {
            const auto at = [&](int k) { return node(edge.nodes[k], edge.line); };
            file_.edge_pairs.push_back(
                {.v0 = at(0),
                 .v1 = at(1),
                 .w0 = at(2),
                 .w1 = at(3),
                 .offset = offset_of(*file_.lattice, edge.translation, file_.name, edge.line)});
        }
    }

    NumberedItems& numbered_;
    FileTileBuilder& file_;
};

}  // namespace

void resolve_numbers(FileTileBuilder& builder, const std::optional<plane::Lattice>& lattice) {
    Resolver(builder, lattice).resolve();
}

}  // namespace pcvt
