#include "plugin/job/contradictions.hpp"

#include <array>
#include <cstdint>

#include "mesher/base/error.hpp"
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
                  "a lattice knows no density; leave the start out, or take coarse or random"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kDensity}, kNone,
                  "cells have prescribed areas or follow a density; leave one of the two out"},
    Contradiction{
        FeatureSet{F::kAreas}, FeatureSet{F::kStartWithEqualCells}, kNone,
        "the cells of a lattice are all alike; leave the start out, or take coarse or random"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kSolver}, kNone,
                  "prescribed areas have a solver of their own; leave the solver out"},
    Contradiction{FeatureSet{F::kAreas}, FeatureSet{F::kStability}, kNone,
                  "the stability of prescribed areas is not known; leave one out"},
    Contradiction{FeatureSet{F::kSymmetry}, FeatureSet{F::kGivenSites}, kNone,
                  "the sites of a symmetry are drawn; leave the sites out, or the symmetry"},
    Contradiction{FeatureSet{F::kSymmetry}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "a lattice knows no plane group; leave the start out, or take coarse or random"},
    Contradiction{FeatureSet{F::kSymmetry}, FeatureSet{F::kAreas}, kNone,
                  "cells of prescribed areas have no symmetry; leave one of the two out"},
    Contradiction{FeatureSet{F::kHalfCells}, kNone, FeatureSet{F::kHasWalls},
                  "half cells lie on walls, but there are none; give the walls"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kObliqueLattice}, kNone,
                  "walls need a rectangle along x and y; give its period as W,H"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kSymmetry}, kNone,
                  "sites have walls or a symmetry; leave one of the two out"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kAspect}, kNone,
                  "elongated cells need a periodic plane; leave them out, or the walls"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kStartWithEqualCells}, kNone,
                  "a lattice knows no walls; leave the start out, or take coarse or random"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kStability}, kNone,
                  "the stability between walls is not known; leave one out"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kRepeatAcrossWalls}, kNone,
                  "a tile is not repeated across its walls; repeat it along them"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kOriginOffWalls}, kNone,
                  "walls lie at 0 and at the period; give an origin along the walls only, or none"},
    Contradiction{FeatureSet{F::kHalfCells}, FeatureSet{F::kNoIterations}, kNone,
                  "the sites beside walls move onto them step by step; allow iterations, or take "
                  "whole cells"},
    Contradiction{FeatureSet{F::kHasWalls}, FeatureSet{F::kDelaunay}, FeatureSet{F::kHalfCells},
                  "Delaunay triangles cross the walls unless sites lie on them; take half cells at "
                  "the walls, or the mesh grains"},
    Contradiction{FeatureSet{F::kHoles}, kNone, kWithInclusions,
                  "holes are inclusions that are left out; give inclusions or fibres"},
    Contradiction{kWithFixedSites, FeatureSet{F::kGivenSites}, kNone,
                  "sites beside fixed ones and inclusions are drawn; give a number of sites "
                  "instead of their positions"},
    Contradiction{kWithFixedSites, FeatureSet{F::kSymmetry}, kNone,
                  "fixed sites and inclusions have no symmetry; leave one of the two out"},
    Contradiction{kWithFixedSites, FeatureSet{F::kAreas}, kNone,
                  "cells of prescribed areas have neither fixed sites nor inclusions; leave the "
                  "areas out"},
    Contradiction{kWithFixedSites, FeatureSet{F::kStartNotRandom}, kNone,
                  "sites beside fixed ones and inclusions start at random; leave the start out"},
    Contradiction{kWithFixedSites, FeatureSet{F::kStability}, kNone,
                  "the stability with fixed sites or inclusions is not known; leave one out"},
    Contradiction{FeatureSet{F::kFixed}, FeatureSet{F::kHasWalls}, kNone,
                  "fixed sites need a plane that is periodic along both directions; leave the "
                  "walls out"},
    Contradiction{FeatureSet{F::kInclusions}, FeatureSet{F::kFibres}, kNone,
                  "fibres are inclusions in random places; leave one of the two out"},
    Contradiction{kWithInclusions, FeatureSet{F::kFixed}, kNone,
                  "inclusions have fixed sites of their own; leave one of the two out"},
    Contradiction{kWithInclusions, FeatureSet{F::kAspect}, kNone,
                  "cells beside inclusions are not elongated; leave the aspect out"},
    Contradiction{kWithInclusions, FeatureSet{F::kPhases}, kNone,
                  "the tags of inclusions are the phases of their cells; leave the phases out"},
    Contradiction{kWithInclusions, FeatureSet{F::kOrientations}, kNone,
                  "--orientations gives each cell a crystal of its own, but inclusions and the "
                  "matrix consist of many cells each; leave the orientations out"},
    Contradiction{FeatureSet{F::kStability}, FeatureSet{F::kDensity}, kNone,
                  "the stability of a run with a density is not known; leave one out"},
    Contradiction{FeatureSet{F::kOutline}, FeatureSet{F::kDelaunay}, kNone,
                  "the box outline would cut Delaunay triangles, and cut ones are none; take the "
                  "mesh grains with the box outline, or the whole outline"},
    Contradiction{FeatureSet{F::kGrainSize}, FeatureSet{F::kGrainPerEdge}, kNone,
                  "grains have a size and parts of an edge; take one of the two"},
    Contradiction{FeatureSet{F::kRetry}, FeatureSet{F::kGivenSites, F::kStartAtLattice}, kNone,
                  "--retry takes other seeds, but these sites have none; leave it out"},
    Contradiction{FeatureSet{F::kColourByDensity}, kNone, FeatureSet{F::kDensity},
                  "there is no density to show in colours; give one, or colour by size"},
    Contradiction{FeatureSet{F::kColourByPhase}, kNone,
                  FeatureSet{F::kPhases, F::kInclusions, F::kFibres},
                  "there are no phases to show in colours; give some, or colour by size"},
    Contradiction{FeatureSet{F::kColourByOrbit}, kNone, FeatureSet{F::kSymmetry},
                  "there is no symmetry whose orbits colours could show; give one, or colour by "
                  "cells"},
    Contradiction{FeatureSet{F::kColourByTag}, kNone, kWithInclusions,
                  "there are no inclusions whose tags colours could show; give some, or colour by "
                  "size"}};

FeatureSet chosen_features(const Job& job) {
    FeatureSet chosen;
    for (const FeatureRow& row : features()) {
        if (row.is_chosen != nullptr && row.is_chosen(job)) chosen.add(row.feature);
    }
    return chosen;
}

}  // namespace

void require_compatible(const Job& job) {
    const FeatureSet chosen = chosen_features(job);
    for (const auto& [these, those, unless, message] : kContradictions) {
        const bool meets = chosen.meets(these) && (those.is_empty() || chosen.meets(those));
        if (meets && !chosen.meets(unless)) throw InvalidInput(message);
    }
}

}  // namespace pcvt
