#include "io/surfaces/surface_obj_reader.hpp"

#include <array>
#include <span>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/tiles/tile_file.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kObjCellsMark = "# pcvt kind polyhedra\n";
constexpr std::string_view kObjBoundaryMark = "# pcvt kind boundary\n";
/// The mark follows the explanation.
constexpr std::size_t kObjHeadBytes = 1024;

/// Reads one OBJ line by line.
class SurfaceObjParser {
   public:
    explicit SurfaceObjParser(const EncodedFile& obj) : scanner_(obj.path, obj.bytes) {}

    SurfaceList parse() {
        while (scanner_.next()) {
            checkpoint_each(scanner_.line());
            parse_line();
        }
        if (!has_lattice_) scanner_.throw_bad_file("the lattice is missing; give the whole file");
        list_.sites = Eigen::Map<const space::Points>(sites_.data(), 3,
                                                      static_cast<Eigen::Index>(sites_.size() / 3));
        if (list_.form == SurfaceForm::kBoundary) link_pairs();
        return std::move(list_);
    }

   private:
    using Words = std::span<const std::string_view>;

    void parse_line() {
        const Words words = scanner_.words();
        if (words.empty()) return;
        if (words.size() >= 3 && words[0] == "#" && words[1] == "pcvt") {
            parse_comment(words[2], words.subspan(3));
        } else if (words[0] == "v") {
            const auto [x, y, z] = numbers<3>(words.subspan(1));
            list_.points.emplace_back(x, y, z);
        } else if (words[0] == "g") {
            ++n_groups_;
        } else if (words[0] == "f") {
            for (const std::string_view word : words.subspan(1)) {
                list_.faces.corners.push_back(index(word));
            }
            list_.faces.close();
            // The groups of polyhedra are their cells; the cells behind a boundary are listed.
            if (list_.form == SurfaceForm::kCells) list_.cell.push_back(n_groups_ - 1);
        } else if (words[0][0] != '#' && words[0] != "mtllib" && words[0] != "usemtl") {
            scanner_.throw_bad_file(in_quotes(words[0]) +
                                    " is not a statement of such a file; write it again with pcvt");
        }
    }

    void parse_comment(std::string_view key, Words values) {
        if (key == "kind") {
            const bool is_boundary = values.size() == 1 && values[0] == "boundary";
            list_.form = is_boundary ? SurfaceForm::kBoundary : SurfaceForm::kCells;
        } else if (key == "lattice") {
            const std::array<double, 9> n = numbers<9>(values);
            try {
                list_.lattice = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
            } catch (const InvalidInput& fault) {
                scanner_.throw_bad_file(fault.what());
            }
            has_lattice_ = true;
        } else if (key == "site") {
            const std::array<double, 3> site = numbers<3>(values);
            sites_.insert(sites_.end(), site.begin(), site.end());
        } else if (key == "cells") {
            for (const std::string_view word : values) {
                list_.cell.push_back(scanner_.integer(word));
            }
        } else if (key == "face_pair" && values.size() == 5) {
            pairs_.push_back(
                {index(values[0]),
                 index(values[1]),
                 {period_count(values[2]), period_count(values[3]), period_count(values[4])}});
        } else {
            scanner_.throw_bad_file("pcvt does not know this " + in_quotes(key) +
                                    "; write the file again with pcvt");
        }
    }

    template <std::size_t kCount>
    std::array<double, kCount> numbers(Words words) const {
        if (words.size() != kCount) {
            scanner_.throw_bad_file("the line has not " + std::to_string(kCount) +
                                    " numbers; write the file again with pcvt");
        }
        std::array<double, kCount> values{};
        for (std::size_t k = 0; k < kCount; ++k) values[k] = scanner_.number(words[k]);
        return values;
    }

    /// The index from 0 of an index from 1.
    int index(std::string_view word) const {
        const int number = scanner_.integer(word);
        if (number < 1) scanner_.throw_bad_file(in_quotes(word) + " is no index; count from 1");
        return number - 1;
    }

    int period_count(std::string_view word) const {
        const int number = scanner_.integer(word);
        if (number < -kLargestOffset || number > kLargestOffset) {
            scanner_.throw_bad_file("the offset is beyond 2^28; write the file again with pcvt");
        }
        return number;
    }

    void link_pairs() {
        const int n = list_.faces.n_faces();
        list_.partner.assign(static_cast<std::size_t>(n), -1);
        list_.offset.resize(static_cast<std::size_t>(n));
        if (static_cast<int>(list_.cell.size()) != n) {
            scanner_.throw_bad_file("the cells are not as many as the faces; give the whole file");
        }
        for (const auto& [f, g, offset] : pairs_) {
            if (f >= n || g >= n) {
                scanner_.throw_bad_file("a face_pair names a face beyond the last one, " +
                                        std::to_string(n) + "; give the whole file");
            }
            list_.partner[f] = g;
            list_.partner[g] = f;
            list_.offset[f] = offset;
            list_.offset[g] = -offset;
        }
    }

    struct Pair {
        int f;
        int g;
        space::Offset offset;
    };

    LineScanner scanner_;
    SurfaceList list_;
    bool has_lattice_ = false;
    int n_groups_ = 0;
    std::vector<double> sites_;
    std::vector<Pair> pairs_;
};

}  // namespace

bool is_surface_obj(const EncodedFile& file) {
    const std::string_view head = std::string_view(file.bytes).substr(0, kObjHeadBytes);
    return head.find(kObjCellsMark) != std::string_view::npos ||
           head.find(kObjBoundaryMark) != std::string_view::npos;
}

SurfaceList decode_surface_obj(const EncodedFile& obj) {
    refuse_binary(obj.path, obj.bytes, "give a Wavefront OBJ");
    return SurfaceObjParser(obj).parse();
}

}  // namespace pcvt
