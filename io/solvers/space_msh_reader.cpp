#include "io/solvers/space_msh_reader.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "io/bytes/msh_text.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/solvers/msh_fields.hpp"
#include "io/solvers/msh_rows.hpp"
#include "io/solvers/space_msh_writer.hpp"

namespace pcvt {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

class TetrahedraParser {
   public:
    TetrahedraParser(const std::string& name, std::string_view text)
        : name_(name), rows_(name, text) {}

    space::TetrahedralMesh parse() {
        while (rows_.next_filled()) parse_section();
        if (!mesh_) throw BadFile(name_ + ": states no lattice; write the file again with pcvt");
        if (mesh_->points.empty() || mesh_->tetrahedra.empty()) {
            throw BadFile(name_ + ": holds no tetrahedron; give the whole file");
        }
        if (mesh_->point_site.size() != mesh_->points.size()) {
            throw BadFile(name_ +
                          ": $NodeData \"cell_id\" does not state the site of each node; write the "
                          "file again with pcvt");
        }
        find_point_offsets(name_, *mesh_);
        return *std::move(mesh_);
    }

   private:
    void parse_section() {
        const std::string section(rows_.words().front());
        const std::string end = "$End" + section.substr(1);
        if (section == "$Nodes") {
            parse_nodes();
        } else if (section == "$Elements") {
            parse_elements();
        } else if (section == "$NodeData") {
            parse_sites();
        }
        while (rows_.next_row().front() != end) {
            if (section == "$Comments") parse_comment();
        }
    }

    void parse_comment() {
        const MshRows::Words& words = rows_.words();
        if (words.size() < 2 || words[0] != "pcvt" || words[1] != "lattice") return;
        constexpr std::size_t kWords = 11;
        if (words.size() != kWords) rows_.throw_bad_file("the lattice has nine numbers");
        std::array<space::Vec3, 3> periods;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                periods[k][Eigen::Index(i)] = rows_.number(2 + 3 * k + i);
            }
        }
        try {
            mesh_ = space::TetrahedralMesh{.lattice = {periods[0], periods[1], periods[2]}};
        } catch (const InvalidInput& fault) {
            rows_.throw_bad_file(fault.what());
        }
    }

    space::TetrahedralMesh& mesh() {
        if (!mesh_) rows_.throw_bad_file("the lattice comes before this; write the file again");
        return *mesh_;
    }

    /// Returns a tag minus 1, which is below `n`.
    int index(std::size_t word, int n) const {
        const int tag = rows_.integer(word);
        if (tag < 1 || tag > n) {
            rows_.throw_bad_file(std::to_string(tag) + " is not a number from 1 to " +
                                 std::to_string(n) + "; correct it");
        }
        return tag - 1;
    }

    void parse_nodes() {
        rows_.next_row(4);
        const int n_blocks = rows_.count(0);
        const int n = rows_.count(1);
        for (int block = 0; block < n_blocks; ++block) {
            rows_.next_row(4);
            // Grows with the rows, so that a wrong count does not take memory.
            std::vector<int> nodes;
            const int n_own = rows_.count(3);
            for (int k = 0; k < n_own; ++k) {
                rows_.next_row(1);
                nodes.push_back(index(0, n));
            }
            for (const int v : nodes) {
                rows_.next_row(3);
                const auto place = static_cast<std::size_t>(v);
                positions_.emplace_back(
                    place, space::Vec3(rows_.number(0), rows_.number(1), rows_.number(2)));
            }
        }
        if (positions_.size() != static_cast<std::size_t>(n)) {
            rows_.throw_bad_file("the blocks have another number of nodes than the section states");
        }
        std::vector<space::Vec3>& points = mesh().points;
        points.assign(positions_.size(), space::Vec3::Constant(kNowhere));
        for (const auto& [v, position] : positions_) {
            if (points[v].x() != kNowhere) {
                rows_.throw_bad_file("node " + std::to_string(v + 1) + " occurs twice");
            }
            points[v] = position;
        }
    }

    void parse_elements() {
        rows_.next_row(4);
        const int n_blocks = rows_.count(0);
        for (int block = 0; block < n_blocks; ++block) {
            rows_.next_row(4);
            const int type = rows_.integer(2);
            const int n = rows_.count(3);
            for (int k = 0; k < n; ++k) {
                rows_.next_row();
                if (type != kMshTetrahedron) continue;
                constexpr std::size_t kWords = 5;
                if (rows_.words().size() != kWords)
                    rows_.throw_bad_file("a tetrahedron has 4 nodes");
                std::array<int, 4>& corners = mesh().tetrahedra.emplace_back();
                for (std::size_t i = 0; i < 4; ++i) corners[i] = index(i + 1, mesh().n_points());
            }
        }
    }

    /// Reads the view "cell_id"; leaves others.
    void parse_sites() {
        rows_.next_row();
        rows_.next_row();
        if (rows_.words().front() != "\"cell_id\"") return;
        constexpr int kRowsBeforeCount = 5;
        for (int k = 0; k < kRowsBeforeCount; ++k) rows_.next_row();
        rows_.next_row(1);
        const int n = rows_.count(0);
        if (n != mesh().n_points()) rows_.throw_bad_file("the view has not one site a node");
        std::vector<SiteId>& sites = mesh().point_site;
        sites.assign(mesh().points.size(), -1);
        for (int k = 0; k < n; ++k) {
            rows_.next_row(2);
            const int v = index(0, n);
            if (sites[v] >= 0) rows_.throw_bad_file("the node occurs twice; correct it");
            sites[v] = rows_.integer(1);
            if (sites[v] < 0 || sites[v] >= n) {
                rows_.throw_bad_file(std::to_string(sites[v]) + " is no site; correct it");
            }
        }
    }

    std::string name_;
    MshRows rows_;
    std::optional<space::TetrahedralMesh> mesh_;
    std::vector<std::pair<std::size_t, space::Vec3>> positions_;
};

}  // namespace

bool holds_tetrahedra(const EncodedFile& msh) {
    const std::size_t at = msh.bytes.find(kTetrahedraComment);
    if (at == std::string::npos) return false;
    const char next = msh.bytes[at + kTetrahedraComment.size()];
    return next == '\n' || next == '\r';
}

space::TetrahedralMesh decode_space_msh(const EncodedFile& msh) {
    refuse_binary(msh.path, msh.bytes, "save it as ASCII, MSH 4.1");
    return TetrahedraParser(msh.path, msh.bytes).parse();
}

void compare_space_msh(const EncodedFile& msh, const space::TetrahedralMesh& mesh) {
    const std::vector<EncodedFile> expected = encode_space_msh(mesh, msh.path);
    compare_fields(*msh_fields(msh.path, msh.bytes), *msh_fields(msh.path, expected.front().bytes));
}

}  // namespace pcvt
