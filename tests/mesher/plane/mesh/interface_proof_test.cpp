#include "mesher/plane/mesh/interface_proof.hpp"

#include <gmock/gmock.h>

#include "mesher/plane/interfaces/empty_circles.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

/// Two circles, one of them across a corner of the domain, among sites outside of their circles.
class InterfaceProof : public ::testing::Test {
   protected:
    InterfaceProof() {
        const Lattice& reduced = set.reduction().reduced;
        const EmptyCircles circles(reduced, pairs.circles);
        std::vector<Vec2> all;
        for (const auto& u : pairs.coordinates.colwise()) all.push_back(u);
        const Points points = uniform_points(set.lattice(), 400, 1);
        for (const auto& p : points.colwise()) {
            const Vec2 u = reduced.to_lattice(p);
            if (circles.contain(u)) continue;
            all.emplace_back(wrap(u.x()).fraction, wrap(u.y()).fraction);
            inclusion.push_back(set.containing(p));
        }
        coordinates.resize(2, std::ssize(all));
        for (std::size_t k = 0; k < all.size(); ++k) coordinates.col(k) = all[k];
    }

    std::optional<std::string> violation() const {
        const PeriodicDelaunay delaunay(Sites(set.lattice(), set.reduction(), coordinates));
        return interface_violation(cell_mesh(delaunay), pairs, inclusion);
    }

    InclusionSet set{Lattice({1, 0}, {2.3, 1}),
                     {{Circle{{0, 0}, 0.25}, 1, 1}, {Circle{{0.5, 0.5}, 0.2}, 2, 2}}};
    InterfaceSites pairs = place_interface_sites(set, [](const Vec2&) { return 0.05; });
    std::vector<int> inclusion = pairs.inclusion;
    Points coordinates;
};

TEST_F(InterfaceProof, AcceptsWhatIsRight) { EXPECT_EQ(violation(), std::nullopt); }

// Law (1).
TEST_F(InterfaceProof, FindsASeedThatHasMoved) {
    coordinates(0, pairs.chords[3].inside) += 0x1p-26;
    EXPECT_THAT(violation().value_or(""), HasSubstr("is not an edge of the cells"));
}

TEST_F(InterfaceProof, FindsASiteInACircle) {
    const Vec2 at = pairs.circles[5].centre + Vec2(0x1p-10, 0x1p-11);
    coordinates.col(coordinates.cols() - 1) << wrap(at.x()).fraction, wrap(at.y()).fraction;
    EXPECT_THAT(violation().value_or(""), HasSubstr("is not an edge of the cells"));
}

TEST_F(InterfaceProof, FindsAWrongOffsetOfAChord) {
    pairs.chords[2].offset = pairs.chords[2].offset + Offset{1, 0};
    EXPECT_EQ(violation(), "chord 2 is not an edge of the cells");
}

TEST_F(InterfaceProof, FindsAWrongEndOfAChord) {
    pairs.chords[4].to += Vec2(1e-9, 0);
    EXPECT_EQ(violation(), "chord 4 is not an edge of the cells");
}

// Law (2).
TEST_F(InterfaceProof, FindsASiteOfAnotherMaterial) {
    inclusion.back() = inclusion.back() == 0 ? -1 : 0;
    EXPECT_THAT(violation().value_or(""), HasSubstr("lies between materials and is not a chord"));
}

TEST_F(InterfaceProof, FindsAChordInsideOfOneMaterial) {
    inclusion.assign(inclusion.size(), -1);
    EXPECT_THAT(violation().value_or(""), HasSubstr("is a chord inside of one material"));
}

// Law (3).
TEST_F(InterfaceProof, FindsAWrongArea) {
    pairs.polygons[1][0] += Vec2(1e-10, 0);
    EXPECT_EQ(violation(), "the cells of inclusion 1 do not have the area of its polygon");
}

}  // namespace
}  // namespace pcvt::plane
