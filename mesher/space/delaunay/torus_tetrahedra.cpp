#include "mesher/space/delaunay/torus_tetrahedra.hpp"

#include <algorithm>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

std::int8_t narrow(int x) {
    const auto small = static_cast<std::int8_t>(x);
    if (small != x) throw InternalError("a tetrahedron spans more than 127 periods");
    return small;
}

/// An image in one number: its site, then the components of its offset, all non-negative.
std::uint64_t packed(const Corner& corner, Offset frame) {
    constexpr int kBits = 12;
    constexpr std::uint64_t kBias = 1U << (kBits - 1);
    const auto biased = [](int x) { return static_cast<std::uint64_t>(x) + kBias; };
    const Offset o = corner.offset + frame;
    return static_cast<std::uint64_t>(corner.site) << (3 * kBits) | biased(o.i) << (2 * kBits) |
           biased(o.j) << kBits | biased(o.k);
}

/// A facet as the sorted set of its images, and its number.
struct OpenFacet {
    std::array<std::uint64_t, 3> images;
    int number;
};

OpenFacet open_facet(const std::array<std::uint64_t, 4>& corners, int k, int number) {
    const auto& [i, j, m] = TorusTetrahedra::kFacetCorners[k];
    std::uint64_t a = corners[i];
    std::uint64_t b = corners[j];
    std::uint64_t c = corners[m];
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    return {{a, b, c}, number};
}

std::array<std::uint64_t, 4> packed(const Tetrahedron& t, Offset frame) {
    return {packed(t[0], frame), packed(t[1], frame), packed(t[2], frame), packed(t[3], frame)};
}

/// Facets of a few tetrahedra that wait for their other side.
class OpenFacets {
   public:
    bool empty() const { return n_ == 0; }
    void add(const OpenFacet& facet) { facets_[n_++] = facet; }
    /// Removes the facet with these images and returns its number, or -1.
    int take(const OpenFacet& facet) {
        for (int k = 0; k < n_; ++k) {
            if (facets_[k].images != facet.images) continue;
            const int number = facets_[k].number;
            facets_[k] = facets_[--n_];
            return number;
        }
        return -1;
    }

   private:
    std::array<OpenFacet, std::size_t{4} * TorusTetrahedra::kMostReplaced> facets_;
    int n_ = 0;
};

/// Facets that become opposite to each other.
struct FacetLinks {
    std::array<std::pair<int, int>, std::size_t{4} * TorusTetrahedra::kMostReplaced> pairs;
    std::size_t n = 0;

    void add(int facet, int other) { pairs[n++] = {facet, other}; }
};

/// Links the facets of new tetrahedra, with these numbers, to each other and to the facets beyond
/// the outer facets of the old ones.
FacetLinks links_of(std::span<const Tetrahedron> fresh, std::span<const int> numbers,
                    OpenFacets outer, const std::vector<int>& opposite) {
    FacetLinks links;
    FacetLinks renumbered;
    OpenFacets open;
    for (std::size_t t = 0; t < fresh.size(); ++t) {
        const auto corners = packed(fresh[t], {});
        for (int k = 0; k < 4; ++k) {
            const OpenFacet facet = open_facet(corners, k, 4 * numbers[t] + k);
            if (const int before = outer.take(facet); before >= 0) {
                renumbered.add(before, facet.number);
            } else if (const int other = open.take(facet); other >= 0) {
                links.add(facet.number, other);
            } else {
                open.add(facet);
            }
        }
    }
    if (!outer.empty() || !open.empty()) {
        throw InternalError("new tetrahedra do not fill the place of the old ones");
    }
    // For few sites an outer facet may lie beyond another.
    for (std::size_t k = 0; k < renumbered.n; ++k) {
        int beyond = opposite[renumbered.pairs[k].first];
        for (std::size_t m = 0; m < renumbered.n; ++m) {
            if (renumbered.pairs[m].first == beyond) {
                beyond = renumbered.pairs[m].second;
                break;
            }
        }
        links.add(renumbered.pairs[k].second, beyond);
    }
    return links;
}

/// A facet as all its translates have it: sorted, and relative to its first corner.
using FacetKey = std::array<Corner, 3>;

FacetKey key_of(const std::vector<Tetrahedron>& tetrahedra, int f) {
    const Tetrahedron& t = tetrahedra[f / 4];
    const auto& corners = TorusTetrahedra::kFacetCorners[f % 4];
    FacetKey key{t[corners[0]], t[corners[1]], t[corners[2]]};
    std::sort(key.begin(), key.end());
    const Offset first = key[0].offset;
    for (Corner& corner : key) corner.offset = corner.offset - first;
    return key;
}

/// The smallest site of a facet.
SiteId first_site(const std::vector<Tetrahedron>& tetrahedra, int f) {
    const Tetrahedron& t = tetrahedra[f / 4];
    const auto& corners = TorusTetrahedra::kFacetCorners[f % 4];
    return std::min({t[corners[0]].site, t[corners[1]].site, t[corners[2]].site});
}

/// Writes the least corner first and the least of the others second; the orientation stays.
void put_in_order(Tetrahedron& t) {
    const auto least = std::min_element(t.begin(), t.end()) - t.begin();
    if (least != 0) {
        // Two exchanges keep the orientation.
        std::swap(t[0], t[least]);
        std::swap(t[least % 3 + 1], t[(least + 1) % 3 + 1]);
    }
    std::rotate(t.begin() + 1, std::min_element(t.begin() + 1, t.end()), t.end());
}

}  // namespace

void put_in_canonical_order(int n_sites, std::vector<Tetrahedron>& tetrahedra) {
    for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        Tetrahedron& t = tetrahedra[k];
        put_in_order(t);
        const Offset first = t[0].offset;
        for (Corner& corner : t) corner.offset = corner.offset - first;
    }
    bucket_sort(tetrahedra, n_sites, [](const Tetrahedron& t) { return t[0].site; });
}

std::optional<std::vector<int>> match_facets(int n_sites,
                                             const std::vector<Tetrahedron>& tetrahedra) {
    const int n_facets = 4 * static_cast<int>(tetrahedra.size());
    std::vector<int> opposite(tetrahedra.size() * 4, -1);
    std::vector<std::pair<FacetKey, int>> bucket;
    bool complete = true;
    for_each_bucket(
        n_facets, n_sites, [&](int f) { return first_site(tetrahedra, f); },
        [&](std::span<const int> facets) {
            bucket.clear();
            for (const int f : facets) bucket.emplace_back(key_of(tetrahedra, f), f);
            std::sort(bucket.begin(), bucket.end());
            if (bucket.size() % 2 != 0) complete = false;
            for (std::size_t k = 0; k + 1 < bucket.size(); k += 2) {
                const bool alike = bucket[k].first == bucket[k + 1].first;
                const bool more = k + 2 < bucket.size() && bucket[k].first == bucket[k + 2].first;
                if (!alike || more) complete = false;
                opposite[bucket[k].second] = bucket[k + 1].second;
                opposite[bucket[k + 1].second] = bucket[k].second;
            }
        });
    if (!complete) return std::nullopt;
    return opposite;
}

TorusTetrahedra::TorusTetrahedra(int n_sites, const std::vector<Tetrahedron>& tetrahedra)
    : n_sites_(n_sites), sites_(4 * tetrahedra.size()), offsets_(tetrahedra.size()) {
    auto matched = match_facets(n_sites, tetrahedra);
    if (!matched) throw InternalError("a facet of the tetrahedra does not have two sides");
    opposite_ = std::move(*matched);
    for (int t = 0; t < n_tetrahedra(); ++t) set_tetrahedron(t, tetrahedra[t]);
}

TorusTetrahedra::TorusTetrahedra(int n_sites, std::vector<SiteId> corner_sites,
                                 std::vector<int> opposite, std::vector<TetrahedronOffsets> offsets)
    : n_sites_(n_sites),
      sites_(std::move(corner_sites)),
      opposite_(std::move(opposite)),
      offsets_(std::move(offsets)) {}

void TorusTetrahedra::set_tetrahedron(int t, const Tetrahedron& corners) {
    for (int k = 0; k < 4; ++k) sites_[4 * t + k] = corners[k].site;
    for (int k = 1; k < 4; ++k) {
        const Offset o = corners[k].offset - corners[0].offset;
        std::int8_t* const relative = &offsets_[t].relative[3 * (k - 1)];
        relative[0] = narrow(o.i);
        relative[1] = narrow(o.j);
        relative[2] = narrow(o.k);
    }
}

std::array<Corner, 3> TorusTetrahedra::facet(int f) const {
    const int first = f - f % 4;
    const auto& corners = kFacetCorners[f % 4];
    return {corner(first + corners[0]), corner(first + corners[1]), corner(first + corners[2])};
}

Offset TorusTetrahedra::frame_across(int f) const {
    const int o = opposite_[f];
    if (offsets_[f / 4].all_zero() && offsets_[o / 4].all_zero()) return {};
    // The neighbour has the facet in reversed order and begins at any of its corners; only the
    // offsets show at which, not the sites.
    const auto here = facet(f);
    const auto there = facet(o);
    for (int k = 0; k < 3; ++k) {
        const Offset frame = here[0].offset - there[k].offset;
        bool equal = true;
        for (int m = 0; m < 3; ++m) {
            const Corner& other = there[(k + 3 - m) % 3];
            equal = equal && here[m] == Corner{other.site, other.offset + frame};
        }
        if (equal) return frame;
    }
    throw InternalError("two linked facets of tetrahedra differ");
}

bool TorusTetrahedra::replace(std::span<const Placed> old, std::span<const Tetrahedron> fresh,
                              std::vector<int>& numbers) {
    numbers.clear();
    for (const Placed& placed : old) numbers.push_back(placed.number);
    std::sort(numbers.begin(), numbers.end());
    if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end()) return false;
    // Find the outer facets, with their numbers.
    OpenFacets outer;
    for (const Placed& placed : old) {
        const auto corners = packed(tetrahedron(placed.number), placed.frame);
        for (int k = 0; k < 4; ++k) {
            const OpenFacet facet = open_facet(corners, k, 4 * placed.number + k);
            if (outer.take(facet) < 0) outer.add(facet);
        }
    }
    while (numbers.size() < fresh.size()) {
        numbers.push_back(n_tetrahedra());
        offsets_.emplace_back();
        sites_.resize(sites_.size() + 4);
        opposite_.resize(opposite_.size() + 4, -1);
    }
    const FacetLinks links = links_of(fresh, numbers, outer, opposite_);
    for (std::size_t k = 0; k < links.n; ++k) link(links.pairs[k].first, links.pairs[k].second);
    for (std::size_t t = 0; t < fresh.size(); ++t) set_tetrahedron(numbers[t], fresh[t]);
    close_gaps(numbers, fresh.size());
    return true;
}

void TorusTetrahedra::close_gaps(std::vector<int>& numbers, std::size_t n_fresh) {
    // The last gap goes first, so that the tetrahedron moved is never a gap itself.
    std::array<int, kMostReplaced> gaps{};
    const auto n_gaps = static_cast<int>(numbers.size() - n_fresh);
    std::copy(numbers.begin() + std::ptrdiff_t(n_fresh), numbers.end(), gaps.begin());
    numbers.erase(numbers.begin() + std::ptrdiff_t(n_fresh), numbers.end());
    for (int k = n_gaps; k-- > 0;) {
        const int last = n_tetrahedra() - 1;
        move_last_to(gaps[k]);
        if (gaps[k] == last) continue;
        const auto moved = std::find(numbers.begin(), numbers.end(), last);
        if (moved == numbers.end()) {
            numbers.push_back(gaps[k]);
        } else {
            *moved = gaps[k];
        }
    }
}

void TorusTetrahedra::move_last_to(int t) {
    const int last = n_tetrahedra() - 1;
    for (int k = 0; k < 4 && t != last; ++k) {
        const int o = opposite_[4 * last + k];
        sites_[4 * t + k] = sites_[4 * last + k];
        link(4 * t + k, o / 4 == last ? 4 * t + o % 4 : o);
    }
    offsets_[t] = offsets_[last];
    offsets_.pop_back();
    sites_.erase(sites_.end() - 4, sites_.end());
    opposite_.erase(opposite_.end() - 4, opposite_.end());
}

void TorusTetrahedra::sort() {
    std::vector<int> order;
    order.reserve(offsets_.size());
    for_each_bucket(
        n_tetrahedra(), n_sites_,
        [&](int t) {
            const auto corners = corner_sites().subspan(4 * std::size_t(t), 4);
            return *std::min_element(corners.begin(), corners.end());
        },
        [&](std::span<const int> same) { order.insert(order.end(), same.begin(), same.end()); });
    std::vector<int> number(offsets_.size());
    for (int t = 0; t < n_tetrahedra(); ++t) number[order[t]] = t;
    std::vector<SiteId> sites(sites_.size());
    std::vector<int> opposite(opposite_.size());
    std::vector<TetrahedronOffsets> offsets(offsets_.size());
    for (int t = 0; t < n_tetrahedra(); ++t) {
        checkpoint_each(t);
        for (int k = 0; k < 4; ++k) {
            const int before = 4 * order[t] + k;
            sites[4 * t + k] = sites_[before];
            opposite[4 * t + k] = 4 * number[opposite_[before] / 4] + opposite_[before] % 4;
        }
        offsets[t] = offsets_[order[t]];
    }
    sites_ = std::move(sites);
    opposite_ = std::move(opposite);
    offsets_ = std::move(offsets);
}

void TorusTetrahedra::add_to_offsets(const std::vector<Offset>& change) {
    for (int t = 0; t < n_tetrahedra(); ++t) {
        checkpoint_each(t);
        Tetrahedron corners = tetrahedron(t);
        for (Corner& corner : corners) corner.offset = corner.offset + change[corner.site];
        set_tetrahedron(t, corners);
    }
}

void TorusTetrahedra::renumber_sites(const std::vector<SiteId>& number) {
    for (SiteId& site : sites_) site = number[site];
}

}  // namespace pcvt::space
