#include "io/solvers/msh_reader.hpp"

#include <map>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/forms/material_words.hpp"
#include "io/solvers/msh_groups.hpp"
#include "io/solvers/msh_sections.hpp"

namespace pcvt {
namespace {

using Words = MshRows::Words;

/// The number of entries of an affine map, a 4 x 4 matrix stored row by row.
constexpr int kAffine = 16;

/// The link of one slave curve in $Periodic.
struct CurveLink {
    plane::Vec2 translation;
    std::map<int, int> master_of;
};

class TileParser final : public MshSections {
   public:
    TileParser(const std::string& name, std::string_view text)
        : MshSections(name, text),
          file_{.name = name, .index_base = 1, .notes = {.short_edges = 0}} {}

    FileTileBuilder read() {
        parse();
        if (is_ours_) {
            group_fault_ = groups_.fault(name(), file_.numbered, surfaces_, lines_);
        }
        // Sites count only in a file of pcvt, and node sites determine the cells of triangles.
        if (!is_ours_ || !file_.numbered.node_sites.empty()) file_.numbered.triangle_sites.clear();
        if (!is_ours_) file_.numbered.node_sites.clear();
        if (is_ours_) collect_edges();
        return std::move(file_);
    }

    /// As MshGroups::fault(), after read(). A fault of nodes or triangles matters more.
    const std::optional<std::string>& group_fault() const { return group_fault_; }

   private:
    void take_comment() override {
        const Words& words = rows().words();
        if (words.size() < 2 || words[0] != "pcvt") return;
        is_ours_ = true;
        const Words values(words.begin() + 2, words.end());
        if (file_.take_comment(rows().scanner(), words[1], values)) return;
        if (take_material(rows().scanner(), words[1], values, file_.materials)) return;
        rows().throw_bad_file("pcvt does not know " + in_quotes(words[1]) + "; remove the line");
    }

    bool take_section(std::string_view section) override {
        if (section == "$PhysicalNames" && is_ours_) {
            groups_.parse_names(rows());
        } else if (section == "$Entities" && is_ours_) {
            groups_.parse_entities(rows());
        } else if (section == "$Periodic") {
            for (int n = (rows().next_row(1), rows().count(0)); n > 0; --n) parse_link();
        } else {
            return false;
        }
        return true;
    }

    void take_node(int number, int line, const Position& position) override {
        if (position[2] != 0) rows().throw_bad_file("z is not 0; move the tile to the plane z = 0");
        file_.numbered.nodes.push_back({number, line, {position[0], position[1]}});
    }

    bool takes(const ElementType* type, int number) override {
        if (type != nullptr && type->dimension <= 2) return true;
        rows().throw_bad_file("elements of type " + std::to_string(number) +
                              " are not triangles; give a mesh of triangles");
    }

    void take_element(const ElementType& type, int dimension, int entity) override {
        if (type.dimension == 2) {
            std::vector<int> nodes;
            for (int k = 1; k <= type.n_nodes; ++k) nodes.push_back(rows().integer(std::size_t(k)));
            file_.numbered.triangles.push_back(
                {rows().integer(0), rows().line(), std::move(nodes)});
            surfaces_.push_back(entity);
        } else if (type.dimension == 1 && dimension == kMshCurves) {
            std::optional<int> middle;
            if (type.kind == ElementKind::kLine3) middle = rows().integer(3);
            lines_.push_back({.curve = entity,
                              .from = rows().integer(1),
                              .to = rows().integer(2),
                              .middle = middle,
                              .line = rows().line()});
        }
    }

    void parse_link() {
        rows().next_row(3);
        const bool of_curves = rows().integer(0) == kMshCurves;
        const int slave = rows().integer(1);
        const plane::Vec2 translation = parse_translation();
        rows().next_row(1);
        for (int n = rows().count(0); n > 0; --n) {
            rows().next_row(2);
            file_.numbered.links.push_back(
                {rows().integer(0), rows().integer(1), rows().line(), translation});
            if (!of_curves) continue;
            CurveLink& link = curves_[slave];
            link.translation = translation;
            link.master_of[rows().integer(0)] = rows().integer(1);
        }
    }

    plane::Vec2 parse_translation() {
        rows().next_row(kAffine + 1);
        for (int k = 0; k < kAffine; ++k) {
            const bool shift = k == 3 || k == 7;
            const double identity = k % 5 == 0 ? 1 : 0;
            if (shift || rows().number(static_cast<std::size_t>(k) + 1) == identity) continue;
            rows().throw_bad_file(
                "the affine map of the slave is not a translation in the plane; write the file "
                "again with pcvt");
        }
        return {rows().number(4), rows().number(8)};
    }

    bool takes_sites(bool /*of_nodes*/, int /*n_values*/) override { return true; }

    void take_site(bool of_nodes) override {
        // Elements other than triangles have no cell and the value -1.
        if (rows().number(1) < 0) return;
        NumberedItems& items = file_.numbered;
        (of_nodes ? items.node_sites : items.triangle_sites)
            .push_back({rows().integer(0), rows().line(), rows().integer(1)});
    }

    /// Pairs the lines of each slave curve with their partners.
    void collect_edges() {
        for (const MshLine& element : lines_) {
            const auto curve = curves_.find(element.curve);
            if (curve == curves_.end()) continue;
            const std::map<int, int>& master_of = curve->second.master_of;
            const auto from = master_of.find(element.from);
            const auto to = master_of.find(element.to);
            if (from == master_of.end() || to == master_of.end()) {
                throw BadFile(name() + ":" + std::to_string(element.line) +
                              ": $Periodic has no master for an end of this line; write the file "
                              "again with pcvt");
            }
            file_.numbered.edges.push_back({{element.from, element.to, from->second, to->second},
                                            element.middle,
                                            element.line,
                                            -curve->second.translation});
        }
    }

    FileTileBuilder file_;
    MshGroups groups_;
    /// The tag of the surface of each triangle.
    std::vector<int> surfaces_;
    std::vector<MshLine> lines_;
    std::map<int, CurveLink> curves_;
    std::optional<std::string> group_fault_;
    bool is_ours_ = false;
};

}  // namespace

TileFile decode_msh(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& msh = files.front();
    refuse_binary(msh.path, msh.bytes, "save it as ASCII, MSH 4.1");
    TileParser parser(msh.path, msh.bytes);
    TileFile file = finish(parser.read(), lattice, plane::Precision::kDouble);
    if (parser.group_fault()) throw BadFile(*parser.group_fault());
    return file;
}

}  // namespace pcvt
