#include "plugin/job/contradictions.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plugin/job/features.hpp"

namespace pcvt {
namespace {

using F = Feature;

/// A set of features.
class FeatureSet {
   public:
    constexpr FeatureSet() = default;
    template <class... Features>
    constexpr explicit FeatureSet(Features... features) : bits_((0 | ... | bit(features))) {}

    constexpr void add(Feature feature) { bits_ |= bit(feature); }
    constexpr bool is_empty() const { return bits_ == 0; }
    constexpr bool meets(FeatureSet other) const { return (bits_ & other.bits_) != 0; }

   private:
    static constexpr std::uint64_t bit(Feature feature) {
        return std::uint64_t{1} << static_cast<unsigned>(feature);
    }
    std::uint64_t bits_ = 0;
};

/// A contradiction: a job has a feature of `these` and one of `those`, if there are any, and none
/// of `unless`.
struct Contradiction {
    FeatureSet these;
    FeatureSet those;
    FeatureSet unless;
    const char* message;
};

constexpr FeatureSet kNone;
constexpr FeatureSet kWithFixedSites{F::kFixed, F::kInclusions, F::kFibres};
constexpr FeatureSet kWithInclusions{F::kInclusions, F::kFibres};

constexpr std::array kContradictions{
    Contradiction{FeatureSet{F::kDensity}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "--start lattice and best do not work with --density; take coarse or random"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kDensity}, kNone,
                  "--areas does not work with --density; leave one of them out"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "--start lattice and best do not work with --areas; take coarse or random"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kSolver}, kNone,
                  "--areas has a solver of its own; leave --solver out"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kStability}, kNone,
                  "--stability does not work with --areas; leave one of them out"},
    Contradiction{FeatureSet{F::kVolumes}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "--start lattice does not work with --volumes; take coarse or random"},
    Contradiction{FeatureSet{F::kVolumes}, FeatureSet{F::kSolver}, kNone,
                  "--volumes has a solver of its own; leave --solver out"},
    Contradiction{FeatureSet{F::kVolumes}, FeatureSet{F::kStability}, kNone,
                  "--stability does not work with --volumes; leave one of them out"},
    Contradiction{FeatureSet{F::kVolumes}, FeatureSet{F::kShortEdgesInSpace}, kNone,
                  "--short-edges does not work with --volumes; leave one of them out"},
    Contradiction{FeatureSet{F::kWeights}, FeatureSet{F::kVolumes}, kNone,
                  "--weights does not work with --volumes; leave one of them out"},
    Contradiction{FeatureSet{F::kWeights}, kNone, FeatureSet{F::kGivenSites},
                  "--weights needs given sites; add their positions, or leave it out"},
    Contradiction{FeatureSet{F::kWeights}, kNone, FeatureSet{F::kNoIterations},
                  "--weights keeps sites where they are; add --max-iterations 0, or leave the "
                  "weights out"},
    Contradiction{FeatureSet{F::kWeights}, FeatureSet{F::kAreas, F::kDensity, F::kStability}, kNone,
                  "--weights does not work with --areas, --density or --stability; leave one of "
                  "them out"},
    Contradiction{FeatureSet{F::kWeights}, FeatureSet{F::kShortEdgesInSpace}, kNone,
                  "--short-edges does not work with --weights in space; leave one of them out"},
    Contradiction{FeatureSet{F::kCentroids}, kNone, FeatureSet{F::kAreas, F::kVolumes},
                  "--centroids needs the sizes of the grains; add --areas, in space --volumes"},
    Contradiction{FeatureSet{F::kCentroids}, FeatureSet{F::kAspect, F::kHasWalls}, kNone,
                  "--centroids does not work with --aspect or --walls; leave one of them out"},
    Contradiction{FeatureSet{F::kAspect}, FeatureSet{F::kShortEdgesInSpace}, kNone,
                  "--short-edges does not work with --aspect in space; leave one of them out"},
    Contradiction{FeatureSet{F::kSymmetry}, FeatureSet{F::kGivenSites}, kNone,
                  "--symmetry draws its sites; leave the given sites out, or --symmetry"},
    Contradiction{FeatureSet{F::kSymmetry}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "--start lattice and best do not work with --symmetry; take coarse or random"},
    Contradiction{FeatureSet{F::kSymmetry}, FeatureSet{F::kAreas}, kNone,
                  "--symmetry does not work with --areas; leave one of them out"},
    Contradiction{FeatureSet{F::kHalfCells}, kNone, FeatureSet{F::kHasWalls},
                  "--wall-cells half needs walls; add --walls"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kObliqueLattice}, kNone,
                  "--walls needs a rectangle along x and y; give the two sides as its period"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kSymmetry}, kNone,
                  "--walls does not work with --symmetry; leave one of them out"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kAspect}, kNone,
                  "--aspect does not work with --walls; leave one of them out"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "--start lattice and best do not work with --walls; take coarse or random"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kStability}, kNone,
                  "--stability does not work with --walls; leave one of them out"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kRepeatAcrossWalls}, kNone,
                  "--repeat cannot repeat a tile across its walls; repeat it along them"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kOriginOffWalls}, kNone,
                  "--origin cannot move the walls, which lie at 0 and at the period; give an "
                  "origin along the walls, or none"},
    Contradiction{FeatureSet{F::kHalfCells}, FeatureSet{F::kNoIterations}, kNone,
                  "--wall-cells half moves sites onto the walls step by step; leave "
                  "--max-iterations 0 out, or take --wall-cells whole"},
    Contradiction{
        FeatureSet{F::kHasWalls}, FeatureSet{F::kDelaunay}, FeatureSet{F::kHalfCells},
        "--mesh delaunay needs sites on the walls; add --wall-cells half, or take --mesh grains"},
    Contradiction{FeatureSet{F::kHoles}, kNone, kWithInclusions,
                  "--hole removes cells inside inclusions; add --inclusions or --fibres"},
    Contradiction{kWithFixedSites, FeatureSet{F::kGivenSites}, kNone,
                  "--fixed, --inclusions and --fibres work with drawn sites only; give a number of "
                  "sites in place of their positions"},
    Contradiction{
        kWithFixedSites, FeatureSet{F::kSymmetry}, kNone,
        "--symmetry does not work with --fixed, --inclusions or --fibres; leave one of them out"},
    Contradiction{
        kWithFixedSites, FeatureSet{F::kAreas}, kNone,
        "--areas does not work with --fixed, --inclusions or --fibres; leave one of them out"},
    Contradiction{kWithFixedSites, FeatureSet{F::kStartNotRandom}, kNone,
                  "--fixed, --inclusions and --fibres start at random; leave --start out"},
    Contradiction{
        kWithFixedSites, FeatureSet{F::kStability}, kNone,
        "--stability does not work with --fixed, --inclusions or --fibres; leave one of them out"},
    Contradiction{FeatureSet{F::kFixed}, FeatureSet{F::kHasWalls}, kNone,
                  "--fixed does not work with --walls; leave one of them out"},
    Contradiction{FeatureSet{F::kInclusions}, FeatureSet{F::kFibres}, kNone,
                  "--fibres does not work with --inclusions; leave one of them out"},
    Contradiction{kWithInclusions, FeatureSet{F::kFixed}, kNone,
                  "--inclusions and --fibres have fixed sites of their own; leave --fixed out"},
    Contradiction{kWithInclusions, FeatureSet{F::kAspect}, kNone,
                  "--aspect does not work with --inclusions or --fibres; leave one of them out"},
    Contradiction{kWithInclusions, FeatureSet{F::kPhases}, kNone,
                  "--phases does not work with --inclusions or --fibres, whose tags are the "
                  "phases; leave it out"},
    Contradiction{kWithInclusions, FeatureSet{F::kOrientations}, kNone,
                  "--orientations gives each cell a crystal of its own, but inclusions and the "
                  "matrix consist of many cells each; leave it out"},
    Contradiction{FeatureSet{F::kStability}, FeatureSet{F::kDensity}, kNone,
                  "--stability does not work with --density; leave one of them out"},
    Contradiction{
        FeatureSet{F::kOutline}, FeatureSet{F::kDelaunay}, kNone,
        "--outline box cannot cut Delaunay triangles; take --mesh grains, or --outline whole"},
    Contradiction{FeatureSet{F::kGrainSize}, FeatureSet{F::kGrainPerEdge}, kNone,
                  "--size does not work with --per-edge; leave one of them out"},
    Contradiction{FeatureSet{F::kRetry}, FeatureSet{F::kGivenSites, F::kStartAtLattice}, kNone,
                  "--retry takes other seeds, but these sites have none; leave it out"},
    Contradiction{FeatureSet{F::kColourByDensity}, kNone, FeatureSet{F::kDensity},
                  "--colour density needs --density; add it, or take --colour size"},
    Contradiction{
        FeatureSet{F::kColourByPhase}, kNone, FeatureSet{F::kPhases, F::kInclusions, F::kFibres},
        "--colour phase needs --phases or --inclusions; add one of them, or take --colour size"},
    Contradiction{FeatureSet{F::kColourByOrbit}, kNone, FeatureSet{F::kSymmetry},
                  "--colour orbit needs --symmetry; add it, or take --colour cells"},
    Contradiction{
        FeatureSet{F::kColourByTag}, kNone, kWithInclusions,
        "--colour tag needs --inclusions or --fibres; add one of them, or take --colour size"},
    Contradiction{FeatureSet{F::kColourByOrientation}, kNone, FeatureSet{F::kOrientations},
                  "--colour orientation needs --orientations; add it, or take --colour size"},
    Contradiction{FeatureSet{F::kColourOfSpace}, kNone, kNone,
                  "--colour faces is for three dimensions; take sides, size, phase or cells"},
    Contradiction{FeatureSet{F::kSurface}, FeatureSet{F::kColour}, kNone,
                  "--surface boundary has the colours of its seam; leave --colour out, or take "
                  "--surface cells"},
    Contradiction{FeatureSet{F::kSurface}, FeatureSet{F::kVolumes, F::kWeights}, kNone,
                  "--surface boundary does not work with --volumes or --weights; take --surface "
                  "cells"}};

FeatureSet chosen_features(const Job& job) {
    FeatureSet chosen;
    for (const FeatureRow& row : features()) {
        if (row.is_chosen != nullptr && row.is_chosen(job)) chosen.add(row.feature);
    }
    return chosen;
}

/// All contradictions of a job, numbered where there are several; empty if there is none.
std::string contradictions_of(const Job& job) {
    const FeatureSet chosen = chosen_features(job);
    std::vector<const char*> messages;
    for (const auto& [these, those, unless, message] : kContradictions) {
        const bool meets = chosen.meets(these) && (those.is_empty() || chosen.meets(those));
        if (meets && !chosen.meets(unless)) messages.push_back(message);
    }
    if (messages.size() == 1) return messages.front();
    std::string text;
    for (std::size_t k = 0; k < messages.size(); ++k) {
        text += (k == 0 ? "(" : "; (") + std::to_string(k + 1) + ") " + messages[k];
    }
    return text;
}

}  // namespace

void require_compatible(const Job& job) {
    const std::string text = contradictions_of(job);
    if (!text.empty()) throw ContradictoryOptions(text);
}

}  // namespace pcvt
