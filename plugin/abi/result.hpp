#pragma once

#include <array>

#include "plugin/abi/computed_job.hpp"
#include "plugin/abi/lazy.hpp"
#include "plugin/job/plane_world.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// A tile and the arrays that its view borrows.
struct TileArrays {
    /// One.
    PlaneWorld::Tiles built;
    std::vector<int> orbit;
    std::vector<plane::Offset> offset;
    std::vector<pcvt_edge_pair> edge_pairs;
    std::vector<pcvt_wall_edge> wall_edges;
};

/// Inclusions as the arrays that their view borrows.
struct InclusionArrays {
    std::vector<double> numbers;
    std::vector<int> begin{0};
    std::vector<int> form;
    /// Names within the tessellation.
    std::vector<const char*> tags;
};

/// A computed job, and views of it that are valid as long as it lives. Any number of threads may
/// call it at once.
class Result : public ComputedJob<PlaneWorld> {
   public:
    Result(Job job, Computation<PlaneWorld> computed);

    double energy_bound() const;
    pcvt_sites sites() const;
    pcvt_inclusions inclusions() const;
    pcvt_statistics statistics() const;
    /// @throws BadGeometry if cells are too small, as tile() and write().
    pcvt_mesh mesh(plane::MeshKind kind) const;
    /// @throws InvalidInput for Delaunay triangles in a box.
    pcvt_tile tile(const Layout& layout) const;
    /// @returns false if the callback cancelled.
    /// @throws InvalidInput, OutputError as run_job does.
    bool write(const WriteRequest& request, const JobCallback& callback) const;

   private:
    const plane::PeriodicMesh& periodic(plane::MeshKind kind) const;
    const TileArrays& arrays(const Layout& layout, JobMonitor& monitor) const;

    plane::Points sites_;
    std::vector<const char*> hole_names_;
    InclusionArrays inclusions_;
    /// By the number of the kind, and of the outline.
    std::array<Lazy<plane::PeriodicMesh>, plane::kMeshKinds.size()> meshes_;
    std::array<std::array<Lazy<TileArrays>, 2>, plane::kMeshKinds.size()> tiles_;
};

}  // namespace pcvt::abi
