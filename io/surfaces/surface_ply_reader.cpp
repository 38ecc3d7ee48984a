#include "io/surfaces/surface_ply_reader.hpp"

#include <span>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/tiles/tile_file.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kPlyCellsMark = "\ncomment pcvt kind polyhedra\n";
constexpr std::string_view kPlyBoundaryMark = "\ncomment pcvt kind boundary\n";
/// The mark follows the first comment.
constexpr std::size_t kPlyHeadBytes = 1024;
/// Words of a face after its corners: a colour and a cell, and of a boundary a partner and an
/// offset.
constexpr std::size_t kCellWords = 4;
constexpr std::size_t kBoundaryWords = 8;

/// Reads one PLY line by line.
class SurfacePlyParser {
   public:
    explicit SurfacePlyParser(const EncodedFile& ply) : scanner_(ply.path, ply.bytes) {}

    SurfaceList parse() {
        read_header();
        for (int v = 0; v < n_points_; ++v) {
            next_row(3);
            list_.points.emplace_back(number(0), number(1), number(2));
        }
        for (int f = 0; f < n_faces_; ++f) {
            checkpoint_each(f);
            read_face();
        }
        std::vector<double> sites;
        for (int s = 0; s < n_sites_; ++s) {
            next_row(3);
            for (std::size_t k = 0; k < 3; ++k) sites.push_back(number(k));
        }
        list_.sites =
            Eigen::Map<const space::Points>(sites.data(), 3, static_cast<Eigen::Index>(n_sites_));
        return std::move(list_);
    }

   private:
    std::span<const std::string_view> words() const { return scanner_.words(); }
    double number(std::size_t k) const { return scanner_.number(words()[k]); }

    void read_header() {
        bool has_lattice = false;
        while (scanner_.next()) {
            const auto line = words();
            if (line.empty()) continue;
            if (line[0] == "end_header") {
                if (!has_lattice) {
                    scanner_.throw_bad_file("the lattice is missing; give the whole file");
                }
                return;
            }
            if (line.size() == 4 && line[1] == "pcvt" && line[3] == "boundary") {
                list_.form = SurfaceForm::kBoundary;
            }
            if (line.size() == 12 && line[2] == "lattice") {
                read_lattice();
                has_lattice = true;
            }
            if (line.size() == 3 && line[0] == "element") count_of(line[1]) = count(line[2]);
        }
        scanner_.throw_bad_file("the header does not end; give the whole file");
    }

    void read_lattice() {
        const auto vector = [&](std::size_t k) {
            return space::Vec3(number(k), number(k + 1), number(k + 2));
        };
        try {
            list_.lattice = {vector(3), vector(6), vector(9)};
        } catch (const InvalidInput& fault) {
            scanner_.throw_bad_file(fault.what());
        }
    }

    int& count_of(std::string_view element) {
        if (element == "vertex") return n_points_;
        if (element == "face") return n_faces_;
        if (element == "site") return n_sites_;
        scanner_.throw_bad_file(in_quotes(element) +
                                " is not an element of such a file; write it again with pcvt");
    }

    int count(std::string_view word) const {
        const int value = scanner_.integer(word);
        if (value < 0) scanner_.throw_bad_file("a count is negative; give the whole file");
        return value;
    }

    void next_row(std::size_t n_words) {
        if (!scanner_.next()) {
            scanner_.throw_bad_file("the file ends before its last element; give the whole file");
        }
        if (words().size() == n_words) return;
        scanner_.throw_bad_file("the line has not " + std::to_string(n_words) +
                                " words; write the file again with pcvt");
    }

    void read_face() {
        const bool is_boundary = list_.form == SurfaceForm::kBoundary;
        const std::size_t after = is_boundary ? kBoundaryWords : kCellWords;
        if (!scanner_.next() || words().size() <= after ||
            scanner_.integer(words()[0]) != static_cast<int>(words().size() - after) - 1) {
            scanner_.throw_bad_file(
                "is not a face: the number of its corners, these, and its properties; give the "
                "whole file");
        }
        const auto line = words();
        const std::size_t end = line.size() - after;
        for (std::size_t k = 1; k < end; ++k) {
            list_.faces.corners.push_back(scanner_.integer(line[k]));
        }
        list_.faces.close();
        const auto property = [&](std::size_t k) { return scanner_.integer(line[end + k]); };
        list_.cell.push_back(property(3));
        if (!is_boundary) return;
        list_.partner.push_back(property(4));
        const space::Offset offset{property(5), property(6), property(7)};
        for (const int n : {offset.i, offset.j, offset.k}) {
            if (n < -kLargestOffset || n > kLargestOffset) {
                scanner_.throw_bad_file("an offset is beyond 2^28; write the file again with pcvt");
            }
        }
        list_.offset.push_back(offset);
    }

    LineScanner scanner_;
    SurfaceList list_;
    int n_points_ = 0;
    int n_faces_ = 0;
    int n_sites_ = 0;
};

}  // namespace

bool is_surface_ply(const EncodedFile& file) {
    const std::string_view head = std::string_view(file.bytes).substr(0, kPlyHeadBytes);
    return head.starts_with("ply") && (head.find(kPlyCellsMark) != std::string_view::npos ||
                                       head.find(kPlyBoundaryMark) != std::string_view::npos);
}

SurfaceList decode_surface_ply(const EncodedFile& ply) {
    refuse_binary(ply.path, ply.bytes, "give an ASCII PLY");
    return SurfacePlyParser(ply).parse();
}

}  // namespace pcvt
