#include "io/solvers/inp_tetrahedra.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/file_fields.hpp"
#include "io/bytes/text.hpp"
#include "io/forms/box_sets.hpp"
#include "io/forms/entity_mesh.hpp"
#include "io/forms/lattice_numbers.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/forms/tetrahedra_contacts.hpp"
#include "io/solvers/inp_cards.hpp"
#include "io/solvers/inp_fields.hpp"
#include "io/solvers/inp_sections.hpp"
#include "io/solvers/inp_text.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

/// The number by which Abaqus calls the side of a tetrahedron opposite to corner k.
constexpr std::array<int, 4> kSideNumbers{3, 4, 2, 1};

/// Makes the form of one tile, part by part.
class TetrahedraInp {
   public:
    TetrahedraInp(const space::TetrahedralMesh& mesh, const FileOptions& options)
        : mesh_(mesh),
          options_(options),
          form_{.mesh = element_mesh(mesh)},
          contacts_(cell_contacts(mesh, form_.mesh)) {
        if (options.materials != nullptr && !mesh.cell.empty()) materials_ = *options.materials;
    }

    InpForm make() {
        form_.element = mesh_.order == 2 ? "C3D10" : "C3D4";
        form_.kind = kTetrahedraKind;
        form_.explanation = inp_head(options_) + kInpStrainsInSpace;
        append_inp_sites(form_.notes, mesh_.cell.empty() ? std::span<const SiteId>(mesh_.point_site)
                                                         : std::span<const SiteId>());
        append_materials(form_.notes, "** pcvt ", materials_);
        add_ties();
        add_cells();
        add_node_sets();
        add_surfaces();
        if (!materials_.empty()) form_.job = inp_sections(materials_, cells_, 3);
        if (options_.job == SolverJob::kElastic) {
            form_.job += inp_elastic_job(materials_, options_.elastic, mesh_.lattice.volume(), 3);
        }
        return std::move(form_);
    }

   private:
    void add_ties() {
        for (int v = 0; v < form_.mesh.n_nodes(); ++v) {
            if (form_.mesh.orbit[v] == v) continue;
            const int* const offset = &form_.mesh.offsets[3 * static_cast<std::size_t>(v)];
            const space::Vec3 t = mesh_.lattice.translation({offset[0], offset[1], offset[2]});
            form_.ties.push_back({v, form_.mesh.orbit[v], {t.x(), t.y(), t.z()}});
        }
    }

    void add_cells() {
        for (int t = 0; t < static_cast<int>(mesh_.cell.size()); ++t) {
            const SiteId s = mesh_.cell[t];
            if (cells_.empty() || cells_.back() != s) {
                cells_.push_back(s);
                form_.cells.push_back({upper_case(kCellSet) + std::to_string(s)});
            }
            form_.cells.back().members.push_back(t);
        }
    }

    void add_node_sets() {
        form_.node_sets = {{upper_case(kGrainBoundarySet), contacts_.nodes[0]},
                           {upper_case(kTripleLinesSet), contacts_.nodes[1]},
                           {upper_case(kQuadruplePointsSet), contacts_.nodes[2]}};
        std::map<space::Offset, std::set<int>> seams;
        for (const SharedTriangle& triangle : contacts_.triangles) {
            if (!triangle.is_on_seam()) continue;
            add_side_nodes(triangle, 0, seams[triangle.offset]);
            add_side_nodes(triangle, 1, seams[-triangle.offset]);
        }
        for (const auto& [offset, nodes] : seams) {
            form_.node_sets.push_back({seam_name(offset), {nodes.begin(), nodes.end()}});
        }
        for (BoxSet& set : box_sets(form_.mesh)) {
            form_.node_sets.push_back({std::move(set.name), std::move(set.nodes), true});
        }
    }

    void add_side_nodes(const SharedTriangle& triangle, std::size_t side,
                        std::set<int>& nodes) const {
        const auto of_element = form_.mesh.elements.nodes[triangle.tetrahedra[side]];
        for (std::size_t k = 0; k < of_element.size(); ++k) {
            if (is_on_side(k, triangle.apexes[side])) nodes.insert(of_element[k]);
        }
    }

    static std::array<int, 2> numbered_side(const SharedTriangle& triangle, std::size_t side) {
        return {triangle.tetrahedra[side], kSideNumbers[triangle.apexes[side]]};
    }

    void add_surfaces() {
        InpSurface boundary{upper_case(kGrainBoundarySet) + upper_case(kSidesSuffix)};
        std::map<std::array<int, 2>, std::vector<std::array<int, 2>>> between;
        for (const SharedTriangle& triangle : contacts_.triangles) {
            if (!triangle.is_between_cells) continue;
            const std::array one = numbered_side(triangle, 0);
            const std::array other = numbered_side(triangle, 1);
            boundary.sides.push_back(std::min(one, other));
            if (materials_.site_phase.empty()) continue;
            const int p = materials_.site_phase[mesh_.cell[one[0]]];
            const int q = materials_.site_phase[mesh_.cell[other[0]]];
            if (p == q) continue;
            between[{p, q}].push_back(one);
            between[{q, p}].push_back(other);
        }
        std::sort(boundary.sides.begin(), boundary.sides.end());
        form_.surfaces.push_back(std::move(boundary));
        for (auto& [phases, sides] : between) {
            std::sort(sides.begin(), sides.end());
            form_.surfaces.push_back({upper_case(kPhaseSet) + materials_.phase_names[phases[0]] +
                                          "_TO_" + materials_.phase_names[phases[1]],
                                      std::move(sides)});
        }
    }

    const space::TetrahedralMesh& mesh_;
    const FileOptions& options_;
    InpForm form_;
    const TetrahedraContacts contacts_;
    CellMaterials materials_;
    /// The sites that have a set.
    std::vector<SiteId> cells_;
};

class TetrahedraInpParser final : public InpCards {
   public:
    using InpCards::InpCards;

    TetrahedralTile read() {
        parse();
        if (!lattice_)
            throw BadFile(name() + ": states no lattice; write the file again with pcvt");
        std::erase_if(nodes_,
                      [this](const NumberedPoint& node) { return is_control(node.number); });
        if (nodes_.empty() || found_.elements.size() == 0) {
            throw BadFile(name() + ": holds no tetrahedron; give the whole file");
        }
        TetrahedralTile tile{.mesh = {.lattice = *lattice_}, .materials = std::move(materials_)};
        space::TetrahedralMesh& mesh = tile.mesh;
        mesh.points = points_by_number(name(), nodes_);
        number_orbits(mesh);
        require_nodes(mesh.n_points());
        found_.name = name();
        place_tetrahedra(found_, mesh);
        if (sites_.empty()) {
            mesh.cell = cells();
        } else {
            take_sites(mesh);
        }
        find_point_offsets(name(), mesh);
        require_sorted_cells(name(), mesh);
        require_materials(name(), tile.materials, mesh.cell.empty() ? 0 : mesh.cell.back() + 1);
        return tile;
    }

   private:
    void take_comment(std::string_view key, const Words& values) override {
        if (take_material(scanner(), key, values, materials_)) return;
        if (key == "lattice") {
            take_lattice(values);
        } else if (key == "sites") {
            for (const std::string_view word : values) sites_.push_back(scanner().integer(word));
        } else if (key != "kind") {
            scanner().throw_bad_file("pcvt does not know " + in_quotes(key) + "; remove the line");
        }
    }

    void take_lattice(const Words& values) {
        if (values.size() != 9) scanner().throw_bad_file("the lattice has nine numbers");
        std::vector<double> periods;
        for (const std::string_view word : values) periods.push_back(scanner().number(word));
        try {
            lattice_ = lattice_from<space::Lattice>(periods);
        } catch (const InvalidInput& fault) {
            scanner().throw_bad_file(fault.what());
        }
    }

    void take_node(int number, const Position& position) override {
        nodes_.push_back({number, scanner().line(), position});
    }

    std::size_t n_element_nodes(const std::string& type) override {
        if (type == "C3D4") return 4;
        if (type == "C3D10") return 10;
        scanner().throw_bad_file("elements of type " + in_quotes(type) +
                                 " are not tetrahedra; give C3D4 or C3D10");
    }

    void take_element(int number, std::vector<int> nodes) override {
        ElementList& elements = found_.elements;
        const ElementKind kind =
            nodes.size() == 4 ? ElementKind::kTetrahedron4 : ElementKind::kTetrahedron10;
        if (elements.size() > 0 && elements.kind != kind) {
            scanner().throw_bad_file("the tetrahedra have not all as many nodes; take one order");
        }
        if (number != elements.size() + 1) {
            scanner().throw_bad_file(
                "the elements are not numbered 1, 2, ...; write the file again");
        }
        elements.kind = kind;
        for (int& v : nodes) --v;
        elements.nodes.add(nodes);
        found_.lines.push_back(scanner().line());
    }

    void take_cell_member(int element, int cell) override {
        members_.push_back({element, cell, scanner().line()});
    }

    /// Requires that the nodes of all elements exist.
    void require_nodes(int n) const {
        for (int t = 0; t < found_.elements.size(); ++t) {
            for (const int v : found_.elements.nodes[t]) {
                if (v >= 0 && v < n) continue;
                throw_bad_file(found_.lines[t],
                               "node " + std::to_string(v + 1) + " does not exist; correct it");
            }
        }
    }

    /// Numbers the nodes of the torus in the order of their first nodes: the first terms of an
    /// equation are a node and its representative.
    void number_orbits(space::TetrahedralMesh& mesh) const {
        std::vector<int> of(mesh.points.size());
        std::iota(of.begin(), of.end(), 0);
        const auto index = [&](const InpEquation& equation, std::size_t term) {
            const int number = term < equation.terms.size() ? equation.terms[term].node : 0;
            if (number >= 1 && number <= mesh.n_points()) return number - 1;
            throw_bad_file(equation.line,
                           "the equation does not tie a node to another one; write the file again "
                           "with pcvt");
        };
        for (const InpEquation& equation : equations()) of[index(equation, 0)] = index(equation, 1);
        std::vector<int> numbers(of.size(), -1);
        int n = 0;
        for (std::size_t v = 0; v < of.size(); ++v) {
            int& number = numbers[of[v]];
            if (number < 0) number = n++;
            mesh.point_site.push_back(number);
        }
    }

    void take_sites(space::TetrahedralMesh& mesh) const {
        const auto is_site = [&](int s) { return s >= 0 && s < mesh.n_points(); };
        if (sites_.size() != mesh.points.size() ||
            !std::all_of(sites_.begin(), sites_.end(), is_site)) {
            throw BadFile(name() + ": has not one site a node; write the file again with pcvt");
        }
        mesh.point_site = sites_;
    }

    std::vector<SiteId> cells() const {
        const int n = found_.elements.size();
        std::vector<SiteId> cells(static_cast<std::size_t>(n), -1);
        for (const auto& [element, cell, line] : members_) {
            if (element < 1 || element > n || cell < 0 || cell >= n) {
                throw_bad_file(line, "the set names an element or a cell that does not exist");
            }
            if (cells[element - 1] >= 0) {
                throw_bad_file(line, "element " + std::to_string(element) + " lies in two cells");
            }
            cells[element - 1] = cell;
        }
        return cells;
    }

    struct Member {
        int element;
        int cell;
        int line;
    };

    std::optional<space::Lattice> lattice_;
    CellMaterials materials_;
    std::vector<SiteId> sites_;
    std::vector<NumberedPoint> nodes_;
    FileTetrahedra found_{.index_base = 1};
    std::vector<Member> members_;
};

}  // namespace

std::vector<EncodedFile> encode_tetrahedra_inp(const space::TetrahedralMesh& mesh,
                                               const FileOptions& options,
                                               const std::string& path) {
    return only_file(path, inp_text(TetrahedraInp(mesh, options).make(), path));
}

bool holds_inp_tetrahedra(const EncodedFile& inp) { return states_tetrahedra(inp.bytes); }

TetrahedralTile decode_inp_tetrahedra(const EncodedFile& inp) {
    refuse_binary(inp.path, inp.bytes, "give an Abaqus or CalculiX input");
    return TetrahedraInpParser(inp.path, inp.bytes).read();
}

void compare_inp_tetrahedra(const EncodedFile& inp, const TetrahedralTile& tile) {
    const FileOptions options{.materials = tile.materials.empty() ? nullptr : &tile.materials};
    const std::vector<EncodedFile> expected = encode_tetrahedra_inp(tile.mesh, options, inp.path);
    compare_fields(*inp_fields(inp.path, inp.bytes), *inp_fields(inp.path, expected.front().bytes));
}

}  // namespace pcvt
