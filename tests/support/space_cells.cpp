#include "tests/support/space_cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pcvt::testing {
namespace {

using SpacePolygon = std::vector<space::Vec3>;

/// The cube [-r, r]^3.
ClippedCell cube(double r) {
    ClippedCell cell;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const space::Vec3 n = side * space::Vec3::Unit(axis);
            const space::Vec3 s = space::Vec3::Unit((axis + 1) % 3);
            const space::Vec3 t = n.cross(s);
            cell.faces.push_back(
                {r * (n - s - t), r * (n + s - t), r * (n + s + t), r * (n - s + t)});
        }
    }
    return cell;
}

/// Keeps the part where normal.p <= level, and closes the cut.
void clip(ClippedCell& cell, const space::Vec3& normal, double level) {
    std::vector<SpacePolygon> kept;
    SpacePolygon cut;
    for (const SpacePolygon& face : cell.faces) {
        SpacePolygon part;
        for (std::size_t k = 0; k < face.size(); ++k) {
            const space::Vec3& p = face[k];
            const space::Vec3& q = face[(k + 1) % face.size()];
            const double fp = normal.dot(p) - level;
            const double fq = normal.dot(q) - level;
            if (fp <= 0) part.push_back(p);
            if (fp == 0) cut.push_back(p);
            if ((fp < 0 && fq > 0) || (fp > 0 && fq < 0)) {
                part.push_back(p + fp / (fp - fq) * (q - p));
                cut.push_back(part.back());
            }
        }
        if (part.size() >= 3) kept.push_back(std::move(part));
    }
    cell.faces = std::move(kept);
    if (cut.size() < 3) return;
    // Order the points of the cut round their mean.
    space::Vec3 mean = space::Vec3::Zero();
    for (const space::Vec3& p : cut) mean += p / double(cut.size());
    const space::Vec3 s = normal.unitOrthogonal();
    const space::Vec3 t = normal.cross(s);
    std::sort(cut.begin(), cut.end(), [&](const space::Vec3& p, const space::Vec3& q) {
        return std::atan2(t.dot(p - mean), s.dot(p - mean)) <
               std::atan2(t.dot(q - mean), s.dot(q - mean));
    });
    cell.faces.push_back(std::move(cut));
}

/// Calls visit(volume, a, b, c) for tetrahedra between the origin and the faces.
template <class Visit>
void for_each_tetrahedron(const ClippedCell& cell, const Visit& visit) {
    for (const SpacePolygon& face : cell.faces) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            const space::Vec3& a = face[0];
            const space::Vec3& b = face[k];
            const space::Vec3& c = face[k + 1];
            visit(a.dot(b.cross(c)) / 6, a, b, c);
        }
    }
}

/// The coefficients of an image near a site.
struct NearImage {
    space::Vec3 at;
    /// The plane between the cells is at.p = level.
    double level;
};

}  // namespace

double ClippedCell::volume() const {
    double sum = 0;
    for_each_tetrahedron(*this, [&](double v, const space::Vec3&, const space::Vec3&,
                                    const space::Vec3&) { sum += v; });
    return sum;
}

double ClippedCell::second_moment() const {
    double sum = 0;
    for_each_tetrahedron(*this, [&](double v, const space::Vec3& a, const space::Vec3& b,
                                    const space::Vec3& c) {
        sum += v / 20 *
               (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + (a + b + c).squaredNorm());
    });
    return sum;
}

space::Vec3 ClippedCell::first_moment() const {
    space::Vec3 sum = space::Vec3::Zero();
    for_each_tetrahedron(*this, [&](double v, const space::Vec3& a, const space::Vec3& b,
                                    const space::Vec3& c) { sum += v / 4 * (a + b + c); });
    return sum;
}

ClippedCell clipped_power_cell(const space::Sites& sites, const Eigen::VectorXd& weights,
                               SiteId site) {
    const space::Lattice& reduced = sites.reduction().reduced;
    std::vector<NearImage> images;
    for (SiteId t = 0; t < sites.n_sites(); ++t) {
        for (int o = 0; o < 125; ++o) {
            const space::Vec3 offset(o / 25 - 2, o / 5 % 5 - 2, o % 5 - 2);
            if (t == site && offset.isZero()) continue;
            const space::Vec3 at = reduced.to_position(sites.coordinates().col(t) -
                                                       sites.coordinates().col(site) + offset);
            images.push_back({at, (at.squaredNorm() + weights[site] - weights[t]) / 2});
        }
    }
    std::sort(images.begin(), images.end(), [](const NearImage& p, const NearImage& q) {
        return p.level / p.at.norm() < q.level / q.at.norm();
    });
    ClippedCell cell = cube(2 * reduced.c().norm());
    for (const NearImage& image : images) {
        if (cell.faces.empty()) break;
        clip(cell, image.at, image.level);
    }
    return cell;
}

std::vector<ClippedCell> clipped_power_cells(const space::Sites& sites,
                                             const Eigen::VectorXd& weights) {
    std::vector<ClippedCell> cells;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        cells.push_back(clipped_power_cell(sites, weights, s));
    }
    return cells;
}

std::vector<ClippedCell> clipped_cells(const space::Sites& sites) {
    return clipped_power_cells(sites, Eigen::VectorXd::Zero(sites.n_sites()));
}

BruteForceEnergy brute_force_energy(const space::Sites& sites) {
    return brute_force_energy(sites, Eigen::VectorXd::Zero(sites.n_sites()));
}

BruteForceEnergy brute_force_energy(const space::Sites& sites, const Eigen::VectorXd& weights) {
    BruteForceEnergy energy;
    for (const ClippedCell& cell : clipped_power_cells(sites, weights)) {
        energy.value += cell.second_moment();
        energy.volumes.push_back(cell.volume());
        energy.gradient.push_back(-2 * cell.first_moment());
    }
    return energy;
}

}  // namespace pcvt::testing
