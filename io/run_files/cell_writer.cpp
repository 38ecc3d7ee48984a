#include "io/run_files/cell_writer.hpp"

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr const char* kHead =
    "# The Voronoi cells of one period, written by pcvt; lengths in the unit of the period "
    "vectors\n"
    "# diameter = 2 sqrt(area / pi); circularity = 2 sqrt(pi area) / perimeter\n"
    "# sides, neighbours: edges longer than 1e-5 sqrt(mean area), counter-clockwise\n"
    "site,x,y,weight,area,diameter,sides,circularity,phase,tag,phi1,Phi,phi2,neighbours\n";

}  // namespace

std::string encode_cells(const Points& sites, const CellTable& cells) {
    std::string text = kHead;
    const auto append = [&text](auto number, const char* separator) {
        append_number(text, number);
        text += separator;
    };
    for (SiteId s = 0; s < cells.n_cells(); ++s) {
        append(s, ",");
        append(sites(0, s), ",");
        // Voronoi cells have no weight.
        append(sites(1, s), ",,");
        append(cells.area[s], ",");
        append(cells.equivalent_diameter(s), ",");
        append(cells.n_sides(s), ",");
        // Neither phase nor tag nor orientation.
        append(cells.circularity(s), ",,,,,,");
        for (int k = cells.neighbour_begin[s]; k < cells.neighbour_begin[s + 1]; ++k) {
            append(cells.neighbours[k], k + 1 < cells.neighbour_begin[s + 1] ? " " : "");
        }
        text += '\n';
    }
    return text;
}

}  // namespace pcvt
