#include "mesher/plane/proof/vertex_orbits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt::plane {
namespace {

/// A chain of vertices that agree pairwise may drift; its ends must agree within this many
/// tolerances.
constexpr double kLongestChain = 4;
/// A tolerance above this fraction of the shortest period would identify neighbouring images.
constexpr double kLargestTolerance = 1e-3;

/// In a file that is a tile, a bin holds at most about 700 vertices, because the tolerance is small
/// against their distances. More comparisons a vertex than this end the search.
constexpr std::size_t kMostComparisons = 2000;

/// A bin of the domain that a vertex touches. Vertices that agree share a bin.
struct BinEntry {
    std::int64_t column;
    std::int64_t row;
    int vertex;
    friend auto operator<=>(const BinEntry&, const BinEntry&) = default;
};

/// One coordinate of the domain, [0, 1), divided into equal bins.
class BinAxis {
   public:
    /// @param margin  the largest distance between two coordinates that agree, in lattice
    ///                coordinates.
    explicit BinAxis(double margin)
        : margin_(margin), n_bins_(std::clamp(std::floor(1 / (8 * margin)), 1.0, 0x1p50)) {}

    /// Returns which of `n` equal parts of the axis contains a bin.
    int share(std::int64_t bin, int n) const {
        return std::min(n - 1, static_cast<int>(static_cast<double>(bin) / n_bins_ * n));
    }

    /// Returns the bins within the margin of a coordinate; both entries are equal if it is one bin.
    std::array<std::int64_t, 2> touched(double coordinate) const {
        const double fraction = coordinate - std::floor(coordinate);
        return {bin(fraction - margin_), bin(fraction + margin_)};
    }

   private:
    std::int64_t bin(double fraction) const {
        const auto n = static_cast<std::int64_t>(n_bins_);
        const auto k = static_cast<std::int64_t>(std::floor(fraction * n_bins_));
        if (k >= 0 && k < n) return k;
        return ((k % n) + n) % n;
    }

    double margin_;
    double n_bins_;
};

/// Returns for each vertex the smallest vertex with the same representative and offset. Most
/// vertices are alone in their orbits, so only the others are sorted.
std::vector<int> first_copies(const std::vector<int>& representative,
                              const std::vector<Offset>& offset) {
    std::vector<int> first(representative.size());
    std::vector<int> shared;
    for (int v = 0; v < static_cast<int>(first.size()); ++v) {
        checkpoint_each(v);
        first[v] = v;
        if (representative[v] == v) continue;
        shared.push_back(v);
        shared.push_back(representative[v]);
    }
    std::sort(shared.begin(), shared.end(), [&](int v, int w) {
        return std::tie(representative[v], offset[v], v) <
               std::tie(representative[w], offset[w], w);
    });
    for (std::size_t k = 1; k < shared.size(); ++k) {
        const int v = shared[k];
        const int before = shared[k - 1];
        const bool same =
            representative[v] == representative[before] && offset[v] == offset[before];
        if (same) first[v] = first[before];
    }
    return first;
}

class OrbitFinder {
   public:
    OrbitFinder(const Lattice& lattice, std::span<const Vec2> points, double tolerance)
        : lattice_(lattice),
          reduction_(reduce(lattice)),
          points_(points),
          tolerance_(tolerance),
          orbits_(static_cast<int>(points.size())) {
        require_small_tolerance();
        coordinates_.reserve(points.size());
        for (const Vec2& p : points) {
            // Coordinates are relative to vertex 0, so that a tile far from the origin loses no
            // digits.
            coordinates_.push_back(reduction_.reduced.to_lattice(p - points.front()));
        }
        require_countable_periods();
    }

    VertexOrbits find() {
        unite_neighbours();
        const int n = static_cast<int>(points_.size());
        VertexOrbits result;
        result.representative.reserve(n);
        result.offset.reserve(n);
        for (int v = 0; v < n; ++v) {
            checkpoint_each(v);
            const int r = orbits_.find(v);
            const Offset offset = r == v ? Offset{} : offset_between(r, v);
            if (r != v) {
                result.mismatch = std::max(result.mismatch, length_of_chain(r, v, offset));
            }
            result.representative.push_back(r);
            result.offset.push_back(offset);
        }
        result.first_copy = first_copies(result.representative, result.offset);
        return result;
    }

   private:
    void require_small_tolerance() const {
        const double shortest = reduction_.reduced.a().norm();
        if (tolerance_ <= kLargestTolerance * shortest) return;
        throw_violation("(1)", "the tolerance of positions, " + in_words(tolerance_) +
                                   ", at least 4 ulps of the largest coordinate, is not small "
                                   "against the shortest period, " +
                                   in_words(shortest) +
                                   "; take a smaller one, or move the tile nearer to the origin");
    }

    void require_countable_periods() const {
        int largest = 1;
        for (const int entry : reduction_.m) largest = std::max(largest, std::abs(entry));
        // Keeps each product and sum of to_original() below 2^31.
        const double limit = 0x1p28 / largest;
        for (std::size_t v = 0; v < coordinates_.size(); ++v) {
            checkpoint_each(v);
            const double periods = coordinates_[v].cwiseAbs().maxCoeff();
            if (periods <= limit) continue;
            throw_violation("(1)", "vertex " + std::to_string(v) + " lies " + in_words(periods) +
                                       " periods away from vertex 0");
        }
    }

    /// Returns position(w) - position(v) in periods, rounded to integers.
    Offset offset_between(int v, int w) const {
        const Vec2 u = coordinates_[w] - coordinates_[v];
        return reduction_.to_original(
            {static_cast<int>(std::lround(u.x())), static_cast<int>(std::lround(u.y()))});
    }

    /// Returns the larger coordinate of |position(w) - position(v) - translation(offset)|. It is
    /// computed in long double, because the rounding error of the sum would be of the order of the
    /// tolerance.
    double mismatch(int v, int w, Offset offset) const {
        const auto along = [&](int k) {
            const long double translation = offset.i * static_cast<long double>(lattice_.a()[k]) +
                                            offset.j * static_cast<long double>(lattice_.b()[k]);
            return std::abs(static_cast<long double>(points_[w][k]) - points_[v][k] - translation);
        };
        return static_cast<double>(std::max(along(0), along(1)));
    }

    /// Returns the distance between the ends of a chain, modulo the lattice.
    double length_of_chain(int r, int v, Offset offset) const {
        const double apart = mismatch(r, v, offset);
        if (apart <= kLongestChain * tolerance_) return apart;
        throw_violation("(1)",
                        "vertices " + std::to_string(r) + " and " + std::to_string(v) +
                            " are joined by a chain of vertices that coincide modulo the lattice, "
                            "but lie " +
                            in_words(apart) + " apart (tolerance " + in_words(tolerance_) + ")");
    }

    std::vector<BinEntry> bin_entries() const {
        const Lattice& reduced = reduction_.reduced;
        // Bounds the change of u caused by a change of p, including the rounding errors of both.
        const double scale = 32 * tolerance_ / reduced.area();
        const BinAxis columns(scale * reduced.b().lpNorm<1>());
        const BinAxis rows(scale * reduced.a().lpNorm<1>());
        std::vector<BinEntry> entries;
        entries.reserve(points_.size());
        for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
            checkpoint_each(v);
            const auto column = columns.touched(coordinates_[v].x());
            const auto row = rows.touched(coordinates_[v].y());
            for (int i = 0; i <= (column[0] != column[1]); ++i) {
                for (int j = 0; j <= (row[0] != row[1]); ++j) {
                    entries.push_back({column[i], row[j], v});
                }
            }
        }
        const int n = static_cast<int>(points_.size());
        bucket_sort(entries, n,
                    [&](const BinEntry& entry) { return columns.share(entry.column, n); });
        return entries;
    }

    void unite_neighbours() {
        const std::vector<BinEntry> entries = bin_entries();
        std::size_t comparisons_left = kMostComparisons * points_.size();
        for (std::size_t k = 0; k < entries.size(); ++k) {
            checkpoint_each(k);
            const BinEntry& e = entries[k];
            for (std::size_t l = k + 1; l < entries.size(); ++l) {
                const BinEntry& f = entries[l];
                if (e.column != f.column || e.row != f.row) break;
                if (comparisons_left-- == 0) throw_crowd(e.vertex);
                const Offset offset = offset_between(e.vertex, f.vertex);
                if (mismatch(e.vertex, f.vertex, offset) <= tolerance_) {
                    orbits_.unite(e.vertex, f.vertex);
                }
            }
        }
    }

    [[noreturn]] void throw_crowd(int vertex) const {
        throw_violation("(1)", "thousands of vertices lie as near to vertex " +
                                   std::to_string(vertex) +
                                   ", modulo the lattice, as coordinates with a tolerance of " +
                                   in_words(tolerance_) + " can show");
    }

    const Lattice& lattice_;
    Reduction reduction_;
    std::span<const Vec2> points_;
    double tolerance_;
    /// Coordinates in the reduced basis.
    std::vector<Vec2> coordinates_;
    DisjointSets orbits_;
};

}  // namespace

VertexOrbits proven_orbits(const TileProof& proof) {
    const int n = static_cast<int>(proof.first_copy.size());
    VertexOrbits orbits{std::vector<int>(n), std::vector<Offset>(n), proof.first_copy};
    std::iota(orbits.representative.begin(), orbits.representative.end(), 0);
    for (const VertexPair& pair : proof.vertex_pairs) {
        orbits.representative[pair.w] = pair.v;
        orbits.offset[pair.w] = pair.offset;
    }
    for (int v = 0; v < n; ++v) {
        checkpoint_each(v);
        orbits.representative[v] = orbits.representative[proof.first_copy[v]];
        orbits.offset[v] = orbits.offset[proof.first_copy[v]];
    }
    return orbits;
}

VertexOrbits find_vertex_orbits(const Lattice& lattice, std::span<const Vec2> points,
                                double tolerance, std::span<const int> copies) {
    if (points.empty()) return {};
    VertexOrbits orbits =
        OrbitFinder(lattice, points.first(points.size() - copies.size()), tolerance).find();
    for (const int v : copies) {
        orbits.representative.push_back(orbits.representative[v]);
        orbits.offset.push_back(orbits.offset[v]);
        orbits.first_copy.push_back(orbits.first_copy[v]);
    }
    return orbits;
}

}  // namespace pcvt::plane
