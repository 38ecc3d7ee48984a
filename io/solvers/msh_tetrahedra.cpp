#include "io/solvers/msh_tetrahedra.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/lattice_numbers.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/forms/tetrahedra_entities.hpp"
#include "io/solvers/msh_fields.hpp"
#include "io/solvers/msh_sections.hpp"
#include "io/solvers/msh_writer.hpp"

namespace pcvt {
namespace {

class TetrahedraParser final : public MshSections {
   public:
    using MshSections::MshSections;

    TetrahedralTile read() {
        parse();
        if (!mesh_) throw BadFile(name() + ": states no lattice; write the file again with pcvt");
        if (mesh_->points.empty() || found_.elements.size() == 0) {
            throw BadFile(name() + ": holds no tetrahedron; give the whole file");
        }
        if (mesh_->point_site.size() != mesh_->points.size()) {
            throw BadFile(
                name() +
                ": $NodeData states neither the site of each node nor its orbit; write the "
                "file again with pcvt");
        }
        found_.name = name();
        place_tetrahedra(found_, *mesh_);
        require_sites();
        find_point_offsets(name(), *mesh_);
        require_sorted_cells(name(), *mesh_);
        require_materials(name(), materials_, mesh_->cell.empty() ? 0 : mesh_->cell.back() + 1);
        return {*std::move(mesh_), std::move(materials_)};
    }

   private:
    /// Requires a site for each corner; nodes in the middle of edges have none.
    void require_sites() const {
        const std::vector<SiteId>& sites = mesh_->point_site;
        if (std::find(sites.begin(), sites.end(), -1) == sites.end()) return;
        throw BadFile(name() + ": a node has no site; write the file again with pcvt");
    }

    void take_comment() override {
        const MshRows::Words& words = rows().words();
        if (words.size() < 2 || words[0] != "pcvt") return;
        const MshRows::Words values(words.begin() + 2, words.end());
        if (take_material(rows().scanner(), words[1], values, materials_)) return;
        if (words[1] != "lattice") return;
        constexpr std::size_t kWords = 11;
        if (words.size() != kWords) rows().throw_bad_file("the lattice has nine numbers");
        std::vector<double> periods;
        for (std::size_t k = 2; k < kWords; ++k) periods.push_back(rows().number(k));
        try {
            mesh_ = space::TetrahedralMesh{.lattice = lattice_from<space::Lattice>(periods)};
        } catch (const InvalidInput& fault) {
            rows().throw_bad_file(fault.what());
        }
    }

    space::TetrahedralMesh& mesh() {
        if (!mesh_) rows().throw_bad_file("the lattice comes before this; write the file again");
        return *mesh_;
    }

    void take_node(int number, int line, const Position& position) override {
        nodes_.push_back({number, line, position});
    }

    void end_nodes() override { mesh().points = points_by_number(name(), nodes_); }

    /// Returns the number of a node minus 1.
    int node(std::size_t word) {
        const int number = rows().integer(word);
        if (number < 1 || number > mesh().n_points()) {
            rows().throw_bad_file(std::to_string(number) + " is not a number from 1 to " +
                                  std::to_string(mesh().n_points()) + "; correct it");
        }
        return number - 1;
    }

    bool takes(const ElementType* type, int /*number*/) override {
        if (type == nullptr || type->n_corners != 4 || type->dimension != 3) return false;
        ElementList& elements = found_.elements;
        if (elements.size() > 0 && elements.kind != type->kind) {
            rows().throw_bad_file("the tetrahedra have not all as many nodes; take one order");
        }
        elements.kind = type->kind;
        return true;
    }

    void take_element(const ElementType& type, int /*dimension*/, int /*entity*/) override {
        for (std::size_t k = 0; k < static_cast<std::size_t>(type.n_nodes); ++k) {
            found_.elements.nodes.corners.push_back(node(1 + type.place_in_msh(k)));
        }
        found_.elements.nodes.close();
        found_.lines.push_back(rows().line());
    }

    bool states_sites(std::string_view view, bool of_nodes) override {
        return view == "cell_id" || (of_nodes && view == "periodic_node");
    }

    bool takes_sites(bool of_nodes, int n_values) override {
        if (!of_nodes) {
            mesh().cell.assign(static_cast<std::size_t>(found_.elements.size()), -1);
            return true;
        }
        if (n_values != mesh().n_points())
            rows().throw_bad_file("the view has not one site a node");
        mesh().point_site.assign(mesh().points.size(), -1);
        return true;
    }

    /// The sides, which have larger numbers than the tetrahedra, belong to no cell.
    void take_cell() {
        const int element = rows().integer(0);
        if (element < 1) rows().throw_bad_file("elements are numbered from 1; correct the number");
        if (element > found_.elements.size()) return;
        const int site = rows().integer(1);
        if (site < 0 || site >= found_.elements.size()) {
            rows().throw_bad_file(std::to_string(site) + " is not a site; correct it");
        }
        mesh().cell[element - 1] = site;
    }

    void take_site(bool of_nodes) override {
        if (!of_nodes) {
            take_cell();
            return;
        }
        SiteId& site = mesh().point_site[node(0)];
        if (site >= 0) rows().throw_bad_file("the node occurs twice; correct it");
        site = rows().integer(1);
        if (site < -1 || site >= mesh().n_points()) {
            rows().throw_bad_file(std::to_string(site) + " is not a site; correct it");
        }
    }

    std::optional<space::TetrahedralMesh> mesh_;
    FileTetrahedra found_{.index_base = 1};
    CellMaterials materials_;
    std::vector<NumberedPoint> nodes_;
};

}  // namespace

bool holds_msh_tetrahedra(const EncodedFile& msh) { return states_tetrahedra(msh.bytes); }

TetrahedralTile decode_msh_tetrahedra(const EncodedFile& msh) {
    refuse_binary(msh.path, msh.bytes, "save it as ASCII, MSH 4.1");
    return TetrahedraParser(msh.path, msh.bytes).read();
}

void compare_msh_tetrahedra(const EncodedFile& msh, const TetrahedralTile& tile) {
    const std::vector<EncodedFile> expected =
        encode_msh(entity_mesh(tile.mesh, &tile.materials), msh.path);
    compare_fields(*msh_fields(msh.path, msh.bytes), *msh_fields(msh.path, expected.front().bytes));
}

}  // namespace pcvt
