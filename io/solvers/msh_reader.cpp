#include "io/solvers/msh_reader.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "io/bytes/msh_text.hpp"
#include "io/bytes/text.hpp"
#include "io/solvers/msh_groups.hpp"
#include "io/tiles/file_tile_builder.hpp"
#include "io/tiles/material_words.hpp"

namespace pcvt {
namespace {

using Words = MshRows::Words;

constexpr int kLine = 1;
constexpr int kTriangle = 2;
constexpr int kLine3 = 8;
constexpr int kTriangle6 = 9;
constexpr int kPoint = 15;

/// Returns the number of nodes of an element type; 0 for types that a tile cannot have.
std::size_t n_nodes(int type) {
    switch (type) {
        case kPoint:
            return 1;
        case kLine:
            return 2;
        case kLine3:
        case kTriangle:
            return 3;
        case kTriangle6:
            return 6;
        default:
            return 0;
    }
}

/// The number of entries of an affine map, a 4 x 4 matrix stored row by row.
constexpr int kAffine = 16;

/// The link of one slave curve in $Periodic.
struct CurveLink {
    plane::Vec2 translation;
    std::map<int, int> master_of;
};

class MshParser {
   public:
    MshParser(const std::string& name, std::string_view text)
        : rows_(name, text), file_{.name = name, .index_base = 1, .notes = {.short_edges = 0}} {}

    FileTileBuilder parse() {
        if (!rows_.next_filled() || rows_.words() != Words{"$MeshFormat"}) {
            throw BadFile(name() + ": does not begin with $MeshFormat; give a file in MSH 4.1");
        }
        do parse_section();
        while (rows_.next_filled());
        if (is_ours_) {
            group_fault_ = groups_.fault(name(), file_.numbered, surfaces_, lines_);
        }
        // Sites count in a file of pcvt alone, and node sites determine the cells of triangles.
        if (!is_ours_ || !file_.numbered.node_sites.empty()) file_.numbered.triangle_sites.clear();
        if (!is_ours_) file_.numbered.node_sites.clear();
        if (is_ours_) collect_edges();
        return std::move(file_);
    }

    /// As MshGroups::fault(), after parse(). A fault of nodes or triangles matters more.
    const std::optional<std::string>& group_fault() const { return group_fault_; }

   private:
    const std::string& name() const { return file_.name; }

    void parse_section() {
        // A section begins with $NAME and ends with $EndNAME.
        const std::string section(rows_.words().front());
        if (section.size() < 2 || section[0] != '$' || section.starts_with("$End")) {
            rows_.throw_bad_file(in_quotes(section) +
                                 " does not begin a section; write the file again");
        }
        const std::string end = "$End" + section.substr(1);
        // Parsers that search for the end of their section have passed it: return.
        if (section == "$MeshFormat") {
            parse_format();
        } else if (section == "$Comments") {
            parse_comments(end);
            return;
        } else if (section == "$PhysicalNames" && is_ours_) {
            groups_.parse_names(rows_);
        } else if (section == "$Entities" && is_ours_) {
            groups_.parse_entities(rows_);
        } else if (section == "$Nodes") {
            parse_nodes();
        } else if (section == "$Elements") {
            parse_elements();
        } else if (section == "$Periodic") {
            parse_periodic();
        } else if (section == "$NodeData") {
            parse_data(end, file_.numbered.node_sites);
            return;
        } else if (section == "$ElementData") {
            parse_data(end, file_.numbered.triangle_sites);
            return;
        } else {
            while (rows_.next_row().front() != end) continue;
            return;
        }
        // The other parsers stop before it.
        if (rows_.next_row().front() != end)
            rows_.throw_bad_file("the section has more lines than its count; correct the count");
    }

    void parse_format() {
        rows_.next_row(3);
        if (rows_.words()[0] != "4.1") {
            rows_.throw_bad_file("the version is " + in_quotes(rows_.words()[0]) +
                                 "; save the file as MSH 4.1");
        }
        if (rows_.words()[1] != "0") rows_.throw_bad_file("the file is binary; save it as ASCII");
    }

    void parse_comments(const std::string& end) {
        while (rows_.next_row().front() != end) {
            const Words& words = rows_.words();
            if (words.size() < 2 || words[0] != "pcvt") continue;
            is_ours_ = true;
            const Words values(words.begin() + 2, words.end());
            if (file_.take_comment(rows_.scanner(), words[1], values)) continue;
            if (take_material(rows_.scanner(), words[1], values, file_.materials)) continue;
            rows_.throw_bad_file("pcvt does not know " + in_quotes(words[1]) + "; remove the line");
        }
    }

    void parse_nodes() {
        rows_.next_row(4);
        for (int block = rows_.count(0); block > 0; --block) {
            rows_.next_row(4);
            if (rows_.integer(2) != 0)
                rows_.throw_bad_file("nodes with parameters; save without them");
            const int n = rows_.count(3);
            const std::size_t first = file_.numbered.nodes.size();
            for (int k = 0; k < n; ++k) {
                rows_.next_row(1);
                file_.numbered.nodes.push_back(
                    {rows_.integer(0), rows_.line(), plane::Vec2::Zero()});
            }
            for (int k = 0; k < n; ++k) {
                rows_.next_row(3);
                if (rows_.number(2) != 0)
                    rows_.throw_bad_file("z is not 0; move the tile to the plane z = 0");
                file_.numbered.nodes[first + static_cast<std::size_t>(k)].point = {rows_.number(0),
                                                                                   rows_.number(1)};
            }
        }
    }

    void parse_elements() {
        rows_.next_row(4);
        for (int block = rows_.count(0); block > 0; --block) {
            rows_.next_row(4);
            const int dimension = rows_.integer(0);
            const int entity = rows_.integer(1);
            const int type = rows_.integer(2);
            if (n_nodes(type) == 0) {
                rows_.throw_bad_file("elements of type " + std::to_string(type) +
                                     " are no triangles; give a mesh of triangles");
            }
            for (int n = rows_.count(3); n > 0; --n) parse_element(type, dimension, entity);
        }
    }

    void parse_element(int type, int dimension, int entity) {
        const std::size_t n = n_nodes(type);
        rows_.next_row(1 + n);
        if (type == kTriangle || type == kTriangle6) {
            std::vector<int> nodes;
            for (std::size_t k = 1; k <= n; ++k) nodes.push_back(rows_.integer(k));
            file_.numbered.triangles.push_back({rows_.integer(0), rows_.line(), std::move(nodes)});
            surfaces_.push_back(entity);
        } else if (type != kPoint && dimension == kMshCurves) {
            std::optional<int> middle;
            if (type == kLine3) middle = rows_.integer(3);
            lines_.push_back({.curve = entity,
                              .from = rows_.integer(1),
                              .to = rows_.integer(2),
                              .middle = middle,
                              .line = rows_.line()});
        }
    }

    void parse_periodic() {
        rows_.next_row(1);
        for (int n = rows_.count(0); n > 0; --n) parse_link();
    }

    void parse_link() {
        rows_.next_row(3);
        const bool of_curves = rows_.integer(0) == kMshCurves;
        const int slave = rows_.integer(1);
        const plane::Vec2 translation = parse_translation();
        rows_.next_row(1);
        for (int n = rows_.count(0); n > 0; --n) {
            rows_.next_row(2);
            file_.numbered.links.push_back(
                {rows_.integer(0), rows_.integer(1), rows_.line(), translation});
            if (!of_curves) continue;
            CurveLink& link = curves_[slave];
            link.translation = translation;
            link.master_of[rows_.integer(0)] = rows_.integer(1);
        }
    }

    plane::Vec2 parse_translation() {
        rows_.next_row(kAffine + 1);
        for (int k = 0; k < kAffine; ++k) {
            const bool shift = k == 3 || k == 7;
            const double identity = k % 5 == 0 ? 1 : 0;
            if (shift || rows_.number(static_cast<std::size_t>(k) + 1) == identity) continue;
            rows_.throw_bad_file(
                "the affine map of the slave is not a translation in the plane; write the file "
                "again with pcvt");
        }
        return {rows_.number(4), rows_.number(8)};
    }

    /// Reads the view named "cell_id"; skips the others.
    void parse_data(const std::string& end, std::vector<NumberedItems::SiteOf>& sites) {
        // The first string tag is the name.
        std::string view;
        for (int n = (rows_.next_row(1), rows_.count(0)); n > 0; --n) {
            rows_.next_row();
            if (view.empty()) view = std::string(rows_.words().front());
        }
        if (view != "\"cell_id\"") {
            while (rows_.next_row().front() != end) continue;
            return;
        }
        // Skip the real tags; the last integer tag is the number of values.
        for (int n = (rows_.next_row(1), rows_.count(0)); n > 0; --n) rows_.next_row();
        int n_values = 0;
        for (int n = (rows_.next_row(1), rows_.count(0)); n > 0; --n)
            n_values = (rows_.next_row(1), rows_.count(0));
        for (; n_values > 0; --n_values) {
            rows_.next_row(2);
            // Elements other than triangles have no cell and the value -1.
            if (rows_.number(1) >= 0)
                sites.push_back({rows_.integer(0), rows_.line(), rows_.integer(1)});
        }
        if (rows_.next_row().front() != end)
            rows_.throw_bad_file("the section has more lines than its count; correct the count");
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

    MshRows rows_;
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
    MshParser parser(msh.path, msh.bytes);
    TileFile file = finish(parser.parse(), lattice, plane::Precision::kDouble);
    if (parser.group_fault()) throw BadFile(*parser.group_fault());
    return file;
}

}  // namespace pcvt
