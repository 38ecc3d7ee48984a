#include "mesher/plane/symmetry/symmetric_sites.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/delaunay/spatial_sort.hpp"
#include "mesher/plane/density/density_survey.hpp"

namespace pcvt::plane {
namespace {

/// A point of the torus with integer coordinates: parts of a period.
struct Place {
    std::int64_t u;
    std::int64_t v;

    friend bool operator==(const Place&, const Place&) = default;
};

constexpr std::int64_t kGrid = std::int64_t{1} << 51;

/// A place as a multiple of 2^-51 of a period.
Place on_grid(const Vec2& u) {
    const auto part = [](double x) {
        return static_cast<std::int64_t>(std::ldexp(wrap(x).fraction, 51));
    };
    return {part(u.x()), part(u.y())};
}

/// @param parts  of a period, which the coordinates count.
Place image(const LatticeIsometry& g, const Place& p, std::int64_t parts) {
    const auto wrapped = [parts](std::int64_t k) { return ((k % parts) + parts) % parts; };
    return {wrapped(g.m[0] * p.u + g.m[1] * p.v + parts / 2 * g.halves[0]),
            wrapped(g.m[2] * p.u + g.m[3] * p.v + parts / 2 * g.halves[1])};
}

Vec2 coordinates(const Place& p, std::int64_t parts) {
    const auto number = [parts](std::int64_t k) {
        return parts == kGrid ? std::ldexp(static_cast<double>(k), -51)
                              : wrap(static_cast<double>(k) / static_cast<double>(parts)).fraction;
    };
    return {number(p.u), number(p.v)};
}

using TieMatrix = std::array<std::int8_t, 4>;

/// The matrix m restricted to moves along `along`, of which one entry is +1 or -1.
TieMatrix along_mirror(const std::array<int, 4>& m, const std::array<int, 2>& along) {
    const int k = std::abs(along[0]) == 1 ? 0 : 1;
    TieMatrix tie{};
    for (int row = 0; row < 2; ++row) {
        const int moved = m[2 * row] * along[0] + m[2 * row + 1] * along[1];
        tie[2 * row + k] = static_cast<std::int8_t>(moved * along[k]);
    }
    return tie;
}

/// Collects orbits.
class OrbitBuilder {
   public:
    explicit OrbitBuilder(const PlaneGroup& group) : group_(group) {}

    /// Appends the orbit of a place.
    void add(const Place& place, std::int64_t parts) {
        SiteOrbit orbit = fixed_orbit(place, parts);
        orbit.representative = static_cast<SiteId>(coordinates_.size());
        std::vector<Place> images;
        for (const LatticeIsometry& g : group_.operations()) {
            const Place p = image(g, place, parts);
            if (std::find(images.begin(), images.end(), p) != images.end()) continue;
            images.push_back(p);
            coordinates_.push_back(coordinates(p, parts));
            orbit_.push_back(static_cast<int>(orbits_.size()));
            ties_.push_back({orbit.representative, tie(g, orbit)});
        }
        orbit.n_sites = static_cast<int>(images.size());
        orbits_.push_back(orbit);
        checkpoint_each(static_cast<long>(orbits_.size()));
    }

    SymmetricSites build() {
        Points points(2, static_cast<Eigen::Index>(coordinates_.size()));
        for (Eigen::Index s = 0; s < points.cols(); ++s) points.col(s) = coordinates_[s];
        Sites sites(group_.lattice(), group_.reduction(), std::move(points));
        const auto [first, second] = sites.duplicates();
        if (first >= 0) throw DuplicateSites(first, second);
        return {group_, std::move(sites), std::move(orbit_), std::move(orbits_), std::move(ties_)};
    }

   private:
    /// The freedom that the operations leave which fix the place.
    SiteOrbit fixed_orbit(const Place& place, std::int64_t parts) const {
        SiteOrbit orbit;
        for (const LatticeIsometry& g : group_.operations()) {
            if (g == LatticeIsometry{} || image(g, place, parts) != place) continue;
            const bool on_mirror = orbit.freedom == 2 && g.determinant() < 0;
            orbit.freedom = on_mirror ? 1 : 0;
            if (on_mirror) orbit.along = mirror_direction(g);
        }
        if (orbit.freedom != 1) orbit.along = {0, 0};
        return orbit;
    }

    static TieMatrix tie(const LatticeIsometry& g, const SiteOrbit& orbit) {
        if (orbit.freedom == 0) return {};
        if (orbit.freedom == 1) return along_mirror(g.m, orbit.along);
        TieMatrix tie;
        std::transform(g.m.begin(), g.m.end(), tie.begin(),
                       [](int entry) { return static_cast<std::int8_t>(entry); });
        return tie;
    }

    const PlaneGroup& group_;
    std::vector<Vec2> coordinates_;
    std::vector<int> orbit_;
    std::vector<SiteOrbit> orbits_;
    std::vector<MoveTie> ties_;
};

void require_plan(const PlaneGroup& group, const SpecialPositions& special, const OrbitPlan& plan) {
    if (plan.on_mirrors.size() != special.mirrors.size() ||
        plan.at_centres.size() != special.centres.size()) {
        throw InvalidInput(std::string("the plan of orbits does not fit the symmetry ") +
                           group.row().word + "; give a number for each special position");
    }
    const std::int64_t most = kMostSites / group.order();
    if (plan.n_general > most) throw InvalidInput("there are more than 2^28 sites");
    if (n_sites(group, special, plan) < 1) {
        throw InvalidInput("no sites are given; give at least one");
    }
}

/// A line of the orbit of a mirror.
struct PlacedLine {
    Place through;
    std::array<int, 2> along;

    /// The place at the fraction s of its length, for any s.
    Place at(double s) const {
        const std::int64_t step = on_grid({s, 0}).u;
        const auto wrapped = [](std::int64_t k) { return ((k % kGrid) + kGrid) % kGrid; };
        constexpr std::int64_t kTwelfthsPerQuarter = kTwelfths / 4;
        return {wrapped(kGrid / 4 * (through.u / kTwelfthsPerQuarter) + along[0] * step),
                wrapped(kGrid / 4 * (through.v / kTwelfthsPerQuarter) + along[1] * step)};
    }
};

Place place_of(const std::array<int, 2>& twelfths) { return {twelfths[0], twelfths[1]}; }

PlacedLine image(const LatticeIsometry& g, const MirrorLine& mirror) {
    const auto& [u, v] = mirror.along;
    return {image(g, place_of(mirror.through), kTwelfths),
            {g.m[0] * u + g.m[1] * v, g.m[2] * u + g.m[3] * v}};
}

/// Finds the special positions near to points.
class Snapping {
   public:
    /// @param near  length units.
    Snapping(const PlaneGroup& group, double near)
        : group_(group), special_(special_positions(group)), near_(near) {}

    /// Appends the orbit of the nearest centre, else of the nearest place on a mirror, else of the
    /// point itself.
    void add(const Vec2& u, OrbitBuilder& orbits) const {
        for (const RotationCentre& centre : special_.centres) {
            for (const LatticeIsometry& g : group_.operations()) {
                const Place at = image(g, place_of(centre.place), kTwelfths);
                const Vec2 difference = u - coordinates(at, kTwelfths);
                const Vec2 nearest = difference.array() - difference.array().round();
                if (reduced().to_position(nearest).norm() > near_) continue;
                return orbits.add(at, kTwelfths);
            }
        }
        for (const MirrorLine& mirror : special_.mirrors) {
            for (const LatticeIsometry& g : group_.operations()) {
                const PlacedLine line = image(g, mirror);
                const Vec2 along(line.along[0], line.along[1]);
                const Vec2 difference = u - coordinates(line.through, kTwelfths);
                // The images of the line lie where this is a whole number.
                const double across = along.x() * difference.y() - along.y() * difference.x();
                const double height = std::abs(across - std::round(across)) * reduced().area() /
                                      reduced().to_position(along).norm();
                if (height > near_) continue;
                const int k = std::abs(line.along[0]) == 1 ? 0 : 1;
                return orbits.add(line.at(difference[k] * line.along[k]), kGrid);
            }
        }
        orbits.add(on_grid(u), kGrid);
    }

   private:
    const Lattice& reduced() const { return group_.reduction().reduced; }

    const PlaneGroup& group_;
    SpecialPositions special_;
    double near_;
};

/// Representatives in general positions, length units.
Points general_points(const PlaneGroup& group, int n, std::uint64_t seed,
                      const std::optional<Density>& density) {
    if (n == 0) return Points(2, 0);
    return density ? graded_points(group.lattice(), *density, n, seed)
                   : uniform_points(group.lattice(), n, seed);
}

}  // namespace

OrbitPlaces random_places(const PlaneGroup& group, const OrbitPlan& plan, std::uint64_t seed,
                          const std::optional<Density>& density) {
    require_plan(group, special_positions(group), plan);
    OrbitPlaces places{.at_centres = plan.at_centres, .on_mirrors = {}, .general = {}};
    std::mt19937_64 generator(seed);
    for (const int n_on_mirror : plan.on_mirrors) {
        std::vector<double>& on_mirror = places.on_mirrors.emplace_back();
        for (int site = 0; site < n_on_mirror; ++site) {
            on_mirror.push_back(std::ldexp(double(generator() >> 11), -53));
        }
    }
    places.general = general_points(group, plan.n_general, seed, density);
    return places;
}

SymmetricSites sites_at(const PlaneGroup& group, const OrbitPlaces& places) {
    const SpecialPositions special = special_positions(group);
    OrbitBuilder orbits(group);
    for (std::size_t k = 0; k < special.centres.size(); ++k) {
        if (places.at_centres[k]) orbits.add(place_of(special.centres[k].place), kTwelfths);
    }
    for (std::size_t k = 0; k < special.mirrors.size(); ++k) {
        const PlacedLine line{place_of(special.mirrors[k].through), special.mirrors[k].along};
        for (const double part : places.on_mirrors[k]) orbits.add(line.at(part), kGrid);
    }
    for (Eigen::Index s = 0; s < places.general.cols(); ++s) {
        orbits.add(on_grid(group.reduction().reduced.to_lattice(places.general.col(s))), kGrid);
    }
    return orbits.build();
}

SymmetricSites random_sites(const PlaneGroup& group, const OrbitPlan& plan, std::uint64_t seed,
                            const std::optional<Density>& density) {
    return sites_at(group, random_places(group, plan, seed, density));
}

SymmetricSites orbits_of(const PlaneGroup& group, const Points& representatives) {
    const Sites points(group.lattice(), representatives);
    const double h = std::sqrt(group.lattice().area() / (double(points.n_sites()) * group.order()));
    const Snapping snapping(group, kSameVertex * h);
    OrbitBuilder orbits(group);
    for (SiteId s = 0; s < points.n_sites(); ++s) snapping.add(points.coordinates().col(s), orbits);
    return orbits.build();
}

SymmetricSites renumbered(const SymmetricSites& sites, const std::vector<SiteId>& order) {
    const auto n = order.size();
    std::vector<SiteId> number(n);
    Points coordinates(2, static_cast<Eigen::Index>(n));
    std::vector<int> orbit(n);
    for (std::size_t k = 0; k < n; ++k) {
        number[order[k]] = static_cast<SiteId>(k);
        coordinates.col(static_cast<Eigen::Index>(k)) = sites.sites.coordinates().col(order[k]);
        orbit[k] = sites.orbit[order[k]];
    }
    std::vector<SiteOrbit> orbits = sites.orbits;
    for (SiteOrbit& one : orbits) one.representative = number[one.representative];
    std::vector<MoveTie> ties(n);
    for (std::size_t k = 0; k < n; ++k) {
        ties[k] = sites.ties[order[k]];
        ties[k].representative = number[ties[k].representative];
    }
    Sites same(sites.group.lattice(), sites.group.reduction(), std::move(coordinates));
    return {sites.group, std::move(same), std::move(orbit), std::move(orbits), std::move(ties)};
}

SymmetricSites numbered_by_columns(const SymmetricSites& sites) {
    return renumbered(
        sites,
        spatial_sort(sites.sites.coordinates(), gram_of(sites.group.reduction().reduced)).order);
}

}  // namespace pcvt::plane
