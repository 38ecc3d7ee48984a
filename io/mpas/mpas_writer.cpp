#include "io/mpas/mpas_writer.hpp"

#include <cstdlib>
#include <map>
#include <numeric>

#include "io/bytes/openmesh_netcdf_mutex.hpp"
#include "io/bytes/output.hpp"
#include "io/mpas/mpas_format.hpp"
#include "io/mpas/netcdf_functions.hpp"
#include "io/mpas/netcdf_module.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The format counts the bytes of a variable in 32 bits.
constexpr double kMostBytes = 0x1p32 - 4;
/// The initial size of a file in memory. Unused bytes of it would stay in the file, so it is 0.
constexpr std::size_t kFirstBytes = 0;

const NetcdfFunctions& netcdf() {
    const NetcdfModule& loaded = netcdf_module();
    if (loaded.functions == nullptr) throw OutputError(loaded.problem);
    return *loaded.functions;
}

void require(int status) {
    if (status != NC_NOERR)
        throw InternalError(std::string("netCDF: ") + netcdf().strerror(status));
}

/// A netCDF file that is written to memory.
class MemoryFile {
   public:
    MemoryFile() {
        require(netcdf().create_mem("mesh.nc", NC_64BIT_OFFSET, kFirstBytes, &id_));
        require(netcdf().set_fill(id_, NC_NOFILL, nullptr));
    }
    ~MemoryFile() {
        if (open_) netcdf().abort(id_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int id() const { return id_; }
    std::string close() {
        NC_memio memory{};
        open_ = false;
        require(netcdf().close_memio(id_, &memory));
        std::string bytes(static_cast<const char*>(memory.memory), memory.size);
        std::free(memory.memory);
        return bytes;
    }

   private:
    int id_ = 0;
    bool open_ = true;
};

/// Writes an MPAS mesh file: the constructor defines the dimensions; attributes and variables
/// follow, and after begin_filling() the values of the variables.
class MpasFile {
   public:
    explicit MpasFile(const MpasGrid& grid) : grid_(grid) {
        for (const MpasDimension& dimension : mpas_dimensions()) {
            const int size = mpas_size(grid, dimension.size);
            require(
                netcdf().def_dim(file_.id(), dimension.name, size, &dimension_[dimension.size]));
        }
        int time = 0;
        require(netcdf().def_dim(file_.id(), "Time", NC_UNLIMITED, &time));
    }

    void state(const char* name, const std::string& text) {
        require(netcdf().put_att_text(file_.id(), NC_GLOBAL, name, text.size(), text.data()));
    }
    void state(const char* name, double number) {
        require(netcdf().put_att_double(file_.id(), NC_GLOBAL, name, NC_DOUBLE, 1, &number));
    }
    /// @returns the number of the new variable, of NC_INT or NC_DOUBLE.
    int define(const std::string& name, nc_type type, MpasSize rows, MpasSize columns) {
        const double entries = double(mpas_size(grid_, rows)) * mpas_size(grid_, columns);
        if (entries * (type == NC_DOUBLE ? 8 : 4) > kMostBytes) {
            throw LimitExceeded("an MPAS file cannot hold " + name + " of so many cells; take " +
                                "fewer");
        }
        const int n_dimensions = columns == MpasSize::kOne ? 1 : 2;
        const int dimensions[] = {dimension_[rows], dimension_[columns]};
        int number = 0;
        require(
            netcdf().def_var(file_.id(), name.c_str(), type, n_dimensions, dimensions, &number));
        return number;
    }
    void begin_filling() { require(netcdf().enddef(file_.id())); }
    void fill(int variable, const std::vector<int>& values) {
        require(netcdf().put_var_int(file_.id(), variable, values.data()));
    }
    void fill(int variable, const std::vector<double>& values) {
        require(netcdf().put_var_double(file_.id(), variable, values.data()));
    }
    std::string close() { return file_.close(); }

   private:
    const MpasGrid& grid_;
    MemoryFile file_;
    std::map<MpasSize, int> dimension_;
};

std::vector<int> counted_from_one(std::vector<int> indices) {
    for (int& index : indices) ++index;
    return indices;
}

void state_attributes(const MpasGrid& grid, MpasFile& file) {
    file.state("on_a_sphere", "NO");
    file.state("sphere_radius", 0.0);
    file.state("is_periodic", "YES");
    file.state("x_period", grid.x_period);
    file.state("y_period", grid.y_period);
    file.state("mesh_spec", "1.0");
}

/// The variables with equal values in all meshes of one size: the third dimension and the ids.
struct PlainVariables {
    MpasSize rows;
    std::vector<int> zeros;
    int ids;
};

PlainVariables define_plain(const std::string& word, MpasSize rows, MpasFile& file) {
    PlainVariables plain{rows, {}, 0};
    for (const char* axis : {"lat", "lon", "z"}) {
        plain.zeros.push_back(file.define(axis + word, NC_DOUBLE, rows, MpasSize::kOne));
    }
    plain.ids = file.define("indexTo" + word + "ID", NC_INT, rows, MpasSize::kOne);
    return plain;
}

void fill_plain(const PlainVariables& plain, const MpasGrid& grid, MpasFile& file) {
    const auto n = static_cast<std::size_t>(mpas_size(grid, plain.rows));
    for (const int variable : plain.zeros) file.fill(variable, std::vector<double>(n, 0));
    std::vector<int> ids(n);
    std::iota(ids.begin(), ids.end(), 1);
    file.fill(plain.ids, ids);
}

}  // namespace

void require_mpas_writer() { netcdf(); }

std::string encode_mpas(const MpasGrid& grid) {
    const std::lock_guard lock(openmesh_netcdf_mutex());
    MpasFile file(grid);
    // Define attributes and variables.
    state_attributes(grid, file);
    std::vector<int> numbers;
    for (const MpasVariable& variable : mpas_variables()) {
        const nc_type type = variable.numbers != nullptr ? NC_DOUBLE : NC_INT;
        numbers.push_back(file.define(variable.name, type, variable.rows, variable.columns));
    }
    const PlainVariables plain[] = {define_plain("Cell", MpasSize::kCells, file),
                                    define_plain("Edge", MpasSize::kEdges, file),
                                    define_plain("Vertex", MpasSize::kVertices, file)};
    // Fill the variables.
    file.begin_filling();
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const MpasVariable& variable = mpas_variables()[k];
        if (variable.indices != nullptr) {
            file.fill(numbers[k], counted_from_one(grid.*variable.indices));
        } else if (variable.counts != nullptr) {
            file.fill(numbers[k], grid.*variable.counts);
        } else {
            file.fill(numbers[k], grid.*variable.numbers);
        }
    }
    for (const PlainVariables& variables : plain) fill_plain(variables, grid, file);
    return file.close();
}

}  // namespace pcvt
