#include "plugin/cli/site_summary.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdio>

#include "mesher/plane/geometry/domain.hpp"
#include "plugin/cli/summary.hpp"

namespace pcvt::cli {
namespace {

/// Sites that are farther from the domain than this lie outside, in units of the period vectors.
constexpr double kDomainMargin = 1e-9;

/// So many sites in such a part of each period are hardly all that a user has of the domain.
constexpr int kFewestFractions = 4;
constexpr double kSmallPart = 0.25;

/// The number of sites outside of the domain.
Eigen::Index n_outside(const Eigen::ArrayXXd& periods) {
    return (periods < -kDomainMargin || periods > 1 + kDomainMargin).colwise().any().count();
}

/// A length in four digits, which are enough to see what a period should be.
std::string rough_length(double length) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", length);
    return text.data();
}

/// The period that sites need whose positions extend over more than the one that is given.
/// @param points  d x n, length units.
std::string wider_period(const Eigen::ArrayXXd& points, const std::string& unit) {
    std::string product;
    std::string sides;
    for (const double extent : points.rowwise().maxCoeff() - points.rowwise().minCoeff()) {
        product += (product.empty() ? "" : " x ") + rough_length(extent);
        sides += (sides.empty() ? "" : ",") + rough_length(extent);
    }
    return "; the positions extend over " + product + (unit.empty() ? "" : " " + unit) +
           ", which takes --period " + sides + " or larger, in the same unit";
}

/// What the positions of given sites say about the domain: how many lie outside of it, or that all
/// are fractional coordinates by their looks; empty where nothing is noteworthy.
/// @param points   d x n, length units; no column: no site was given.
/// @param given    the same in lattice coordinates, from the corner of the domain.
/// @param reduced  the same for the reduced vectors, in whose box pcvt writes sites. The domain is
///                 the box that holds more of them.
/// @param unit     of the points; empty if it is not known.
std::string domain_note(const Eigen::ArrayXXd& points, const Eigen::ArrayXXd& given,
                        const Eigen::ArrayXXd& reduced, const std::string& unit) {
    const auto n = points.cols();
    if (n == 0) return {};
    const Eigen::ArrayXXd& periods = n_outside(reduced) < n_outside(given) ? reduced : given;
    const Eigen::ArrayXd extent = periods.rowwise().maxCoeff() - periods.rowwise().minCoeff();
    if (const Eigen::Index outside = n_outside(periods); outside > 0) {
        std::string text = "; " + std::to_string(outside) +
                           " of the file lie outside of the domain and count modulo the "
                           "lattice";
        if (2 * outside <= n) return text;
        const bool is_wide = extent.maxCoeff() > 1 + kDomainMargin;
        text += ": --period or --lattice may be wrong";
        return is_wide ? text + wider_period(points, unit) : text;
    }
    const bool in_unit = points.minCoeff() >= 0 && points.maxCoeff() <= 1;
    if (n < kFewestFractions || !in_unit || extent.maxCoeff() > kSmallPart) return {};
    return "; all coordinates are from 0 to 1, a small part of the domain: they may be fractions "
           "of "
           "the periods";
}

template <class Lattice>
Eigen::ArrayXXd lattice_coordinates(const typename Lattice::Points& points, const Lattice& lattice,
                                    const typename Lattice::Point& corner) {
    Eigen::ArrayXXd coordinates(points.rows(), points.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        coordinates.col(s) = lattice.to_lattice(points.col(s) - corner);
    }
    return coordinates;
}

std::string site_note(const Job& job, const PlaneDomain& given) {
    const plane::Vec2& origin = given.origin;
    const plane::Domain domain(given.lattice, origin);
    return domain_note(
        given.points.array(), lattice_coordinates(given.points, given.lattice, origin),
        lattice_coordinates(given.points, domain.basis(), domain.corner()), job.site_unit);
}

std::string site_note(const Job& job, const SpaceDomain& given) {
    const space::Vec3& origin = given.origin;
    return domain_note(
        given.points.array(), lattice_coordinates(given.points, given.lattice, origin),
        lattice_coordinates(given.points, reduce(given.lattice).reduced, origin), job.site_unit);
}

/// The line that says which sites of a file were left out because they coincide with earlier ones.
/// @param n_kept  the number of the others, which asks for doubt where it is the smaller one.
std::string duplicates_line(const DroppedSites& dropped, Eigen::Index n_kept) {
    const auto n = static_cast<int>(dropped.sites.size());
    const std::string lines =
        coincidence_list(dropped.lines, [](int line) { return "line " + std::to_string(line); });
    const char* doubt = n > n_kept ? "; --period or --lattice may be wrong" : "";
    return summary_line(
        "duplicates", counted(n, "site") + " dropped" +
                          (n == 0 ? "" : ", which coincide modulo the lattice: " + lines + doubt));
}

/// Says that the header of the sites states a unit, which is that of the period too.
std::string unit_note(const Job& job) {
    if (job.site_unit.empty()) return {};
    const char* const names = job.is_in_space() ? "x, y, z" : "x, y";
    return std::string("; ") + names + " are in " + job.site_unit + ", and so is the period";
}

/// The lines of the sites and their periods.
template <class Domain>
std::string lines_of(const Job& job, int n_sites, const Domain& domain) {
    std::string text =
        summary_line("sites", std::to_string(n_sites) + unit_note(job) + site_note(job, domain));
    if (job.duplicates == Duplicates::kDrop) {
        text += duplicates_line(job.dropped, std::max(domain.points.cols(), domain.fixed.cols()));
    }
    return text + summary_line("lattice", vectors_text(domain.lattice.periods()));
}

}  // namespace

std::string site_lines(const Job& job, int n_sites) {
    return std::visit([&](const auto& domain) { return lines_of(job, n_sites, domain); },
                      job.domain);
}

}  // namespace pcvt::cli
