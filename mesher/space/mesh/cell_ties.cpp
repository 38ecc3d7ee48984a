#include "mesher/space/mesh/cell_ties.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"

namespace pcvt::space {
namespace {

constexpr int kMostCellMoves = 1000;
/// Where no move is an improvement, three of ten are drawn from all moves.
constexpr int kAllChoices = 10;
constexpr int kBestChoices = 7;

class CellTies {
   public:
    CellTies(const CellComplex& complex, const Reduction& reduction, std::vector<Offset> images)
        : complex_(complex),
          reduction_(reduction),
          images_(std::move(images)),
          sides_(complex.vertices.size()),
          features_of_(complex.n_cells) {
        for (int f = 0; f < complex.n_faces(); ++f) {
            checkpoint_each(f);
            add_face(f);
        }
        for (int k = 0; k < static_cast<int>(sides_.size()); ++k) note(k);
    }

    std::vector<Offset> tie() {
        std::mt19937_64 random(1);
        for (int n = 0; n < kMostCellMoves && !untied_.empty(); ++n) {
            checkpoint();
            const auto feature = std::next(untied_.begin(), long(random() % untied_.size()));
            const auto [cell, translation] = chosen_move(*feature, random);
            translate(cell, translation);
            for (const int k : features_of_[cell]) note(k);
        }
        return std::move(images_);
    }

   private:
    /// A cell and its translation.
    using Move = std::pair<SiteId, Offset>;
    /// A vertex or an edge on a face of a cell: which image, in the frame of that cell.
    struct Side {
        SiteId cell;
        int face;
        Offset image;
    };
    using EdgeKey = std::tuple<int, int, Offset>;

    /// The features of a tile are the vertices and, behind these, the edges.
    void add_face(int f) {
        const std::span<const VertexImage> corners = complex_.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            VertexImage from = corners[k];
            VertexImage to = corners[(k + 1) % corners.size()];
            add_sides(f, from.vertex, from.offset);
            if (EdgeKey(to.vertex, from.vertex, from.offset - to.offset) <
                EdgeKey(from.vertex, to.vertex, to.offset - from.offset)) {
                std::swap(from, to);
            }
            const auto n = static_cast<int>(sides_.size());
            const EdgeKey key(from.vertex, to.vertex, to.offset - from.offset);
            const auto [edge, is_new] = edges_.try_emplace(key, n);
            if (is_new) sides_.emplace_back();
            add_sides(f, edge->second, from.offset);
        }
    }

    void add_sides(int f, int feature, const Offset& image) {
        const CellFace& face = complex_.faces[f];
        sides_[feature].push_back({face.cell, f, image});
        sides_[feature].push_back({face.neighbour, f, image - face.offset});
        features_of_[face.cell].insert(feature);
        features_of_[face.neighbour].insert(feature);
    }

    /// The translation of the neighbour that would join it to the cell across a face.
    Offset missing(int f) const {
        const CellFace& face = complex_.faces[f];
        return images_[face.cell] + face.offset - images_[face.neighbour];
    }

    /// Whether the tile has the face twice, and this side is the one at the larger offset.
    bool is_slave(const Side& side, std::size_t number) const {
        const Offset from_neighbour = missing(side.face);
        return reduction_.to_original(number % 2 == 0 ? from_neighbour : -from_neighbour) >
               Offset{};
    }

    /// The number of images of a feature that lie on no slave, but for one.
    int n_untied(int feature) const {
        std::map<Offset, bool> is_tied;
        const std::vector<Side>& sides = sides_[feature];
        for (std::size_t k = 0; k < sides.size(); ++k) {
            is_tied[sides[k].image + images_[sides[k].cell]] |= is_slave(sides[k], k);
        }
        const auto n = std::count_if(is_tied.begin(), is_tied.end(),
                                     [](const auto& image) { return !image.second; });
        return static_cast<int>(n) - 1;
    }

    void note(int feature) {
        if (n_untied(feature) > 0) {
            untied_.insert(feature);
        } else {
            untied_.erase(feature);
        }
    }

    void translate(SiteId cell, const Offset& translation) {
        images_[cell] = images_[cell] + translation;
    }

    int n_untied_at(SiteId cell) const {
        int n = 0;
        for (const int k : features_of_[cell]) n += n_untied(k);
        return n;
    }

    /// The moves that join a cell at a feature to a neighbour.
    std::set<Move> moves_at(int feature) const {
        std::set<Move> moves;
        for (const Side& side : sides_[feature]) {
            const Offset gap = missing(side.face);
            if (gap == Offset{}) continue;
            moves.insert({complex_.faces[side.face].neighbour, gap});
            moves.insert({complex_.faces[side.face].cell, -gap});
        }
        return moves;
    }

    bool is_connected() const {
        DisjointSets parts(complex_.n_cells);
        for (int f = 0; f < complex_.n_faces(); ++f) {
            const CellFace& face = complex_.faces[f];
            if (missing(f) == Offset{}) parts.unite(face.cell, face.neighbour);
        }
        for (int c = 0; c < complex_.n_cells; ++c) {
            if (parts.find(c) != 0) return false;
        }
        return true;
    }

    /// One of the best moves at a feature; where none is an improvement, sometimes another one. No
    /// translation if there is none.
    Move chosen_move(int feature, std::mt19937_64& random) {
        std::vector<Move> possible;
        std::vector<Move> best;
        int least = 0;
        for (const Move& move : moves_at(feature)) {
            const auto& [cell, translation] = move;
            const int before = n_untied_at(cell);
            translate(cell, translation);
            if (is_connected()) {
                possible.push_back(move);
                const int gain = n_untied_at(cell) - before;
                if (best.empty() || gain < least) {
                    best.clear();
                    least = gain;
                }
                if (gain == least) best.push_back(move);
            }
            translate(cell, -translation);
        }
        if (possible.empty()) return {};
        const bool from_best = least < 0 || random() % kAllChoices < kBestChoices;
        const std::vector<Move>& choices = from_best ? best : possible;
        return choices[random() % choices.size()];
    }

    const CellComplex& complex_;
    const Reduction& reduction_;
    std::vector<Offset> images_;
    std::map<EdgeKey, int> edges_;
    /// For each feature its sides, first that of a face's cell, then that of its neighbour.
    std::vector<std::vector<Side>> sides_;
    std::vector<std::set<int>> features_of_;
    std::set<int> untied_;
};

}  // namespace

std::vector<Offset> tied_images(const CellComplex& complex, const Reduction& reduction,
                                std::vector<Offset> images) {
    if (!complex.piece_cell.empty()) return images;
    return CellTies(complex, reduction, std::move(images)).tie();
}

}  // namespace pcvt::space
