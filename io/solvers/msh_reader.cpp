#include "io/solvers/msh_reader.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/tiles/file_tile_builder.hpp"

namespace pcvt {
namespace {

using Words = std::vector<std::string_view>;

constexpr int kLine = 1;
constexpr int kTriangle = 2;
constexpr int kLine3 = 8;
constexpr int kTriangle6 = 9;
constexpr int kPoint = 15;
constexpr int kCurves = 1;
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

/// A line element and the curve that it lies on.
struct LineElement {
    int curve;
    int from;
    int to;
    std::optional<int> middle;
    int line;
};

/// The link of one slave curve in $Periodic.
struct CurveLink {
    Vec2 translation;
    std::map<int, int> master_of;
};

class MshParser {
   public:
    MshParser(const std::string& name, std::string_view text)
        : scanner_(name, text), file_{.name = name, .index_base = 1} {}

    FileTileBuilder parse() {
        if (!next_filled() || scanner_.words() != Words{"$MeshFormat"}) {
            throw BadFile(name() + ": does not begin with $MeshFormat; give a file in MSH 4.1");
        }
        do parse_section();
        while (next_filled());
        // Sites count in a file of pcvt alone, and node sites determine the cells of triangles.
        if (!is_ours_ || !file_.numbered.node_sites.empty()) file_.numbered.triangle_sites.clear();
        if (!is_ours_) file_.numbered.node_sites.clear();
        if (is_ours_) collect_edges();
        return std::move(file_);
    }

   private:
    const std::string& name() const { return file_.name; }

    /// Advances to the next line that is not blank; returns false at the end of the text.
    bool next_filled() {
        while (scanner_.next()) {
            if (!scanner_.words().empty()) return true;
        }
        return false;
    }

    /// Returns the words of the next line of a section.
    const Words& row() {
        if (!next_filled()) {
            throw BadFile(name() + ": ends inside of a section; give the whole file");
        }
        return scanner_.words();
    }
    const Words& row(std::size_t n_words) {
        if (row().size() != n_words) {
            scanner_.throw_bad_file("the line has " + std::to_string(scanner_.words().size()) +
                                    " words where " + std::to_string(n_words) +
                                    " belong; write the file again");
        }
        return scanner_.words();
    }
    int integer(std::size_t word) const { return scanner_.integer(scanner_.words()[word]); }
    double number(std::size_t word) const { return scanner_.number(scanner_.words()[word]); }
    int count(std::size_t word) const {
        const int n = integer(word);
        if (n < 0) scanner_.throw_bad_file("a count is negative; correct it");
        return n;
    }

    void parse_section() {
        // A section begins with $NAME and ends with $EndNAME.
        const std::string section(scanner_.words().front());
        if (section.size() < 2 || section[0] != '$' || section.starts_with("$End")) {
            scanner_.throw_bad_file(in_quotes(section) +
                                    " does not begin a section; write the file again");
        }
        const std::string end = "$End" + section.substr(1);
        // Parsers that search for the end of their section have passed it: return.
        if (section == "$MeshFormat") {
            parse_format();
        } else if (section == "$Comments") {
            parse_comments(end);
            return;
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
            while (row().front() != end) continue;
            return;
        }
        // The other parsers stop before it.
        if (row().front() != end)
            scanner_.throw_bad_file("the section has more lines than its count; correct the count");
    }

    void parse_format() {
        row(3);
        if (scanner_.words()[0] != "4.1") {
            scanner_.throw_bad_file("the version is " + in_quotes(scanner_.words()[0]) +
                                    "; save the file as MSH 4.1");
        }
        if (scanner_.words()[1] != "0")
            scanner_.throw_bad_file("the file is binary; save it as ASCII");
    }

    void parse_comments(const std::string& end) {
        while (row().front() != end) {
            const Words& words = scanner_.words();
            if (words.size() < 2 || words[0] != "pcvt") continue;
            is_ours_ = true;
            const Words values(words.begin() + 2, words.end());
            if (words[1] == "kind") {
                file_.take_kind(scanner_, values);
            } else if (words[1] == "lattice") {
                file_.take_lattice(scanner_, values);
            } else {
                scanner_.throw_bad_file("pcvt does not know " + in_quotes(words[1]) +
                                        "; remove the line");
            }
        }
    }

    void parse_nodes() {
        row(4);
        for (int block = count(0); block > 0; --block) {
            row(4);
            if (integer(2) != 0)
                scanner_.throw_bad_file("nodes with parameters; save without them");
            const int n = count(3);
            const std::size_t first = file_.numbered.nodes.size();
            for (int k = 0; k < n; ++k) {
                row(1);
                file_.numbered.nodes.push_back({integer(0), scanner_.line(), Vec2::Zero()});
            }
            for (int k = 0; k < n; ++k) {
                row(3);
                if (number(2) != 0)
                    scanner_.throw_bad_file("z is not 0; move the tile to the plane z = 0");
                file_.numbered.nodes[first + static_cast<std::size_t>(k)].point = {number(0),
                                                                                   number(1)};
            }
        }
    }

    void parse_elements() {
        row(4);
        for (int block = count(0); block > 0; --block) {
            row(4);
            const int dimension = integer(0);
            const int entity = integer(1);
            const int type = integer(2);
            if (n_nodes(type) == 0) {
                scanner_.throw_bad_file("elements of type " + std::to_string(type) +
                                        " are no triangles; give a mesh of triangles");
            }
            for (int n = count(3); n > 0; --n)
                parse_element(type, dimension == kCurves ? entity : -1);
        }
    }

    void parse_element(int type, int curve) {
        const std::size_t n = n_nodes(type);
        row(1 + n);
        if (type == kTriangle || type == kTriangle6) {
            std::vector<int> nodes;
            for (std::size_t k = 1; k <= n; ++k) nodes.push_back(integer(k));
            file_.numbered.triangles.push_back({integer(0), scanner_.line(), std::move(nodes)});
        } else if (type != kPoint && curve >= 0) {
            std::optional<int> middle;
            if (type == kLine3) middle = integer(3);
            lines_.push_back({.curve = curve,
                              .from = integer(1),
                              .to = integer(2),
                              .middle = middle,
                              .line = scanner_.line()});
        }
    }

    void parse_periodic() {
        row(1);
        for (int n = count(0); n > 0; --n) parse_link();
    }

    void parse_link() {
        row(3);
        const bool of_curves = integer(0) == kCurves;
        const int slave = integer(1);
        const Vec2 translation = parse_translation();
        row(1);
        for (int n = count(0); n > 0; --n) {
            row(2);
            file_.numbered.links.push_back({integer(0), integer(1), scanner_.line(), translation});
            if (!of_curves) continue;
            CurveLink& link = curves_[slave];
            link.translation = translation;
            link.master_of[integer(0)] = integer(1);
        }
    }

    Vec2 parse_translation() {
        row(kAffine + 1);
        for (int k = 0; k < kAffine; ++k) {
            const bool shift = k == 3 || k == 7;
            const double identity = k % 5 == 0 ? 1 : 0;
            if (shift || number(static_cast<std::size_t>(k) + 1) == identity) continue;
            scanner_.throw_bad_file(
                "the affine map of the slave is not a translation in the plane; write the file "
                "again with pcvt");
        }
        return {number(4), number(8)};
    }

    /// Reads the view named "cell_id"; skips the others.
    void parse_data(const std::string& end, std::vector<NumberedItems::SiteOf>& sites) {
        // The first string tag is the name.
        std::string view;
        for (int n = (row(1), count(0)); n > 0; --n) {
            row();
            if (view.empty()) view = std::string(scanner_.words().front());
        }
        if (view != "\"cell_id\"") {
            while (row().front() != end) continue;
            return;
        }
        // Skip the real tags; the last integer tag is the number of values.
        for (int n = (row(1), count(0)); n > 0; --n) row();
        int n_values = 0;
        for (int n = (row(1), count(0)); n > 0; --n) n_values = (row(1), count(0));
        for (; n_values > 0; --n_values) {
            row(2);
            // Elements other than triangles have no cell and the value -1.
            if (number(1) >= 0) sites.push_back({integer(0), scanner_.line(), integer(1)});
        }
        if (row().front() != end)
            scanner_.throw_bad_file("the section has more lines than its count; correct the count");
    }

    /// Pairs the lines of each slave curve with their partners.
    void collect_edges() {
        for (const LineElement& element : lines_) {
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

    LineScanner scanner_;
    FileTileBuilder file_;
    std::vector<LineElement> lines_;
    std::map<int, CurveLink> curves_;
    bool is_ours_ = false;
};

}  // namespace

TileFile decode_msh(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice) {
    const EncodedFile& msh = files.front();
    refuse_binary(msh.path, msh.bytes, "save it as ASCII, MSH 4.1");
    return finish(MshParser(msh.path, msh.bytes).parse(), lattice, Precision::kDouble);
}

}  // namespace pcvt
