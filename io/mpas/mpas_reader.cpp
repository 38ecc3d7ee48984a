#include "io/mpas/mpas_reader.hpp"

#include <limits>

#include "io/bytes/openmesh_netcdf_mutex.hpp"
#include "io/mpas/mpas_format.hpp"
#include "io/mpas/netcdf_functions.hpp"
#include "io/mpas/netcdf_module.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {
namespace {

/// A netCDF file in memory.
class MpasInput {
   public:
    MpasInput(const std::string& path, const std::string& bytes)
        : path_(path), bytes_(bytes), nc_(netcdf_module().functions) {
        if (nc_ == nullptr) throw_bad_file(netcdf_module().problem);
        if (bytes.size() < 4 || !bytes.starts_with("CDF")) {
            throw_bad_file(
                "not a netCDF file of the classic formats; convert it with nccopy -k nc6");
        }
        // The library takes a pointer to non-const memory, but NC_NOWRITE keeps it from writing.
        void* memory = const_cast<char*>(bytes.data());
        require(nc_->open_mem(path.c_str(), NC_NOWRITE, bytes.size(), memory, &id_), "the header");
    }
    ~MpasInput() { nc_->close(id_); }
    MpasInput(const MpasInput&) = delete;
    MpasInput& operator=(const MpasInput&) = delete;

    [[noreturn]] void throw_bad_file(const std::string& complaint) const {
        throw BadFile(path_ + ": " + complaint);
    }

    int dimension(const char* name) const {
        int number = 0;
        std::size_t length = 0;
        require(nc_->inq_dimid(id_, name, &number), name);
        require(nc_->inq_dimlen(id_, number, &length), name);
        // A dimension of a complete file is at most as long as the file.
        if (length == 0 || length > bytes_.size() ||
            length > std::size_t(std::numeric_limits<int>::max())) {
            throw_bad_file("dimension " + std::string(name) + " has the size " +
                           std::to_string(length) + "; give the whole file");
        }
        return static_cast<int>(length);
    }

    double attribute(const char* name) const {
        double value = 0;
        std::size_t length = 0;
        require(nc_->inq_attlen(id_, NC_GLOBAL, name, &length), name);
        if (length != 1) throw_bad_file("attribute " + std::string(name) + " is not one number");
        require(nc_->get_att_double(id_, NC_GLOBAL, name, &value), name);
        return value;
    }

    void read(const MpasVariable& variable, const MpasGrid& grid, std::vector<int>& values) const {
        values.resize(entries(variable, grid, sizeof(int)));
        require(nc_->get_var_int(id_, number(variable), values.data()), variable.name);
    }
    void read(const MpasVariable& variable, const MpasGrid& grid,
              std::vector<double>& values) const {
        values.resize(entries(variable, grid, sizeof(double)));
        require(nc_->get_var_double(id_, number(variable), values.data()), variable.name);
    }

    /// Requires that the ids count from 1, as the indices do.
    void require_ids(const std::string& name, int n) const {
        int variable = 0;
        int dimension = 0;
        int n_dimensions = 0;
        std::size_t length = 0;
        require(nc_->inq_varid(id_, name.c_str(), &variable), name);
        require(nc_->inq_varndims(id_, variable, &n_dimensions), name);
        if (n_dimensions == 1) {
            require(nc_->inq_vardimid(id_, variable, &dimension), name);
            require(nc_->inq_dimlen(id_, dimension, &length), name);
        }
        std::vector<int> ids(static_cast<std::size_t>(n));
        if (length == ids.size()) require(nc_->get_var_int(id_, variable, ids.data()), name);
        for (int k = 0; k < n; ++k) {
            if (ids[k] == k + 1) continue;
            throw_bad_file(name + " does not count from 1; give the whole file, or renumber it");
        }
    }

   private:
    void require(int status, const std::string& what) const {
        if (status == NC_NOERR) return;
        throw_bad_file(what + " cannot be read: " + nc_->strerror(status) +
                       "; give an MPAS mesh file");
    }

    int number(const MpasVariable& variable) const {
        int found = 0;
        require(nc_->inq_varid(id_, variable.name, &found), variable.name);
        return found;
    }

    /// Returns the number of entries of a variable, `size` bytes each, after checking that the file
    /// stores as many as `grid` requires.
    std::size_t entries(const MpasVariable& variable, const MpasGrid& grid,
                        std::size_t size) const {
        // The number of entries in the file.
        int n_dimensions = 0;
        int dimensions[NC_MAX_VAR_DIMS] = {};
        require(nc_->inq_var(id_, number(variable), nullptr, nullptr, &n_dimensions, dimensions,
                             nullptr),
                variable.name);
        std::size_t found = 1;
        for (int k = 0; k < n_dimensions; ++k) {
            std::size_t length = 0;
            require(nc_->inq_dimlen(id_, dimensions[k], &length), variable.name);
            found *= length;
        }
        // The required number, which must also fit into the file.
        const std::size_t wanted = static_cast<std::size_t>(mpas_size(grid, variable.rows)) *
                                   mpas_size(grid, variable.columns);
        if (n_dimensions > 2 || found != wanted || wanted > bytes_.size() / size) {
            throw_bad_file(std::string(variable.name) + " has " + std::to_string(found) +
                           " entries, not " + std::to_string(wanted) + "; give the whole file");
        }
        return wanted;
    }

    const std::string& path_;
    const std::string& bytes_;
    const NetcdfFunctions* nc_;
    int id_ = 0;
};

}  // namespace

MpasGrid decode_mpas(const std::string& path, const std::string& bytes) {
    const std::lock_guard lock(openmesh_netcdf_mutex());
    const MpasInput file(path, bytes);
    // Periods and dimensions.
    MpasGrid grid{};
    grid.x_period = file.attribute("x_period");
    grid.y_period = file.attribute("y_period");
    grid.n_cells = file.dimension("nCells");
    grid.n_edges = file.dimension("nEdges");
    grid.n_vertices = file.dimension("nVertices");
    grid.max_edges = file.dimension("maxEdges");
    if (grid.max_edges > std::numeric_limits<int>::max() / 2)
        file.throw_bad_file("maxEdges is too large");
    // Variables, with indices counted from 0 and -1 for unused entries.
    for (const MpasVariable& variable : mpas_variables()) {
        if (variable.indices != nullptr) {
            file.read(variable, grid, grid.*variable.indices);
            for (int& index : grid.*variable.indices) index = index > 0 ? index - 1 : -1;
        } else if (variable.counts != nullptr) {
            file.read(variable, grid, grid.*variable.counts);
        } else {
            file.read(variable, grid, grid.*variable.numbers);
        }
    }
    file.require_ids("indexToCellID", grid.n_cells);
    file.require_ids("indexToEdgeID", grid.n_edges);
    file.require_ids("indexToVertexID", grid.n_vertices);
    return grid;
}

}  // namespace pcvt
