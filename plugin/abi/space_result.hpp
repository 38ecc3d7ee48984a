#pragma once

#include <string>
#include <vector>

#include "plugin/abi/lazy.hpp"
#include "plugin/job/space_job.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// The arrays of pcvt_cells that a tile does not have in this form.
struct CellArrays {
    std::vector<int> neighbour;
    /// Of each boundary face.
    std::vector<int> partner;
    std::vector<space::Offset> partner_offset;
    /// Of each cell, length^3.
    std::vector<double> volumes;
    /// 3 x n, in the domain, length units.
    space::Points sites;
};

/// A call of pcvt_write() in three dimensions.
struct SpaceWriteRequest {
    /// Empty: none, like `report`.
    std::string path = {};
    std::string report = {};
    SpaceFileOptions files = {};
    bool replace = false;
};

/// A computed job in three dimensions, and views of it that are valid as long as it lives. Any
/// number of threads may call it at once.
class SpaceResult {
   public:
    SpaceResult(Job job, SpaceComputation computed);

    double energy_bound() const;
    pcvt_cells cells() const;
    pcvt_statistics statistics() const;
    std::int32_t minimum() const;
    /// @returns false if the callback cancelled.
    /// @throws BadGeometry if the file holds tetrahedra and some are flat, or a boundary that
    ///         touches itself; InvalidInput, OutputError as run_space_job does.
    bool write(const SpaceWriteRequest& request, const JobCallback& callback) const;

   private:
    const ProvedSpaceTile& tile(JobMonitor& monitor) const;
    const ProvedSpaceTile& tile() const;
    const CellArrays& arrays() const;

    Job job_;
    SpaceComputation computed_;
    Lazy<ProvedSpaceTile> tile_;
    Lazy<CellArrays> arrays_;
    Lazy<std::vector<int>> valences_;
    Lazy<std::int32_t> minimum_;
};

}  // namespace pcvt::abi
