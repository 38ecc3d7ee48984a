#include "mesher/plane/mesh/outline.hpp"

#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/domain.hpp"

namespace pcvt::plane {
namespace {

/// In no experiment did a later round of trimming move a face.
constexpr int kTrimRounds = 8;

/// Faces placed so far: a disc in the plane, grown and trimmed face by face.
class Disc {
   public:
    explicit Disc(const PeriodicMesh& mesh) : mesh_(mesh), placed_(faces()), placement_(faces()) {}

    bool placed(int f) const { return placed_[f]; }
    bool contains(int f, Offset at) const { return placed_[f] && placement_[f] == at; }
    const std::vector<Offset>& placement() const { return placement_; }
    bool on_wall(int c) const { return mesh_.opposite[c] < 0; }
    /// @pre !on_wall(c)
    int face_across(int c) const { return mesh_.corner_face[mesh_.opposite[c]]; }
    /// Returns the place of the face across c if the face of c is placed at `at`.
    Offset offset_across(int c, Offset at) const { return at + mesh_.frame_across(c); }
    void place(int f, Offset at) {
        placed_[f] = true;
        placement_[f] = at;
    }
    void remove(int f) { placed_[f] = false; }

    /// Whether the disc stays a disc with face f at `at`: f must touch it along one path of edges
    /// and nowhere else.
    bool can_add(int f, Offset at) const {
        return is_one_path(
            f, [&](int c) { return across_in_disc(c, at); },
            [&](int c) { return star_of(c, at).in_disc > 0; });
    }
    /// Whether the disc stays a disc without face f: its boundary, of which walls are part, must
    /// run along one path of f's edges and touch f nowhere else.
    bool can_remove(int f) const {
        const Offset at = placement_[f];
        return is_one_path(
            f, [&](int c) { return !across_in_disc(c, at); },
            [&](int c) {
                const Star star = star_of(c, at);
                return star.in_disc < star.others || star.at_wall;
            });
    }

   private:
    std::size_t faces() const { return static_cast<std::size_t>(mesh_.n_faces()); }
    bool across_in_disc(int c, Offset at) const {
        return !on_wall(c) && contains(face_across(c), offset_across(c, at));
    }

    /// Counts of the faces around a corner, without the face of the corner itself.
    struct Star {
        int others = 0;
        int in_disc = 0;
        bool at_wall = false;
    };
    Star star_of(int c, Offset at) const {
        Star star;
        const auto count = [&](int corner, Offset there) {
            ++star.others;
            star.in_disc += contains(mesh_.corner_face[corner], there);
        };
        // Clockwise.
        int turning = c;
        Offset there = at;
        while (!on_wall(turning)) {
            there = offset_across(turning, there);
            turning = mesh_.next(mesh_.opposite[turning]);
            if (turning == c) return star;
            count(turning, there);
        }
        // At a wall the other faces follow counter-clockwise.
        star.at_wall = true;
        turning = c;
        there = at;
        for (int before = mesh_.previous(turning); !on_wall(before);
             before = mesh_.previous(turning)) {
            there = offset_across(before, there);
            turning = mesh_.opposite[before];
            count(turning, there);
        }
        return star;
    }

    /// Whether the marked edges of face f form one path and the marked corners are exactly the
    /// corners on it.
    template <class MarkedEdge, class MarkedCorner>
    bool is_one_path(int f, MarkedEdge marked_edge, MarkedCorner marked_corner) const {
        int edges = 0;
        int corners = 0;
        int path_ends = 0;
        bool previous = marked_edge(mesh_.face_begin[f + 1] - 1);
        for (int c = mesh_.face_begin[f]; c < mesh_.face_begin[f + 1]; ++c) {
            const bool here = marked_edge(c);
            edges += here;
            path_ends += here != previous;
            corners += marked_corner(c);
            previous = here;
        }
        return path_ends == 2 && corners == edges + 1;
    }

    const PeriodicMesh& mesh_;
    std::vector<char> placed_;
    std::vector<Offset> placement_;
};

/// The preferred place of each face, and the distances by which places are compared.
struct PreferredPlaces {
    Lattice lattice;
    Vec2 centre;                 ///< of the domain, length units
    std::vector<Vec2> centroid;  ///< of each face in its own frame
    std::vector<Offset> natural;

    double distance(int f, Offset at) const {
        return (centroid[f] + lattice.translation(at) - centre).squaredNorm();
    }
};

PreferredPlaces preferred_places(const PeriodicMesh& mesh, const Vec2& origin) {
    const Domain domain(mesh.lattice, origin);
    PreferredPlaces preferred{mesh.lattice, domain.centre(), {}, {}};
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        Vec2 sum(0, 0);
        for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            sum += mesh.vertices[mesh.corner_vertex[c]] +
                   mesh.lattice.translation(mesh.corner_offset[c]);
        }
        const Vec2 centroid = sum / (mesh.face_begin[f + 1] - mesh.face_begin[f]);
        preferred.centroid.push_back(centroid);
        preferred.natural.push_back(domain.offset_into(centroid));
    }
    return preferred;
}

/// A face that could be placed next. Natural places come first, then places near the centre.
struct Candidate {
    bool unnatural;
    double distance;
    int face;
    Offset at;
    friend bool operator>(const Candidate& c, const Candidate& d) {
        return std::tie(c.unnatural, c.distance, c.face, c.at) >
               std::tie(d.unnatural, d.distance, d.face, d.at);
    }
};

/// Candidates in order, none of them twice: each neighbour of a face that is placed proposes it.
class Candidates {
   public:
    explicit Candidates(const PreferredPlaces& preferred)
        : preferred_(preferred),
          waits_(preferred.natural.size(), 0),
          waits_at_(preferred.natural.size()) {}

    bool empty() const { return queue_.empty(); }
    void push(int face, Offset at) {
        if (waits_[face] != 0) {
            if (waits_at_[face] == at) return;
        } else {
            waits_[face] = 1;
            waits_at_[face] = at;
        }
        queue_.push({at != preferred_.natural[face], preferred_.distance(face, at), face, at});
    }
    Candidate pop() {
        const Candidate first = queue_.top();
        queue_.pop();
        if (waits_at_[first.face] == first.at) waits_[first.face] = 0;
        return first;
    }

   private:
    const PreferredPlaces& preferred_;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
    /// Whether a candidate of each face is in the queue, and where it would place the face. Another
    /// place of the same face may be in the queue as well.
    std::vector<char> waits_;
    std::vector<Offset> waits_at_;
};

int innermost_face(const PreferredPlaces& preferred) {
    int best = 0;
    for (int f = 1; f < static_cast<int>(preferred.natural.size()); ++f) {
        checkpoint_each(f);
        if (preferred.distance(f, preferred.natural[f]) <
            preferred.distance(best, preferred.natural[best])) {
            best = f;
        }
    }
    return best;
}

/// Places every face. A face that would close a ring is postponed until the queue is empty: the
/// ring encloses faces that are not placed yet, and the innermost of these always fits.
void grow(const PeriodicMesh& mesh, const PreferredPlaces& preferred, Disc& disc) {
    Candidates queue(preferred);
    std::vector<Candidate> put_off;
    int n_placed = 0;
    // Places a face and queues its neighbours.
    const auto place = [&](int f, Offset at) {
        disc.place(f, at);
        ++n_placed;
        for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            if (disc.on_wall(c)) continue;
            const int g = disc.face_across(c);
            const Offset there = disc.offset_across(c, at);
            if (!disc.placed(g)) queue.push(g, there);
        }
    };
    // Start from the face nearest to the centre.
    const int first = innermost_face(preferred);
    place(first, preferred.natural[first]);
    // Empty the queue, then try the postponed faces again.
    while (n_placed < mesh.n_faces()) {
        const int before = n_placed;
        while (!queue.empty()) {
            checkpoint();
            const Candidate candidate = queue.pop();
            if (disc.placed(candidate.face)) continue;
            if (disc.can_add(candidate.face, candidate.at)) {
                place(candidate.face, candidate.at);
            } else {
                put_off.push_back(candidate);
            }
        }
        if (n_placed == before) throw InternalError("the tile's outline could not be completed");
        for (const Candidate& candidate : put_off) queue.push(candidate.face, candidate.at);
        put_off.clear();
    }
}

/// Moves faces to their natural place if the disc remains a disc.
void trim(const PreferredPlaces& preferred, Disc& disc) {
    bool moved = true;
    for (int round = 0; moved && round < kTrimRounds; ++round) {
        moved = false;
        for (int f = 0; f < static_cast<int>(preferred.natural.size()); ++f) {
            checkpoint_each(f);
            const Offset at = disc.placement()[f];
            const Offset natural = preferred.natural[f];
            if (at == natural || !disc.can_remove(f)) continue;
            disc.remove(f);
            const bool fits = disc.can_add(f, natural);
            disc.place(f, fits ? natural : at);
            moved = moved || fits;
        }
    }
}

}  // namespace

std::vector<Offset> whole_outline(const PeriodicMesh& mesh, const Vec2& origin) {
    const PreferredPlaces preferred = preferred_places(mesh, origin);
    Disc disc(mesh);
    grow(mesh, preferred, disc);
    trim(preferred, disc);
    return disc.placement();
}

}  // namespace pcvt::plane
