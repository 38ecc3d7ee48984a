#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/base/site_id.hpp"

namespace pcvt {

/// The treatment of given sites that coincide with earlier ones.
enum class Duplicates { kRefuse, kDrop };

/// Rows of a table of choices (choices.hpp), with the numbers of pcvt.h.
struct DuplicatesRow {
    Duplicates duplicates;
    const char* word;
    int abi_value;
};
inline constexpr std::array kDuplicates{DuplicatesRow{Duplicates::kRefuse, "refuse", 0},
                                        DuplicatesRow{Duplicates::kDrop, "drop", 1}};

/// Sites nearer to each other than this part of h, the mean spacing, coincide.
inline constexpr double kCoincident = 1e-9;

/// Returns the sites that are nearer than a distance to an earlier site which is not in the result
/// itself, modulo the lattice, sorted by site; `earlier` is the first such site. Takes time of
/// order n log n, also where many sites coincide.
///
/// Example usage:
///
///     const auto pairs = coincident_sites(sites.coordinates(), periods, kCoincident * h);
///     if (!pairs.empty()) throw DuplicateSites(pairs);
///
/// @param coordinates  2 x n or 3 x n, in [0, 1), coordinates of the basis `periods`.
/// @param periods      the reduced period vectors as columns, length units.
/// @param distance     length units; much shorter than the periods.
std::vector<CoincidentSite> coincident_sites(const Eigen::Matrix2Xd& coordinates,
                                             const Eigen::Matrix2d& periods, double distance);
std::vector<CoincidentSite> coincident_sites(const Eigen::Matrix3Xd& coordinates,
                                             const Eigen::Matrix3d& periods, double distance);

/// Returns the sites to leave out so that no two are left within kCoincident h of each other, where
/// h grows as sites are left out.
/// @param h  the mean spacing of all sites, length units.
std::vector<CoincidentSite> sites_to_drop(const Eigen::Matrix2Xd& coordinates,
                                          const Eigen::Matrix2d& periods, double h);
std::vector<CoincidentSite> sites_to_drop(const Eigen::Matrix3Xd& coordinates,
                                          const Eigen::Matrix3d& periods, double h);

/// The sites that a job leaves out, by their numbers before, and by their lines in a file.
struct DroppedSites {
    std::vector<CoincidentSite> sites = {};
    /// Empty without a file.
    std::vector<CoincidentSite> lines = {};
};

/// @param line_of  the line of each site; empty without a file.
DroppedSites dropped_sites(std::vector<CoincidentSite> sites, const std::vector<int>& line_of);

/// Returns the sites 0 ... n - 1 that are not dropped.
std::vector<SiteId> kept_sites(int n, const std::vector<CoincidentSite>& dropped);

}  // namespace pcvt
