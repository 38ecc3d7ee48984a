#include "mesher/space/mesh/tile_ties.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

/// Three hundred times as many as any tile needed.
constexpr int kMostMoves = 10000;
/// Where no move is an improvement, three of ten are drawn from all moves.
constexpr int kTen = 10;
constexpr int kOfBest = 7;
/// Tetrahedra by which neighbours of a moved one must be joined; most need less than 20.
constexpr std::size_t kMostBetween = 300;

/// Tetrahedra that move together, rising, and their translation in the reduced basis.
struct Move {
    std::vector<int> tetrahedra;
    Offset translation;

    friend bool operator<(const Move& one, const Move& other) {
        return std::tie(one.tetrahedra, one.translation) <
               std::tie(other.tetrahedra, other.translation);
    }
    bool contains(int t) const {
        return std::binary_search(tetrahedra.begin(), tetrahedra.end(), t);
    }
};

class TileTies {
   public:
    TileTies(const PeriodicDelaunay& delaunay, std::vector<Offset> frames)
        : tetrahedra_(delaunay.tetrahedra),
          reduction_(delaunay.sites.reduction()),
          frames_(std::move(frames)) {
        list_corners();
        for (SiteId s = 0; s < tetrahedra_.n_sites(); ++s) {
            checkpoint_each(s);
            note(s);
        }
    }

    std::vector<Offset> tie() {
        std::mt19937_64 random(1);
        for (int k = 0; k < kMostMoves && !open_.empty(); ++k) {
            checkpoint();
            const auto site = std::next(open_.begin(), long(random() % open_.size()));
            const Move move = chosen_move(*site, random);
            translate(move, move.translation);
            for (const SiteId s : sites_of(move)) note(s);
        }
        return std::move(frames_);
    }

   private:
    void list_corners() {
        begin_.assign(static_cast<std::size_t>(tetrahedra_.n_sites()) + 1, 0);
        for (const SiteId s : tetrahedra_.corner_sites()) ++begin_[s + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        corners_.resize(tetrahedra_.corner_sites().size());
        std::vector<int> place(begin_.begin(), begin_.end() - 1);
        for (int c = 0; c < tetrahedra_.n_facets(); ++c) {
            corners_[place[tetrahedra_.corner_sites()[c]]++] = c;
        }
    }

    std::span<const int> corners_at(SiteId s) const {
        return std::span(corners_).subspan(begin_[s], begin_[s + 1] - begin_[s]);
    }

    /// The translation from the tetrahedron of facet f to the image that would join it to the
    /// neighbour across f; zero where it is joined.
    Offset missing(int f) const {
        return frames_[tetrahedra_.opposite(f) / 4] - tetrahedra_.frame_across(f) - frames_[f / 4];
    }

    bool is_joined(int f) const { return missing(f) == Offset{}; }

    bool is_slave(int f) const { return reduction_.to_original(missing(f)) < Offset{}; }

    /// The offset of the point in which corner c lies.
    Offset image(int c) const { return tetrahedra_.corner(c).offset + frames_[c / 4]; }

    /// Whether a facet at corner c is a slave.
    bool is_tied(int c) const {
        const int first = c - c % 4;
        for (int f = first; f < first + 4; ++f) {
            if (f != c && is_slave(f)) return true;
        }
        return false;
    }

    /// The number of images of a site that lie on no slave, but for one.
    int n_untied(SiteId s) const {
        std::vector<std::pair<Offset, bool>> images;
        for (const int c : corners_at(s)) images.emplace_back(image(c), !is_tied(c));
        // The first of equal images is tied if one of them is.
        std::sort(images.begin(), images.end());
        int n = -1;
        for (std::size_t k = 0; k < images.size(); ++k) {
            if (k > 0 && images[k].first == images[k - 1].first) continue;
            n += images[k].second ? 1 : 0;
        }
        return n;
    }

    void note(SiteId s) {
        if (n_untied(s) > 0) {
            open_.insert(s);
        } else {
            open_.erase(s);
        }
    }

    /// The moves that join a tetrahedron at the site, or all that have one image of it as a corner,
    /// to a neighbour.
    std::set<Move> moves_at(SiteId s) const {
        std::map<Offset, std::set<int>> at_image;
        for (const int c : corners_at(s)) at_image[image(c)].insert(c / 4);
        std::set<Move> moves;
        for (const int c : corners_at(s)) {
            const std::set<int>& all = at_image.at(image(c));
            for (int f = c - c % 4; f < c - c % 4 + 4; ++f) {
                if (is_joined(f)) continue;
                moves.insert({{c / 4}, missing(f)});
                if (f != c) moves.insert({{all.begin(), all.end()}, missing(f)});
            }
        }
        return moves;
    }

    std::set<SiteId> sites_of(const Move& move) const {
        std::set<SiteId> sites;
        for (const int t : move.tetrahedra) {
            for (const Corner& corner : tetrahedra_.tetrahedron(t)) sites.insert(corner.site);
        }
        return sites;
    }

    void translate(const Move& move, Offset translation) {
        for (const int t : move.tetrahedra) frames_[t] = frames_[t] + translation;
    }

    int n_untied(const std::set<SiteId>& sites) const {
        return std::accumulate(sites.begin(), sites.end(), 0,
                               [this](int n, SiteId s) { return n + n_untied(s); });
    }

    /// The number of untied images that a move adds.
    int gain(const Move& move) {
        const std::set<SiteId> sites = sites_of(move);
        const int before = n_untied(sites);
        translate(move, move.translation);
        const int after = n_untied(sites);
        translate(move, -move.translation);
        return after - before;
    }

    /// Whether tetrahedra are joined to each other near the first, not through those of a move.
    bool are_joined_without(const Move& move, const std::set<int>& tetrahedra) const {
        if (tetrahedra.empty()) return true;
        std::vector<int> reached{*tetrahedra.begin()};
        std::set<int> seen{reached.front()};
        std::size_t n_found = 0;
        for (std::size_t k = 0; k < reached.size() && k < kMostBetween; ++k) {
            n_found += tetrahedra.count(reached[k]);
            if (n_found == tetrahedra.size()) return true;
            for (int f = 4 * reached[k]; f < 4 * reached[k] + 4; ++f) {
                const int t = tetrahedra_.opposite(f) / 4;
                if (!is_joined(f) || move.contains(t)) continue;
                if (seen.insert(t).second) reached.push_back(t);
            }
        }
        return false;
    }

    /// The neighbours to which the tetrahedra of a move are joined.
    std::set<int> joined_neighbours(const Move& move) const {
        std::set<int> neighbours;
        for (const int t : move.tetrahedra) {
            for (int f = 4 * t; f < 4 * t + 4; ++f) {
                const int other = tetrahedra_.opposite(f) / 4;
                if (is_joined(f) && !move.contains(other)) neighbours.insert(other);
            }
        }
        return neighbours;
    }

    /// Whether each tetrahedron of a move is joined to others, through some of the move.
    bool are_joined_to_others(const Move& move) const {
        std::set<int> joined;
        for (std::size_t n = move.tetrahedra.size() + 1; n != joined.size();) {
            n = joined.size();
            for (const int t : move.tetrahedra) {
                for (int f = 4 * t; f < 4 * t + 4; ++f) {
                    const int other = tetrahedra_.opposite(f) / 4;
                    if (!is_joined(f)) continue;
                    if (!move.contains(other) || joined.count(other) > 0) joined.insert(t);
                }
            }
        }
        return joined.size() == move.tetrahedra.size();
    }

    /// Whether the tile is connected after a move; also false where that would take a long search.
    bool keeps_connection(const Move& move) {
        if (!are_joined_without(move, joined_neighbours(move))) return false;
        translate(move, move.translation);
        const bool joined = are_joined_to_others(move);
        translate(move, -move.translation);
        return joined;
    }

    /// One of the best moves at a site; where none is an improvement, sometimes another one. Empty
    /// if there is none.
    Move chosen_move(SiteId s, std::mt19937_64& random) {
        std::vector<Move> possible;
        std::vector<Move> best;
        int least = std::numeric_limits<int>::max();
        for (const Move& move : moves_at(s)) {
            if (!keeps_connection(move)) continue;
            possible.push_back(move);
            const int n = gain(move);
            if (n < least) best.clear();
            least = std::min(least, n);
            if (n == least) best.push_back(move);
        }
        if (possible.empty()) return {};
        const bool from_best = least < 0 || random() % kTen < kOfBest;
        const std::vector<Move>& choices = from_best ? best : possible;
        return choices[random() % choices.size()];
    }

    const TorusTetrahedra& tetrahedra_;
    const Reduction& reduction_;
    std::vector<Offset> frames_;
    /// The corners at site s are corners_[begin_[s]] ... , by rising tetrahedron.
    std::vector<int> begin_;
    std::vector<int> corners_;
    /// The sites with untied images.
    std::set<SiteId> open_ = {};
};

}  // namespace

std::vector<Offset> tied_frames(const PeriodicDelaunay& delaunay, std::vector<Offset> frames) {
    return TileTies(delaunay, std::move(frames)).tie();
}

}  // namespace pcvt::space
