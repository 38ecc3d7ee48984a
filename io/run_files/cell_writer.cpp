#include "io/run_files/cell_writer.hpp"

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr const char* kVoronoiCells = "# The Voronoi cells";
constexpr const char* kPowerCells = "# The power cells (Laguerre cells)";
constexpr const char* kHead =
    " of one period, written by pcvt; lengths in the unit of the period vectors\n"
    "# diameter = 2 sqrt(area / pi); circularity = 2 sqrt(pi area) / perimeter\n"
    "# sides, neighbours: edges longer than 1e-5 sqrt(mean area), counter-clockwise\n"
    "# weight: length squared; phi1, Phi, phi2: Bunge's angles in degrees\n";

}  // namespace

std::string encode_cells(const CellRows& rows) {
    const CellTable& cells = rows.cells;
    const CellMaterials& materials = rows.materials;
    const bool have_weights = rows.weights.size() > 0;
    std::string text = have_weights ? kPowerCells : kVoronoiCells;
    text += std::string(kHead) + kCellHeader + '\n';
    const auto append = [&text](auto number, const char* separator = ",") {
        append_number(text, number);
        text += separator;
    };
    for (SiteId s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        append(s);
        append(rows.sites(0, s));
        append(rows.sites(1, s));
        if (have_weights) append_number(text, rows.weights[s]);
        text += ',';
        append(cells.measure[s]);
        append(cells.equivalent_diameter(s));
        append(cells.sides[s]);
        append(cells.circularity(s));
        const std::string phase = materials.phase_of(s);
        text += phase + ',' + (rows.phases_are_tags ? phase : "") + ',';
        if (materials.site_orientation.empty()) {
            text += ",,,";
        } else {
            const BungeAngles& angles = materials.site_orientation[s];
            append(angles.phi1);
            append(angles.Phi);
            append(angles.phi2);
        }
        if (!rows.orbits.empty()) append_number(text, rows.orbits[s]);
        text += ',';
        for (int k = cells.neighbour_begin[s]; k < cells.neighbour_begin[s + 1]; ++k) {
            append(cells.neighbours[k], k + 1 < cells.neighbour_begin[s + 1] ? " " : "");
        }
        text += '\n';
    }
    return text;
}

}  // namespace pcvt
