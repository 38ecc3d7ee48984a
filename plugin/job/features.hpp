#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/formats/formats.hpp"

namespace pcvt {

struct Job;

/// The options that some jobs cannot have, in the order of kFeatures: those of one dimension, those
/// that contradict others, and those that only some formats hold. Some are a value of an option.
enum class Feature : std::uint8_t {
    kRetry,
    kGivenSites,
    kPlaneLattice,
    kObliqueLattice,
    kSpaceLattice,
    kSymmetry,
    kOrigin,
    kFoundOrigin,
    kSpaceOrigin,
    kOriginOffWalls,
    kDensity,
    kDensityRange,
    kAreas,
    kVolumes,
    kWeights,
    kCentroids,
    kAspect,
    kPlaneAspect,
    kSpaceAspect,
    kHasWalls,
    kHalfCells,
    kFixed,
    kInclusions,
    kFibres,
    kHoles,
    kStartNotRandom,
    kStartAtLattice,
    kStartWithEqualCells,
    kBudget,
    kSolver,
    kNoIterations,
    kStability,
    kPhases,
    kOrientations,
    kMaterials,
    kDelaunay,
    kOutline,
    kGrainSize,
    kGrainPerEdge,
    kOrder,
    kRepeat,
    kRepeatLayers,
    kRepeatAcrossWalls,
    kShortEdgesInSpace,
    kTable,
    kColour,
    kColourByDensity,
    kColourByPhase,
    kColourByOrbit,
    kColourByTag,
    kColourByOrientation,
    kColourOfSpace,
    kBackground,
    kGlbNodes,
    kSinglePrecision,
    kPixels,
    kVoxels,
    kCoriolis,
    kCut,
    kElement,
    kSolverJob,
    kThickness,
    kSurface,
};

/// A feature as the command, pcvt.h, checks of jobs and messages about files know it.
///
/// Example usage:
///   const FeatureRow* row = find_option("--walls");
///   if (!row->in_space) refuse(row->option);
struct FeatureRow {
    Feature feature;
    /// "--walls"; empty for a value of an option, and for what no option states.
    std::string_view option = {};
    /// The fields of pcvt.h, with blanks between them.
    std::string_view fields = {};
    bool in_plane = true;
    bool in_space = false;
    /// Whether a job in the plane has it; null where nothing depends on that.
    bool (*is_chosen)(const Job& job) = nullptr;
    /// Its name in the message that no output takes it; null where no file in the plane holds it.
    const char* in_files = nullptr;
    /// Whether a format holds it, in the plane or in space; null for no part of files.
    bool (*taken)(const Format& format, bool in_space) = nullptr;
    /// Whether the files of a format that takes it hold it with these options; null: always.
    bool (*held)(const Format& format, const FileOptions& options) = nullptr;
    /// The choice by which such files hold it, for the message that none does.
    const char* held_by = nullptr;
};

/// In the order of the enumerators.
std::span<const FeatureRow> features();

/// The row of an option of the command, nullptr for one that every job can have.
const FeatureRow* find_option(std::string_view option);
/// The rows of a table of choices (mesher/base/choices.hpp) that jobs in space can have.
template <class Table>
auto rows_in_space(const Table& table) {
    std::vector<std::decay_t<decltype(*std::begin(table))>> rows;
    for (const auto& row : table) {
        if (row.in_space) rows.push_back(row);
    }
    return rows;
}

}  // namespace pcvt
