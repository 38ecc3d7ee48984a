#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt {

/// The report of a run, in the order of the file's keys.
///
/// Example usage:
///     Report report{.version = "1.0", .sites = 64, .lattice = Lattice::rectangle(1, 1)};
///     report.stop = "converged";
///     output.stage("report.json", encode_report(report));
struct Report {
    struct Seconds {
        double build;
        double optimize;
        double write;
        double total;
    };

    /// The best exact lattice for the number of sites.
    struct Pattern {
        plane::Lattice basis;
        /// {a, b, d}: the vectors (d, -b) / n and (0, a) / n, in the reduced period vectors, span
        /// the lattice.
        std::array<int, 3> hermite;
        double energy;
        /// Whether the lattice is a minimum: yes, no, unknown.
        std::string minimum;
        /// The smallest eigenvalue of the Hessian over the largest one; null for one site.
        std::optional<double> smallest_eigenvalue;
    };
    /// A corner of a cell that is sharper than the angles which grains aim at.
    struct SharpCorner {
        int site;
        plane::Vec2 point;
        double angle;
    };
    struct Grains {
        int triangles;
        /// The smallest angle in degrees, except for the angles in the sharp corners.
        double smallest_angle;
        std::vector<SharpCorner> sharp_corners;
    };
    /// The statistics of a run with a density.
    struct Density {
        /// The formula or the path of the image.
        std::string name;
        /// The extremes over all evaluations.
        double least;
        double greatest;
        /// Evaluations of the density per site during one evaluation of the energy.
        double evaluations_per_site;
        /// The mass over all cells, density x length^2, and its relative difference from the
        /// integral without cells.
        double mass;
        double mass_deviation;
        /// The asymptotic energy for many sites, density x length^4.
        double expected_energy;
        /// The median of |h_i / l_i - 1| over the cells, with l_i from rho^(-1/4).
        double spacing_deviation;
        /// The error of a centroid, in spacings of its cell.
        double quadrature_error;
        int rough_cells;
    };
    /// The statistics of a run with prescribed areas.
    struct Areas {
        /// The law, or the path of the file.
        std::string law;
        /// The factor that took given areas to the area of the domain; the key is left out without
        /// them.
        std::optional<double> scale = {};
        /// Of the equivalent diameters.
        double std_over_mean;
        double largest_relative_error;
        /// Of the areas of cells and grains in the tiles; `nullopt` if none was built.
        std::optional<double> largest_relative_mesh_error;
        int newton_steps;
        double circularity_mean;
        double circularity_std;
    };
    /// Of elongated cells.
    struct Aspect {
        double ratio;
        double degrees;
    };

    /// The plane group of the sites, and the number of their orbits.
    struct Symmetry {
        std::string group;
        int orbits;
    };

    /// The file of the inclusions or `fibres`, the number of shapes, of the chords that replace
    /// their outlines, of the sites beside them, and of those that they stopped.
    struct Inclusions {
        std::string source;
        int shapes;
        /// x, y and radius of each drawn fibre.
        std::vector<std::array<double, 3>> fibres;
        int chords;
        int fixed_sites;
        int held_sites;
        /// The tags whose cells are left out.
        std::vector<std::string> holes;
    };
    /// The sides that are walls, the cells beside them, and the number of sites on them.
    struct Walls {
        std::string sides;
        std::string cells;
        int sites;
    };

    /// A phase of the cells, and its shares of the area.
    struct Phase {
        std::string name;
        double wanted;
        double reached;
        int cells;
    };

    /// The least and the greatest of each angle of the orientations, degrees.
    struct Orientations {
        std::array<double, 2> phi1;
        std::array<double, 2> Phi;
        std::array<double, 2> phi2;
    };
    /// A material of the files, and its elastic constants by name.
    struct Material {
        std::string name;
        std::vector<std::pair<std::string, double>> constants;
    };

    std::string version;
    int sites;
    plane::Lattice lattice;
    std::uint64_t seed;
    std::string solver;
    std::string start;
    std::string stop;
    int iterations;
    int evaluations;
    /// Hessians of Newton's method, which `evaluations` does not include.
    int hessians;
    int cg_products;
    double energy;
    /// null where the density is not uniform.
    std::optional<double> energy_bound;
    double residual;
    /// yes, no or unknown; null if the run did not determine it.
    std::optional<std::string> minimum;
    int hexagons;
    /// The number of cells with each number of sides.
    std::map<int, int> valences;
    /// null unless the mirror method ran.
    std::optional<int> mirrors;
    int threads;
    Seconds seconds;
    std::vector<std::string> files;
    /// How a global search found the sites, in words. This key and the next one are left out if
    /// they are empty.
    std::string found = {};
    std::optional<Pattern> pattern = {};
    /// Runs with the box outline have the first key, in units of h; runs with grains the second
    /// one.
    std::optional<double> box_shortest_edge = {};
    std::optional<Grains> grains = {};
    /// Runs without a density, areas or an aspect leave their keys out.
    std::optional<Density> density = {};
    std::optional<Areas> areas = {};
    std::optional<Aspect> aspect = {};
    /// Runs without a symmetry, without walls, or without phases, leave these keys out.
    std::optional<Symmetry> symmetry = {};
    std::optional<Walls> walls = {};
    std::optional<Inclusions> inclusions = {};
    std::vector<Phase> phases = {};
    /// Sites that were left out because they coincide with earlier ones; runs that refuse such
    /// sites leave this key out.
    std::optional<DroppedSites> duplicates = {};
    std::optional<Orientations> orientations = {};
    /// Of files that state elastic constants.
    std::vector<Material> materials = {};
};

/// The report of a run in three dimensions, in the order of the file's keys.
struct SpaceReport {
    struct Seconds {
        double optimize = 0;
        double write = 0;
        double total = 0;
    };
    /// The best exact lattice for the number of sites.
    struct Pattern {
        std::array<std::array<double, 3>, 3> basis;
        /// {a, d, f, b, c, e}: the vectors (d f, 0, 0) / n, (-b f, a f, 0) / n and
        /// (b e - c d, -a e, a d) / n, in the reduced period vectors, span the lattice.
        std::array<int, 6> hermite;
        double energy;
        /// Whether the lattice is a minimum: yes, no, unknown.
        std::string minimum;
        /// The smallest eigenvalue of the Hessian over the largest one; null for one site.
        std::optional<double> smallest_eigenvalue;
    };

    std::string version;
    int sites = 0;
    std::array<std::array<double, 3>, 3> lattice = {};
    std::uint64_t seed = 0;
    std::string solver;
    std::string start;
    std::string stop;
    int iterations = 0;
    int evaluations = 0;
    double energy = 0;
    /// The energy of as many truncated octahedra.
    double energy_bound = 0;
    double residual = 0;
    double rms_residual = 0;
    /// yes, no or unknown; null if the run did not determine it.
    std::optional<std::string> minimum = {};
    /// The number of cells with each number of faces.
    std::map<int, int> faces;
    /// Edges that were removed because they were short.
    int removed_edges = 0;
    double volume = 0;
    int boundary_pairs = 0;
    int translations = 0;
    bool boundary_is_manifold = false;
    int threads = 0;
    Seconds seconds;
    std::vector<std::string> files;
    /// Runs that do not begin at a lattice leave this key out.
    std::optional<Pattern> pattern = {};
    /// As in Report.
    std::optional<DroppedSites> duplicates = {};
};

/// Encodes the report as JSON: one key per line, numbers as the shortest decimals that read back,
/// text as UTF-8 (invalid bytes become U+FFFD).
/// @throws InternalError if a number is not finite.
std::string encode_report(const Report& report);
std::string encode_report(const SpaceReport& report);

}  // namespace pcvt
