#include "io/mpas/mpas_reader.hpp"

#include <algorithm>
#include <limits>

#include "io/mpas/mpas_format.hpp"
#include "io/mpas/netcdf_file.hpp"

namespace pcvt {
namespace {

/// Returns a dimension, which in a complete file is at most as long as the file.
int dimension(const NetcdfFile& file, const std::string& name, std::size_t n_bytes) {
    const std::size_t length = file.dimension(name);
    if (length == 0 || length > n_bytes || length > std::size_t(std::numeric_limits<int>::max())) {
        file.throw_bad_file("dimension " + name + " has the size " + std::to_string(length) +
                            "; give the whole file");
    }
    return static_cast<int>(length);
}

std::vector<std::size_t> sizes(const MpasVariable& variable, const MpasGrid& grid) {
    return {static_cast<std::size_t>(mpas_size(grid, variable.rows)),
            static_cast<std::size_t>(mpas_size(grid, variable.columns))};
}

void require_text(const NetcdfFile& file, const std::string& name, const std::string& value) {
    if (file.text(name) == value) return;
    file.throw_bad_file("attribute " + name + " is not " + value +
                        "; give the mesh of a torus in the plane");
}

/// Requires that ids count from 1, as the indices do, and that latitudes, longitudes and heights
/// are 0.
void require_plain(const NetcdfFile& file, const MpasPlain& plain, int n) {
    const std::vector<std::size_t> size{static_cast<std::size_t>(n)};
    if (!plain.is_id) {
        const std::vector<double> values = file.numbers(plain.name, size);
        if (std::all_of(values.begin(), values.end(), [](double x) { return x == 0; })) return;
        file.throw_bad_file(plain.name + " is not 0; give the mesh of a torus in the plane");
    }
    const std::vector<int> ids = file.integers(plain.name, size);
    for (int k = 0; k < n; ++k) {
        if (ids[k] == k + 1) continue;
        file.throw_bad_file(plain.name +
                            " does not count from 1; give the whole file, or renumber it");
    }
}

/// Requires that a variable of a file that pcvt wrote has the attributes that pcvt gives it.
void require_words(const NetcdfFile& file, const std::string& name, const std::string& units,
                   const std::string& long_name) {
    if (file.text_of(name, "units") == units && file.text_of(name, "long_name") == long_name) {
        return;
    }
    file.throw_bad_file(name + " has not the units " + units + " and the long_name \"" + long_name +
                        "\"; write the file again with pcvt");
}

void require_own_words(const NetcdfFile& file, const MpasGrid& grid) {
    if (!file.has_attribute("history")) return;
    if (!file.text("history").starts_with(kMpasOwnHistory)) return;
    for (const MpasVariable& variable : mpas_variables()) {
        if (is_coriolis(variable) && !grid.coriolis) continue;
        require_words(file, variable.name, variable.units, variable.long_name);
    }
    for (const MpasPlain& plain : mpas_plain_variables()) {
        require_words(file, plain.name, plain.units, plain.long_name);
    }
}

}  // namespace

MpasGrid decode_mpas(const std::string& path, const std::string& bytes) {
    const NetcdfFile file(path, bytes);
    // Periods and dimensions.
    MpasGrid grid{};
    for (const auto& [name, value] : kMpasPlane) require_text(file, name, value);
    if (file.attribute(kMpasSphereRadius) != 0) {
        file.throw_bad_file("sphere_radius is not 0; give the mesh of a torus in the plane");
    }
    if (file.has_attribute(kMpasMeanDensity)) {
        grid.stated_mean_density = file.attribute(kMpasMeanDensity);
    }
    if (file.has_attribute(kMpasCoriolis[0])) {
        grid.coriolis = {file.attribute(kMpasCoriolis[0]), file.attribute(kMpasCoriolis[1])};
    }
    grid.x_period = file.attribute("x_period");
    grid.y_period = file.attribute("y_period");
    grid.n_cells = dimension(file, "nCells", bytes.size());
    grid.n_edges = dimension(file, "nEdges", bytes.size());
    grid.n_vertices = dimension(file, "nVertices", bytes.size());
    grid.max_edges = dimension(file, "maxEdges", bytes.size());
    if (grid.max_edges > std::numeric_limits<int>::max() / 2)
        file.throw_bad_file("maxEdges is too large");
    for (const MpasDimension& row : mpas_dimensions()) {
        const int size = mpas_size(grid, row.size);
        if (file.dimension(row.name) == static_cast<std::size_t>(size)) continue;
        file.throw_bad_file("dimension " + std::string(row.name) + " is not " +
                            std::to_string(size) + "; give the whole file");
    }
    // Variables, with indices counted from 0 and -1 for unused entries.
    for (const MpasVariable& variable : mpas_variables()) {
        if (is_coriolis(variable) && !grid.coriolis) continue;
        if (variable.indices != nullptr) {
            grid.*variable.indices = file.integers(variable.name, sizes(variable, grid));
            for (int& index : grid.*variable.indices) index = index > 0 ? index - 1 : -1;
        } else if (variable.counts != nullptr) {
            grid.*variable.counts = file.integers(variable.name, sizes(variable, grid));
        } else {
            grid.*variable.numbers = file.numbers(variable.name, sizes(variable, grid));
        }
    }
    for (const MpasPlain& plain : mpas_plain_variables()) {
        require_plain(file, plain, mpas_size(grid, plain.rows));
    }
    require_own_words(file, grid);
    return grid;
}

}  // namespace pcvt
