#pragma once

#include <vector>

#include "plugin/abi/computed_job.hpp"
#include "plugin/abi/lazy.hpp"
#include "plugin/job/space_world.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// The arrays of pcvt_cells that a tile does not have in this form.
struct CellArrays {
    std::vector<int> neighbour;
    /// The partner of each boundary face, and the offset to it.
    std::vector<int> partner;
    std::vector<space::Offset> partner_offset;
    /// The volume of each cell, length^3.
    std::vector<double> volumes;
    /// 3 x n, in the domain, length units.
    space::Points sites;
};

/// A computed job in three dimensions, and views of it that are valid as long as it lives. Any
/// number of threads may call it at once.
class SpaceResult : public ComputedJob<SpaceWorld> {
   public:
    SpaceResult(Job job, Computation<SpaceWorld> computed);

    double energy_bound() const;
    pcvt_cells cells() const;
    pcvt_statistics statistics() const;
    /// @returns false if the callback cancelled.
    /// @throws BadGeometry if the file holds tetrahedra and some are flat, or a boundary that
    ///         touches itself; InvalidInput, OutputError as run_job does.
    bool write(const WriteRequest& request, const JobCallback& callback) const;

   private:
    const ProvedSpaceTile& tile(JobMonitor& monitor) const;
    const ProvedSpaceTile& tile() const;
    const CellArrays& arrays() const;

    Lazy<ProvedSpaceTile> tile_;
    Lazy<CellArrays> arrays_;
};

}  // namespace pcvt::abi
