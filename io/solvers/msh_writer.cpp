#include "io/solvers/msh_writer.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// The value of elements and nodes that belong to no cell: sides and midside nodes.
constexpr int kNoCell = -1;

using Position = std::array<double, 3>;

/// Appends the sections of one file.
class MshText {
   public:
    explicit MshText(const EntityMesh& form) : form_(form), mesh_(form.mesh) {}

    std::string encode() {
        append_head();
        append_entities();
        append_nodes();
        append_elements();
        append_periodic();
        if (!mesh_.element_site.empty()) append_element_view("cell_id", mesh_.element_site);
        if (!mesh_.node_site.empty()) append_node_view("cell_id", mesh_.node_site);
        if (mesh_.dimension == 3 && !mesh_.element_site.empty()) {
            append_node_view("periodic_node", numbered_orbits());
        }
        if (!form_.element_orbit.empty()) append_element_view("orbit", form_.element_orbit);
        return std::move(text_);
    }

   private:
    void append(int number) {
        append_number(text_, number);
        text_ += ' ';
    }
    void append(const Position& p) {
        for (const double x : p) {
            append_number(text_, x);
            text_ += ' ';
        }
    }
    /// Replaces the blank behind the last number by a line end.
    void end_line() { text_.back() = '\n'; }
    void append_line(std::initializer_list<int> numbers) {
        for (const int number : numbers) append(number);
        end_line();
    }

    void append_head() {
        text_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n" + form_.title +
                ", written by pcvt\npcvt kind " + form_.kind + "\npcvt lattice ";
        for (const double x : mesh_.periods) {
            append_number(text_, x);
            text_ += ' ';
        }
        end_line();
        text_ += form_.notes + "$EndComments\n$PhysicalNames\n";
        append_line({static_cast<int>(form_.groups.size())});
        for (const auto& [dimension, number, name] : form_.groups) {
            append(dimension);
            append(number);
            text_ += '"' + name + "\"\n";
        }
        text_ += "$EndPhysicalNames\n";
    }

    /// Appends the smallest box around the corners of elements.
    void append_bounds(const ElementList& elements, std::span<const int> numbers) {
        Position low = mesh_.nodes[elements.nodes[numbers.front()].front()];
        Position high = low;
        const auto n_corners = static_cast<std::size_t>(elements.type().n_corners);
        for (const int e : numbers) {
            for (const int v : elements.nodes[e].first(n_corners)) {
                for (std::size_t i = 0; i < 3; ++i) {
                    low[i] = std::min(low[i], mesh_.nodes[v][i]);
                    high[i] = std::max(high[i], mesh_.nodes[v][i]);
                }
            }
        }
        append(low);
        append(high);
    }

    /// Appends the length of a list and the list.
    void append_list(std::span<const int> numbers) {
        append(static_cast<int>(numbers.size()));
        for (const int number : numbers) append(number);
    }

    void append_entities() {
        text_ += "$Entities\n";
        for (const EntityList& entities : form_.entities) append(entities.size());
        end_line();
        for (int dimension = 0; dimension <= 3; ++dimension) {
            const EntityList& entities = form_.entities[dimension];
            for (int k = 0; k < entities.size(); ++k) {
                checkpoint_each(k);
                append(entities.tags[k]);
                if (dimension == 0) {
                    append(mesh_.nodes[entities.nodes[k].front()]);
                } else {
                    append_bounds(form_.elements(dimension), entities.elements[k]);
                }
                append_list(entities.groups[k]);
                if (dimension > 0) append_list(entities.boundary[k]);
                end_line();
            }
        }
        text_ += "$EndEntities\n";
    }

    /// Calls `visit(dimension, tag, nodes)` for each entity with nodes of its own, in the order of
    /// the file.
    template <class Visit>
    void for_each_block(const Visit& visit) const {
        for (int dimension = 0; dimension <= 3; ++dimension) {
            const EntityList& entities = form_.entities[dimension];
            for (int k = 0; k < entities.size(); ++k) {
                checkpoint_each(k);
                if (entities.nodes.size(k) == 0) continue;
                visit(dimension, entities.tags[k], entities.nodes[k]);
            }
        }
    }

    void append_nodes() {
        int n_blocks = 0;
        for_each_block([&n_blocks](int, int, std::span<const int>) { ++n_blocks; });
        text_ += "$Nodes\n";
        append_line({n_blocks, mesh_.n_nodes(), 1, mesh_.n_nodes()});
        for_each_block([this](int dimension, int tag, std::span<const int> nodes) {
            append_line({dimension, tag, 0, static_cast<int>(nodes.size())});
            for (const int v : nodes) append_line({v + 1});
            for (const int v : nodes) {
                append(mesh_.nodes[v]);
                end_line();
            }
        });
        text_ += "$EndNodes\n";
    }

    /// The number before that of the first element of a dimension.
    int before(int dimension) const {
        return dimension == mesh_.dimension ? 0 : mesh_.elements.size();
    }

    void append_nodes_of(const ElementList& elements, int e) {
        const auto nodes = elements.nodes[e];
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            append(nodes[elements.type().place_in_msh(k)] + 1);
        }
    }

    void append_elements() {
        int n_blocks = 0;
        int n_elements = 0;
        for (const int dimension : form_.listed) {
            n_blocks += form_.entities[dimension].size();
            n_elements += form_.elements(dimension).size();
        }
        text_ += "$Elements\n";
        append_line({n_blocks, n_elements, 1, n_elements});
        for (const int dimension : form_.listed) {
            const EntityList& entities = form_.entities[dimension];
            const ElementList& elements = form_.elements(dimension);
            for (int k = 0; k < entities.size(); ++k) {
                checkpoint_each(k);
                append_line(
                    {dimension, entities.tags[k], elements.type().msh, entities.elements.size(k)});
                for (const int e : entities.elements[k]) {
                    append(before(dimension) + e + 1);
                    append_nodes_of(elements, e);
                    end_line();
                }
            }
        }
        text_ += "$EndElements\n";
    }

    /// Appends the links: slave = master + translation, as a 4 x 4 matrix row by row.
    void append_periodic() {
        // A box between four walls has no periodic entities.
        if (form_.links.empty()) return;
        text_ += "$Periodic\n";
        append_line({static_cast<int>(form_.links.size())});
        for (const EntityLink& link : form_.links) {
            append_line({link.dimension, link.slave, link.master});
            append(16);
            for (std::size_t row = 0; row < 3; ++row) {
                for (std::size_t i = 0; i < 3; ++i) append(i == row ? 1 : 0);
                append_number(text_, link.translation[row]);
                text_ += ' ';
            }
            append_line({0, 0, 0, 1});
            append_line({static_cast<int>(link.nodes.size())});
            for (const auto& [v, w] : link.nodes) append_line({v + 1, w + 1});
        }
        text_ += "$EndPeriodic\n";
    }

    /// The orbits of the nodes, numbered from 0 in the order of their first nodes.
    std::vector<int> numbered_orbits() const {
        std::vector<int> numbers(mesh_.orbit.size());
        int n = 0;
        for (int v = 0; v < mesh_.n_nodes(); ++v) {
            numbers[v] = mesh_.orbit[v] == v ? n++ : numbers[mesh_.orbit[v]];
        }
        return numbers;
    }

    void open_view(const std::string& section, const char* view, int n_values) {
        text_ += "$" + section + "\n1\n\"" + view + "\"\n1\n0\n3\n0\n1\n";
        append_line({n_values});
    }

    // The values are in the order in which the file lists the elements or nodes: some programs,
    // meshio among them, skip the numbers in the rows.

    void append_element_view(const char* view, const std::vector<int>& values) {
        int n_elements = 0;
        for (const int dimension : form_.listed) n_elements += form_.elements(dimension).size();
        open_view("ElementData", view, n_elements);
        for (const int dimension : form_.listed) {
            for (const int e : form_.entities[dimension].elements.corners) {
                checkpoint_each(e);
                append_line({before(dimension) + e + 1,
                             dimension == mesh_.dimension ? values[e] : kNoCell});
            }
        }
        text_ += "$EndElementData\n";
    }

    void append_node_view(const char* view, const std::vector<int>& values) {
        open_view("NodeData", view, mesh_.n_nodes());
        for_each_block([&](int, int, std::span<const int> nodes) {
            for (const int v : nodes) append_line({v + 1, values[v]});
        });
        text_ += "$EndNodeData\n";
    }

    const EntityMesh& form_;
    const ElementMesh& mesh_;
    std::string text_;
};

}  // namespace

std::vector<EncodedFile> encode_msh(const EntityMesh& form, const std::string& path) {
    return only_file(path, MshText(form).encode());
}

}  // namespace pcvt
