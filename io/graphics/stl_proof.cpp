#include "io/graphics/stl_proof.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt {
namespace {

constexpr double kSingleEpsilon = std::numeric_limits<float>::epsilon();

/// In the test of translations, corners nearer to each other than the first number of roundings of
/// the largest coordinate are one; none may have a distance between both numbers.
constexpr double kSame = 2;
constexpr double kApart = 8;

/// The corners of a file, numbered by their positions.
struct NumberedCorners {
    std::vector<std::array<int, 3>> of_facets = {};
    std::vector<Eigen::Vector3f> positions = {};
};

NumberedCorners numbered_corners(const std::vector<StlFacet>& facets) {
    std::map<std::array<float, 3>, int> places;
    NumberedCorners numbered;
    numbered.of_facets.reserve(facets.size());
    for (const StlFacet& facet : facets) {
        checkpoint_each(static_cast<long>(numbered.of_facets.size()));
        std::array<int, 3>& numbers = numbered.of_facets.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3f& p = facet.corners[k];
            const auto [place, is_new] =
                places.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(places.size()));
            if (is_new) numbered.positions.push_back(p);
            numbers[k] = place->second;
        }
    }
    return numbered;
}

std::string triangle_name(std::size_t k) { return "triangle " + std::to_string(k + 1); }

/// Finds where closed surfaces end.
class EdgeBalance {
   public:
    /// Adds a triangle. @returns whether all triangles since the last end are closed.
    bool add(const std::array<int, 3>& corners) {
        for (int k = 0; k < 3; ++k) add_edge(corners[k], corners[(k + 1) % 3]);
        return sums_.empty();
    }

    bool is_closed() const { return sums_.empty(); }

   private:
    void add_edge(int from, int to) {
        const auto edge = std::minmax(from, to);
        const auto found = sums_.try_emplace(edge, 0).first;
        found->second += from < to ? 1 : -1;
        if (found->second == 0) sums_.erase(found);
    }

    /// Of each edge that is not closed yet, how often it is traversed upwards less downwards.
    std::map<std::pair<int, int>, int> sums_;
};

/// The volume and the area of triangles, and the largest coordinate.
struct Extent {
    double volume = 0;
    double area = 0;

    void add(const StlFacet& facet, const space::Vec3& origin) {
        const space::Vec3 p = facet.corners[0].cast<double>() - origin;
        const space::Vec3 q = facet.corners[1].cast<double>() - origin;
        const space::Vec3 r = facet.corners[2].cast<double>() - origin;
        volume += p.cross(q).dot(r) / 6;
        area += (q - p).cross(r - p).norm() / 2;
    }
};

double largest_coordinate(const std::vector<StlFacet>& facets) {
    double largest = 0;
    for (const StlFacet& facet : facets) {
        for (const Eigen::Vector3f& corner : facet.corners) {
            largest = std::max(largest, double{corner.cwiseAbs().maxCoeff()});
        }
    }
    return largest;
}

/// Returns the first image of each corner by the translations of a lattice; nothing where distances
/// leave open which corners are images of each other.
/// @param rounding  that of the largest coordinate, length units.
std::optional<std::vector<int>> orbits_of(const std::vector<Eigen::Vector3f>& corners,
                                          const space::Lattice& lattice, double rounding) {
    const space::Lattice reduced = space::reduce(lattice).reduced;
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = reduced.periods()[k];
    space::Points coordinates(3, corners.size());
    for (std::size_t v = 0; v < corners.size(); ++v) {
        coordinates.col(static_cast<int>(v)) =
            space::Lattice::wrapped(reduced.to_lattice(corners[v].cast<double>()));
    }
    const auto images = coincident_sites(coordinates, periods, kSame * rounding);
    if (images != coincident_sites(coordinates, periods, kApart * rounding)) return std::nullopt;
    std::vector<int> orbits(corners.size());
    std::iota(orbits.begin(), orbits.end(), 0);
    for (const CoincidentSite& image : images) orbits[image.site] = image.earlier;
    return orbits;
}

/// Law (3). @returns whether it could be tested.
bool prove_translations(const NumberedCorners& corners, const space::Lattice& lattice,
                        double rounding) {
    const auto orbits = orbits_of(corners.positions, lattice, rounding);
    if (!orbits) return false;
    // Of each triangle of orbits, how often it occurs with one orientation less the other, and one
    // facet.
    std::map<std::array<int, 3>, std::pair<int, std::size_t>> sums;
    for (std::size_t k = 0; k < corners.of_facets.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        std::array<int, 3> t{};
        for (std::size_t c = 0; c < 3; ++c) t[c] = (*orbits)[corners.of_facets[k][c]];
        const bool is_even = (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2]));
        std::sort(t.begin(), t.end());
        if (t[0] == t[1] || t[1] == t[2]) continue;
        auto& [sum, facet] = sums.try_emplace(t, 0, k).first->second;
        sum += is_even ? 1 : -1;
    }
    for (const auto& [triangle, count] : sums) {
        if (count.first == 0) continue;
        throw_violation("(3), periods", triangle_name(count.second) +
                                            " has no partner by the periods in the header");
    }
    return true;
}

/// Laws (1) and (2) of the surfaces by themselves.
StlProof prove_surfaces(const std::vector<StlFacet>& facets,
                        const std::vector<std::array<int, 3>>& corners) {
    StlProof proof{.n_triangles = static_cast<int>(facets.size())};
    EdgeBalance edges;
    Extent whole;
    Extent own;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        if (stl_normal(facets[k].corners).isZero()) {
            throw_violation("(2), volumes", triangle_name(k) + " has no area");
        }
        own.add(facets[k], facets.front().corners[0].cast<double>());
        if (!edges.add(corners[k])) continue;
        if (!(own.volume > 0)) {
            throw_violation("(2), volumes",
                            "the surface that ends with " + triangle_name(k) +
                                " encloses no positive volume; it is turned inside out");
        }
        ++proof.n_surfaces;
        whole.volume += own.volume;
        whole.area += own.area;
        own = {};
    }
    if (!edges.is_closed()) {
        throw_violation("(1), closed surfaces", "the last surface does not close");
    }
    proof.volume = whole.volume;
    // A corner moves by at most half an ulp along each axis.
    proof.tolerance = kSingleEpsilon * largest_coordinate(facets) * whole.area;
    return proof;
}

}  // namespace

StlProof prove_stl(const EncodedFile& file) {
    const StlFile stl = decode_stl(file);
    const NumberedCorners corners = numbered_corners(stl.facets);
    StlProof proof = prove_surfaces(stl.facets, corners.of_facets);
    if (const std::optional<space::Lattice> lattice = stl_lattice(stl)) {
        proof.has_periods = true;
        if (!(std::abs(proof.volume - lattice->volume()) <= proof.tolerance)) {
            throw_violation("(2), volumes", "they sum to " + std::to_string(proof.volume) +
                                                ", not " + std::to_string(lattice->volume()));
        }
        proof.repeats =
            prove_translations(corners, *lattice, kSingleEpsilon * largest_coordinate(stl.facets));
    }
    if (stl_form(stl)) {
        StlFile own = stl;
        for (StlFacet& facet : own.facets) facet.normal = stl_normal(facet.corners);
        if (file.bytes != encode_stl(own, file.path).front().bytes) {
            throw BadFile(file.path +
                          ": the normals or the attributes are not those of its corners; write the "
                          "file again with pcvt");
        }
    }
    return proof;
}

bool holds_surfaces(const EncodedFile& file, const ClosedSurfaces& surfaces) {
    const StlFile stl = decode_stl(file);
    const std::vector<StlFacet> wanted = stl_facets(surfaces);
    return stl_form(stl) == surfaces.form &&
           std::equal(stl.facets.begin(), stl.facets.end(), wanted.begin(), wanted.end(),
                      [](const StlFacet& s, const StlFacet& t) { return s.corners == t.corners; });
}

}  // namespace pcvt
