#include "io/graphics/stl_file.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/little_endian.hpp"
#include "io/bytes/output_error.hpp"
#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/choices.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;
/// Facets that turn by more than 60 degrees do not show their surface.
constexpr double kLeastCosine = 0.5;
constexpr const char* kMark = "pcvt ";
constexpr const char* kPeriods = ", periods";

using Corners = std::array<Eigen::Vector3f, 3>;

void append_vector(std::string& bytes, const Eigen::Vector3f& vector) {
    for (const float x : vector) append_little_endian(bytes, std::bit_cast<std::uint32_t>(x), 4);
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(little_endian(std::string_view(bytes).substr(at, 4)));
}

/// Reads three floats; 0 in place of -0.
Eigen::Vector3f vector_at(const EncodedFile& file, std::size_t at) {
    Eigen::Vector3f vector;
    for (int k = 0; k < 3; ++k) {
        const auto x = std::bit_cast<float>(word_at(file.bytes, at + 4 * std::size_t(k)));
        if (!std::isfinite(x)) {
            throw BadFile(file.path + ": a number is not finite; write the file again");
        }
        vector[k] = x + 0.0F;
    }
    return vector;
}

Eigen::Vector3f rounded(const space::Vec3& point) {
    // 0 in place of -0.
    return point.cast<float>() + Eigen::Vector3f::Zero();
}

space::Vec3 area_vector(const space::Vec3& p, const space::Vec3& q, const space::Vec3& r) {
    return (q - p).cross(r - p);
}

std::string header_of(const ClosedSurfaces& surfaces) {
    const SurfaceFormRow* const row = find_row(
        kSurfaceForms, [&](const SurfaceFormRow& form) { return form.form == surfaces.form; });
    const std::string form = std::string(kMark) + row->word;
    std::string header = form + kPeriods;
    for (const space::Vec3& period : surfaces.lattice.periods()) {
        for (const double x : period) append_number(header += ' ', x);
    }
    return header.size() <= kHeaderBytes ? header : form;
}

/// Requires that single precision keeps the points apart and the triangles as they are turned.
void require_kept(const ClosedSurfaces& surfaces, const std::vector<StlFacet>& facets,
                  const std::string& path) {
    std::vector<char> is_used(surfaces.points.size(), 0);
    bool is_kept = true;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        const auto [a, b, c] = surfaces.triangles[k];
        for (const int v : {a, b, c}) is_used[v] = 1;
        const auto& points = surfaces.points;
        const space::Vec3 wanted = area_vector(points[a], points[b], points[c]);
        is_kept =
            is_kept && wanted.dot(facets[k].normal.cast<double>()) > kLeastCosine * wanted.norm();
    }
    std::set<std::array<float, 3>> places;
    std::size_t n_used = 0;
    for (std::size_t v = 0; v < is_used.size(); ++v) {
        if (is_used[v] == 0) continue;
        const Eigen::Vector3f place = rounded(surfaces.points[v]);
        places.insert({place.x(), place.y(), place.z()});
        ++n_used;
    }
    if (is_kept && places.size() == n_used) return;
    throw CoarsePrecision(path +
                          ": the single precision of STL would merge points or turn facets of this "
                          "tile; take an --origin nearer to 0, --short-edges, or a format of "
                          "double precision, such as .obj");
}

}  // namespace

Eigen::Vector3f stl_normal(const Corners& corners) {
    const space::Vec3 area = area_vector(corners[0].cast<double>(), corners[1].cast<double>(),
                                         corners[2].cast<double>());
    // Squares of small lengths may underflow.
    const double largest = area.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return Eigen::Vector3f::Zero();
    return rounded((area / largest).normalized());
}

std::vector<StlFacet> stl_facets(const ClosedSurfaces& surfaces) {
    std::vector<StlFacet> facets;
    facets.reserve(surfaces.triangles.size());
    for (const auto& [a, b, c] : surfaces.triangles) {
        const Corners corners{rounded(surfaces.points[a]), rounded(surfaces.points[b]),
                              rounded(surfaces.points[c])};
        facets.push_back({stl_normal(corners), corners});
    }
    return facets;
}

std::vector<EncodedFile> encode_stl(const StlFile& stl, const std::string& path) {
    std::string bytes = stl.header;
    bytes.resize(kHeaderBytes, ' ');
    append_little_endian(bytes, stl.facets.size(), 4);
    bytes.reserve(bytes.size() + kFacetBytes * stl.facets.size());
    for (const StlFacet& facet : stl.facets) {
        append_vector(bytes, facet.normal);
        for (const Eigen::Vector3f& corner : facet.corners) append_vector(bytes, corner);
        bytes.append(2, '\0');
    }
    return only_file(path, std::move(bytes));
}

std::vector<EncodedFile> encode_stl(const ClosedSurfaces& surfaces, const std::string& path) {
    StlFile stl{.header = header_of(surfaces), .facets = stl_facets(surfaces)};
    require_kept(surfaces, stl.facets, path);
    return encode_stl(stl, path);
}

StlFile decode_stl(const EncodedFile& file) {
    const std::string& bytes = file.bytes;
    const std::size_t head = kHeaderBytes + 4;
    const std::size_t n = bytes.size() < head ? 0 : word_at(bytes, kHeaderBytes);
    if (n == 0 || bytes.size() != head + kFacetBytes * n) {
        throw BadFile(file.path + (bytes.starts_with("solid")
                                       ? ": an STL in ASCII; export it as a binary STL"
                                       : ": not a whole binary STL; write the file again"));
    }
    StlFile stl{.header = bytes.substr(0, kHeaderBytes)};
    stl.header.erase(stl.header.find_last_not_of(std::string(" \0", 2)) + 1);
    stl.facets.reserve(n);
    for (std::size_t at = head; at < bytes.size(); at += kFacetBytes) {
        checkpoint_each(static_cast<long>(at / kFacetBytes));
        stl.facets.push_back(
            {vector_at(file, at),
             {vector_at(file, at + 12), vector_at(file, at + 24), vector_at(file, at + 36)}});
    }
    return stl;
}

std::optional<SurfaceForm> stl_form(const StlFile& stl) {
    for (const SurfaceFormRow& row : kSurfaceForms) {
        const std::string form = std::string(kMark) + row.word;
        if (stl.header == form || stl.header.starts_with(form + kPeriods)) return row.form;
    }
    return std::nullopt;
}

std::optional<space::Lattice> stl_lattice(const StlFile& stl) {
    const std::size_t at = stl.header.find(kPeriods);
    if (!stl_form(stl) || at == std::string::npos) return std::nullopt;
    LineScanner scanner("the header", std::string_view(stl.header).substr(at));
    scanner.next();
    // The words follow ", periods".
    if (scanner.words().size() != 11) return std::nullopt;
    try {
        Eigen::Matrix3d periods;
        for (int k = 0; k < 9; ++k) periods(k % 3, k / 3) = scanner.number(scanner.words()[k + 2]);
        return space::Lattice(periods.col(0), periods.col(1), periods.col(2));
    } catch (const InvalidInput&) {
        return std::nullopt;
    }
}

}  // namespace pcvt
