#include "io/mpas/mpas_writer.hpp"

#include <map>
#include <numeric>
#include <utility>

#include "io/bytes/output_error.hpp"
#include "io/mpas/mpas_format.hpp"
#include "io/mpas/netcdf_encoder.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The format counts the bytes of a variable in 32 bits.
constexpr double kMostBytes = 0x1p32 - 4;
/// Writes an MPAS mesh file: the constructor defines the dimensions; attributes and variables
/// follow, in the order in which they are in the file, and then the values of the variables.
class MpasFile {
   public:
    explicit MpasFile(const MpasGrid& grid) : grid_(grid) {
        for (const MpasDimension& dimension : mpas_dimensions()) {
            dimension_[dimension.size] = static_cast<std::uint32_t>(dimension_.size());
            encoder_.add_dimension(dimension.name,
                                   static_cast<std::uint32_t>(mpas_size(grid, dimension.size)));
        }
        // The unlimited dimension of model output, without a record.
        encoder_.add_dimension("Time", 0);
    }

    void state(const char* name, const std::string& text) { encoder_.add_attribute(name, text); }
    void state(const char* name, double number) { encoder_.add_attribute(name, number); }
    void define(const std::string& name, NetcdfType type, MpasSize rows, MpasSize columns,
                const std::vector<NetcdfEncoder::Attribute>& attributes) {
        const double entries = double(mpas_size(grid_, rows)) * mpas_size(grid_, columns);
        const std::uint32_t width = type == NetcdfType::kDouble ? 8 : 4;
        if (entries * width > kMostBytes) {
            throw LimitExceeded("an MPAS file cannot hold " + name + " of so many cells; take " +
                                "fewer");
        }
        std::vector<std::uint32_t> dimensions{dimension_[rows]};
        if (columns != MpasSize::kOne) dimensions.push_back(dimension_[columns]);
        encoder_.add_variable(name, type, dimensions, static_cast<std::uint64_t>(entries) * width,
                              attributes);
    }
    template <class Number>
    void fill(const std::vector<Number>& values) {
        encoder_.append(values);
    }
    std::string close() { return std::move(encoder_).bytes(); }

   private:
    const MpasGrid& grid_;
    NetcdfEncoder encoder_;
    std::map<MpasSize, std::uint32_t> dimension_;
};

std::vector<int> counted_from_one(std::vector<int> indices) {
    for (int& index : indices) ++index;
    return indices;
}

void state_attributes(const MpasGrid& grid, const std::string& history, MpasFile& file) {
    for (const auto& [name, value] : kMpasPlane) file.state(name, value);
    file.state(kMpasSphereRadius, 0.0);
    file.state("x_period", grid.x_period);
    file.state("y_period", grid.y_period);
    file.state(kMpasMeanDensity, mean_density(grid));
    if (grid.coriolis) {
        file.state(kMpasCoriolis[0], grid.coriolis->f);
        file.state(kMpasCoriolis[1], grid.coriolis->beta);
    }
    file.state("mesh_spec", "1.0");
    if (!history.empty()) file.state("history", history);
}

std::vector<NetcdfEncoder::Attribute> words_of(const char* units, std::string_view long_name) {
    return {{"units", units}, {"long_name", long_name}};
}

void fill_plain(const MpasPlain& plain, const MpasGrid& grid, MpasFile& file) {
    const auto n = static_cast<std::size_t>(mpas_size(grid, plain.rows));
    if (!plain.is_id) {
        file.fill(std::vector<double>(n, 0));
        return;
    }
    std::vector<int> ids(n);
    std::iota(ids.begin(), ids.end(), 1);
    file.fill(ids);
}

bool is_left_out(const MpasVariable& variable, const MpasGrid& grid) {
    return is_coriolis(variable) && !grid.coriolis;
}

}  // namespace

std::string encode_mpas(const MpasGrid& grid, const std::string& history) {
    MpasFile file(grid);
    // Define attributes and variables.
    state_attributes(grid, history, file);
    for (const MpasVariable& variable : mpas_variables()) {
        if (is_left_out(variable, grid)) continue;
        const bool is_real = variable.numbers != nullptr;
        file.define(variable.name, is_real ? NetcdfType::kDouble : NetcdfType::kInt, variable.rows,
                    variable.columns, words_of(variable.units, variable.long_name));
    }
    for (const MpasPlain& plain : mpas_plain_variables()) {
        file.define(plain.name, plain.is_id ? NetcdfType::kInt : NetcdfType::kDouble, plain.rows,
                    MpasSize::kOne, words_of(plain.units, plain.long_name));
    }
    // Append their values in the same order.
    for (const MpasVariable& variable : mpas_variables()) {
        if (is_left_out(variable, grid)) continue;
        if (variable.indices != nullptr) {
            file.fill(counted_from_one(grid.*variable.indices));
        } else if (variable.counts != nullptr) {
            file.fill(grid.*variable.counts);
        } else {
            file.fill(grid.*variable.numbers);
        }
    }
    for (const MpasPlain& plain : mpas_plain_variables()) fill_plain(plain, grid, file);
    return file.close();
}

}  // namespace pcvt
