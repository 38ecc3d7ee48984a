#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

#include "mesher/space/delaunay/periodic_delaunay.hpp"

namespace pcvt::space {

/// Tetrahedra that were replaced by others which fill the same polyhedra.
struct ExchangedTetrahedra {
    std::vector<Tetrahedron> removed;
    std::vector<Tetrahedron> added;
};

/// Removes the tetrahedra that are in both lists from both, and sorts the lists.
void cancel_common(ExchangedTetrahedra& exchanged);

/// Bistellar flips on a triangulation of the 3-torus (B. Joe 1991): 2-3, 3-2, and 4-4 where four
/// corners are coplanar. A facet that is not locally Delaunay but cannot be flipped waits until the
/// flips of its neighbours put it into the queue again.
///
/// Example usage:
///
///     TetrahedraFlips flips(tetrahedra, coordinates, gram);
///     if (!flips.flip(suspects.facets)) rebuild();
class TetrahedraFlips {
   public:
    /// Receives the numbers of the tetrahedra that are new or have another number after a flip.
    using Observer = std::function<void(const std::vector<int>&)>;

    /// @param coordinates  3 x n, reduced basis; it and the triangulation must outlive this object.
    ///                     They may change between calls of flip().
    TetrahedraFlips(TorusTetrahedra& tetrahedra, const Points& coordinates, const Gram& gram,
                    Observer after_flip = {})
        : tetrahedra_(tetrahedra),
          coordinates_(coordinates),
          gram_(gram),
          after_flip_(std::move(after_flip)) {}
    virtual ~TetrahedraFlips() = default;
    TetrahedraFlips(const TetrahedraFlips&) = delete;
    TetrahedraFlips& operator=(const TetrahedraFlips&) = delete;

    /// Flips the suspects that are not locally Delaunay, then the facets that become suspects.
    /// Every tetrahedron must be positive, and remains so.
    /// @param facets  all facets that may not be locally Delaunay, besides those that an earlier
    ///                call could not mend.
    /// @returns false if facets remain that no flip can mend, or note_blocked() ended the flips.
    bool flip(const std::vector<int>& facets);
    /// The facets that the last call could not mend.
    std::size_t n_stuck() const { return queue_.size(); }
    std::int64_t n_flips() const { return n_flips_; }
    /// The tetrahedra that all flips so far replaced; this object forgets them.
    ExchangedTetrahedra take_exchanged() { return std::exchange(exchanged_, {}); }

   protected:
    const TorusTetrahedra& tetrahedra() const { return tetrahedra_; }
    const Points& coordinates() const { return coordinates_; }
    const Gram& gram() const { return gram_; }

   private:
    /// Whether a facet stays: here whether it is locally Delaunay.
    virtual bool stays(int facet) const;
    /// Called for a facet that does not stay, where the line between the two corners opposite to it
    /// passes its edges triangle[k], triangle[k + 1] on their outer sides, except the edge k =
    /// `inner`.
    /// @returns whether to go on with the other facets.
    virtual bool note_blocked(const std::array<Corner, 3>& triangle, int inner);

    enum class Outcome { kFlipped, kWaits, kEnd };
    Outcome try_flip(int facet);
    bool flip_edge(int facet, int edge, bool is_flat);
    /// The facet of a tetrahedron, placed in a frame, opposite to one of its corners.
    int facet_opposite_to(int tetrahedron, const Corner& corner, Offset frame) const;
    int turn(const Corner& p, const Corner& q, const Corner& r, const Corner& s) const;
    /// @param suspects  the facets of each new tetrahedron that may not stay.
    bool replace(std::initializer_list<TorusTetrahedra::Placed> old,
                 std::initializer_list<Tetrahedron> fresh, std::initializer_list<int> suspects);

    TorusTetrahedra& tetrahedra_;
    const Points& coordinates_;
    Gram gram_;
    Observer after_flip_;
    std::vector<int> queue_;
    /// The tetrahedra that the last flip changed.
    std::vector<int> changed_;
    ExchangedTetrahedra exchanged_;
    std::int64_t n_flips_ = 0;
};

}  // namespace pcvt::space
