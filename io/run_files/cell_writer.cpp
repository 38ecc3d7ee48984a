#include "io/run_files/cell_writer.hpp"

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr const char* kVoronoiCells = "# The Voronoi cells";
constexpr const char* kPowerCells = "# The power cells (Laguerre cells)";
constexpr const char* kPlaneHead =
    " of one period, written by pcvt; lengths in the unit of the period vectors\n"
    "# diameter = 2 sqrt(area / pi); circularity = 2 sqrt(pi area) / perimeter\n"
    "# sides, neighbours: edges longer than 1e-5 sqrt(mean area), counter-clockwise\n"
    "# weight: length squared; phi1, Phi, phi2: Bunge's angles in degrees\n";

constexpr const char* kSpaceHead =
    " of one period, written by pcvt; lengths in the unit of the period vectors\n"
    "# diameter = (6 volume / pi)^(1/3); sphericity = pi^(1/3) (6 volume)^(2/3) / surface\n"
    "# neighbours: the sites across the faces, in rising order\n"
    "# weight: length squared; phi1, Phi, phi2: Bunge's angles in degrees\n";

/// Appends the fields of a row, each behind a comma but the first.
class FieldWriter {
   public:
    explicit FieldWriter(std::string& text) : text_(text) {}

    void number(auto value) {
        separate();
        append_number(text_, value);
    }
    void text(const std::string& word) {
        separate();
        text_ += word;
    }
    void list(const int* begin, const int* end) {
        separate();
        for (const int* entry = begin; entry != end; ++entry) {
            if (entry != begin) text_ += ' ';
            append_number(text_, *entry);
        }
    }

   private:
    void separate() {
        if (!is_first_) text_ += ',';
        is_first_ = false;
    }

    std::string& text_;
    bool is_first_ = true;
};

}  // namespace

std::string encode_cells(const CellRows& rows) {
    const int dimension = rows.cells.dimension;
    std::string text = rows.weights.size() > 0 ? kPowerCells : kVoronoiCells;
    text += std::string(dimension == 3 ? kSpaceHead : kPlaneHead) + cell_header(dimension) + '\n';
    for (SiteId s = 0; s < rows.cells.n_cells(); ++s) {
        checkpoint_each(s);
        FieldWriter fields(text);
        for_each_field(rows, s, fields);
        text += '\n';
    }
    return text;
}

}  // namespace pcvt
