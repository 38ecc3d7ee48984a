#include "mesher/space/delaunay/tetrahedra_flips.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

/// Facets that could not be flipped are tried again after each pass.
constexpr int kPasses = 4;
/// A flip queues 16 facets or fewer; more flips than this for each suspect mean that they cycle.
constexpr std::int64_t kFlipsPerSuspect = 64;

}  // namespace

void cancel_common(ExchangedTetrahedra& exchanged) {
    auto& [one, other] = exchanged;
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    std::vector<Tetrahedron> only_one;
    std::vector<Tetrahedron> only_other;
    std::set_difference(one.begin(), one.end(), other.begin(), other.end(),
                        std::back_inserter(only_one));
    std::set_difference(other.begin(), other.end(), one.begin(), one.end(),
                        std::back_inserter(only_other));
    one = std::move(only_one);
    other = std::move(only_other);
}

int TetrahedraFlips::turn(const Corner& p, const Corner& q, const Corner& r,
                          const Corner& s) const {
    return orientation(image(coordinates_, p), image(coordinates_, q), image(coordinates_, r),
                       image(coordinates_, s));
}

bool TetrahedraFlips::flip(const std::vector<int>& facets) {
    queue_.insert(queue_.end(), facets.begin(), facets.end());
    const std::int64_t most =
        n_flips_ + kFlipsPerSuspect * (static_cast<std::int64_t>(facets.size()) + 16);
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<int> stuck;
        while (!queue_.empty()) {
            checkpoint();
            const int f = queue_.back();
            queue_.pop_back();
            if (f >= tetrahedra_.n_facets()) continue;
            if (stays(f)) continue;
            const Outcome outcome = try_flip(f);
            if (outcome == Outcome::kEnd) return false;
            if (outcome == Outcome::kWaits) stuck.push_back(f);
            if (n_flips_ > most) {
                queue_.insert(queue_.end(), stuck.begin(), stuck.end());
                return false;
            }
        }
        if (stuck.empty()) return true;
        queue_ = std::move(stuck);
    }
    std::erase_if(queue_, [this](int f) { return f >= tetrahedra_.n_facets() || stays(f); });
    return queue_.empty();
}

bool TetrahedraFlips::stays(int facet) const {
    return is_locally_delaunay(tetrahedra_, coordinates_, gram_, facet);
}

bool TetrahedraFlips::note_blocked(const std::array<Corner, 3>& /*triangle*/, int /*inner*/) {
    return true;
}

TetrahedraFlips::Outcome TetrahedraFlips::try_flip(int facet) {
    const std::array<Corner, 3> triangle = tetrahedra_.facet(facet);
    const Corner d = tetrahedra_.corner(facet);
    const Corner e = tetrahedra_.apex_across(facet);
    // On which side of each edge does the line from d to e pass?
    std::array<int, 3> side{};
    int n_positive = 0;
    int inner = 0;
    int other = 0;
    for (int k = 0; k < 3; ++k) {
        side[k] = turn(triangle[k], triangle[(k + 1) % 3], e, d);
        if (side[k] > 0) {
            ++n_positive;
            inner = k;
        } else {
            other = k;
        }
    }
    const auto outcome = [](bool flipped) { return flipped ? Outcome::kFlipped : Outcome::kWaits; };
    if (n_positive == 2) return outcome(flip_edge(facet, other, side[other] == 0));
    if (n_positive < 2) return note_blocked(triangle, inner) ? Outcome::kWaits : Outcome::kEnd;
    // 2-3: the line passes through the facet.
    const auto& [a, b, c] = triangle;
    return outcome(replace(
        {{facet / 4, {}}, {tetrahedra_.opposite(facet) / 4, tetrahedra_.frame_across(facet)}},
        {{a, b, e, d}, {b, c, e, d}, {c, a, e, d}}, {2, 3}));
}

/// 3-2, or 4-4 where the edge a b is coplanar with d and e.
bool TetrahedraFlips::flip_edge(int facet, int edge, bool is_flat) {
    const std::array<Corner, 3> triangle = tetrahedra_.facet(facet);
    const Corner a = triangle[edge];
    const Corner b = triangle[(edge + 1) % 3];
    const Corner c = triangle[(edge + 2) % 3];
    const Corner d = tetrahedra_.corner(facet);
    const Corner e = tetrahedra_.apex_across(facet);
    const int across = tetrahedra_.opposite(facet);
    const Offset frame = tetrahedra_.frame_across(facet);
    // The tetrahedra beyond a b d and a b e.
    const int above = facet_opposite_to(facet / 4, c, {});
    const int below = facet_opposite_to(across / 4, c, frame);
    const Corner x = tetrahedra_.apex_across(above);
    Corner y = tetrahedra_.apex_across(below);
    y.offset = y.offset + frame;
    const TorusTetrahedra::Placed beyond_above{tetrahedra_.opposite(above) / 4,
                                               tetrahedra_.frame_across(above)};
    if (!is_flat) {
        if (x != e) return false;
        return replace({{facet / 4, {}}, {across / 4, frame}, beyond_above},
                       {{c, d, e, b}, {d, c, e, a}}, {0, 1, 2});
    }
    if (x != y) return false;
    return replace({{facet / 4, {}},
                    {across / 4, frame},
                    beyond_above,
                    {tetrahedra_.opposite(below) / 4, tetrahedra_.frame_across(below) + frame}},
                   {{b, c, e, d}, {c, a, e, d}, {x, b, e, d}, {a, x, e, d}}, {0, 1, 2, 3});
}

int TetrahedraFlips::facet_opposite_to(int tetrahedron, const Corner& corner, Offset frame) const {
    for (int f = 4 * tetrahedron; f < 4 * tetrahedron + 3; ++f) {
        Corner other = tetrahedra_.corner(f);
        other.offset = other.offset + frame;
        if (other == corner) return f;
    }
    return 4 * tetrahedron + 3;
}

/// A facet between the new tetrahedra of five points stays because the old one did not.
bool TetrahedraFlips::replace(std::initializer_list<TorusTetrahedra::Placed> old,
                              std::initializer_list<Tetrahedron> fresh,
                              std::initializer_list<int> suspects) {
    for (const auto& [p, q, r, s] : fresh) {
        if (turn(p, q, r, s) <= 0) return false;
    }
    const std::size_t n_removed = exchanged_.removed.size();
    for (const auto& placed : old) {
        exchanged_.removed.push_back(tetrahedra_.tetrahedron(placed.number));
    }
    if (!tetrahedra_.replace({old.begin(), old.size()}, {fresh.begin(), fresh.size()}, changed_)) {
        exchanged_.removed.resize(n_removed);
        return false;
    }
    // Both lists of exchanged tetrahedra are in the frames of their first corners.
    for (Tetrahedron t : fresh) {
        const Offset frame = t[0].offset;
        for (Corner& corner : t) corner.offset = corner.offset - frame;
        exchanged_.added.push_back(t);
    }
    for (std::size_t k = 0; k < changed_.size(); ++k) {
        const int t = changed_[k];
        if (k < fresh.size()) {
            for (const int f : suspects) queue_.push_back(4 * t + f);
        } else {
            queue_.insert(queue_.end(), {4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3});
        }
    }
    ++n_flips_;
    if (after_flip_) after_flip_(changed_);
    return true;
}

}  // namespace pcvt::space
