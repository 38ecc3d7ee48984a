#include "mesher/plane/interfaces/listed_images.hpp"

#include <gmock/gmock.h>

#include "mesher/plane/interfaces/inclusion_set.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

Inclusion image_of(Inclusion inclusion, const Vec2& translation, int line) {
    inclusion.shape = translated(inclusion.shape, translation);
    inclusion.line = line;
    return inclusion;
}

/// The lines of the shapes that remain of a list.
std::vector<int> lines_left(const std::vector<Inclusion>& listed, Walls walls = Walls::kNone,
                            const Lattice& domain = kSquare) {
    std::vector<int> lines;
    for (const Inclusion& kept : without_listed_images(domain, walls, listed)) {
        lines.push_back(kept.line);
    }
    return lines;
}

/// The lines of two shapes on the lines 1 and 2 that remain.
std::vector<int> lines_left_of(const Shape& first, const Shape& second) {
    return lines_left({{first, 1, 1}, {second, 1, 2}});
}

/// The shapes, each followed somewhere by 0 to 8 of its images on the lines from 100.
std::vector<Inclusion> with_random_images(const Lattice& lattice, std::vector<Inclusion> listed,
                                          std::mt19937_64& random) {
    std::uniform_int_distribution<int> whole(-3, 3);
    const std::vector<Inclusion> once = listed;
    for (const Inclusion& inclusion : once) {
        const int n_images = std::uniform_int_distribution<int>(0, 8)(random);
        for (int k = 0; k < n_images; ++k) {
            const Vec2 translation = lattice.translation({whole(random), whole(random)});
            const auto own = std::find_if(listed.begin(), listed.end(), [&](const Inclusion& i) {
                return i.line == inclusion.line;
            });
            const int first = static_cast<int>(own - listed.begin()) + 1;
            const int at = std::uniform_int_distribution<int>(first, int(listed.size()))(random);
            listed.insert(listed.begin() + at, image_of(inclusion, translation, 100 + k));
        }
    }
    return listed;
}

// Law (1).
TEST(ListedImages, AreLeftOutOnEveryLattice) {
    std::mt19937_64 random(1);
    int n_images = 0;
    for (int k = 0; k < 200; ++k) {
        const Lattice lattices[] = {kSquare, testing::kOblique, Lattice({1, 0}, {3.3, 1}),
                                    Lattice({0.3, 1.1}, {1, 0.2}), Lattice({2e5, 0}, {7e4, 1e5})};
        const Lattice& lattice = lattices[k % 5];
        const auto once = testing::random_inclusions(lattice, {6, 3, 0.4}, random);
        const auto listed = with_random_images(lattice, once, random);
        const auto kept = without_listed_images(lattice, Walls::kNone, listed);
        ASSERT_EQ(kept.size(), once.size()) << k;
        for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].line, once[i].line) << k;
        EXPECT_NO_THROW(InclusionSet(lattice, kept));
        n_images += static_cast<int>(listed.size() - once.size());
    }
    EXPECT_GT(n_images, 2000);
}

// Law (2).
TEST(ListedImages, AreThoseAlongWalls) {
    const Lattice channel = Lattice::rectangle(2, 1);
    std::vector<Inclusion> listed;
    for (const Vec2& t : {Vec2(0, 0), Vec2(2, 0), Vec2(-4, 0), Vec2(0, 1), Vec2(2, -2)}) {
        listed.push_back({Circle{Vec2(0.5, 0.5) + t, 0.2}, 1, int(listed.size()) + 1});
    }
    using ::testing::ElementsAre;
    EXPECT_THAT(lines_left(listed, Walls::kNone, channel), ElementsAre(1));
    EXPECT_THAT(lines_left(listed, Walls::kY, channel), ElementsAre(1, 4, 5));
    EXPECT_THAT(lines_left(listed, Walls::kX, channel), ElementsAre(1, 2, 3));
    EXPECT_THAT(lines_left(listed, Walls::kXY, channel), ElementsAre(1, 2, 3, 4, 5));
}

// Law (3).
TEST(ListedImages, HaveTheTagTheSizeAndTheKindOfTheirShape) {
    const Circle circle{{0, 0}, 0.2};
    EXPECT_EQ(lines_left({{circle, 1, 1}, {Circle{{1, 0}, 0.2}, 2, 2}}).size(), 2);
    EXPECT_EQ(lines_left_of(circle, Circle{{1, 0}, 0.2}).size(), 1);
    EXPECT_EQ(lines_left_of(circle, Circle{{1, 0}, 0.2 + 1e-10}).size(), 1);
    EXPECT_EQ(lines_left_of(circle, Circle{{1, 0}, 0.2 + 1e-9}).size(), 2);
    EXPECT_EQ(lines_left_of(circle, Circle{{1 - 1e-10, 1e-10}, 0.2}).size(), 1);
    EXPECT_EQ(lines_left_of(circle, Circle{{1, 1e-9}, 0.2}).size(), 2);
    EXPECT_EQ(lines_left_of(circle, Ellipse{{1, 0}, 0.2, 0.2, 0}).size(), 2);
}

TEST(ListedImages, OfEllipsesMayBeTurnedByHalfATurn) {
    const Ellipse ellipse{{0.1, 0.9}, 0.3, 0.1, 30};
    for (const auto& [other, n_left] : {std::pair{Ellipse{{1.1, 0.9}, 0.3, 0.1, 210}, 1},
                                        {Ellipse{{0.1, -0.1}, 0.3, 0.1, -150}, 1},
                                        {Ellipse{{0.1, -0.1}, 0.1, 0.3, 120}, 1},
                                        {Ellipse{{0.1, -0.1}, 0.3, 0.1, 30 + 1e-9}, 1},
                                        {Ellipse{{0.1, -0.1}, 0.3, 0.1, 30 + 1e-6}, 2},
                                        {Ellipse{{0.1, -0.1}, 0.3, 0.1, 120}, 2},
                                        {Ellipse{{0.1, -0.1}, 0.1, 0.3, 30}, 2},
                                        {Ellipse{{0.1, -0.1}, 0.3, 0.1 + 1e-8, 30}, 2}}) {
        EXPECT_EQ(lines_left_of(ellipse, other).size(), n_left) << other.degrees;
    }
}

TEST(ListedImages, OfPolygonsMayStartAtAnotherCorner) {
    const Polygon polygon{{0, 0}, {0.3, 0.1}, {0.2, 0.4}, {0, 0.3}};
    Polygon image;
    for (const Vec2& corner : polygon) image.push_back(corner + Vec2(-1, 2));
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(lines_left_of(polygon, image).size(), 1) << k;
        std::rotate(image.begin(), image.begin() + 1, image.end());
    }
    // The other order of the corners counts as another polygon.
    std::reverse(image.begin(), image.end());
    EXPECT_EQ(lines_left_of(polygon, image).size(), 2);
    // So does one with another corner, or with the corners out of order.
    EXPECT_EQ(lines_left_of(polygon, Polygon{{0, 0}, {0.3, 0.1}, {0.2, 0.4}}).size(), 2);
    EXPECT_EQ(lines_left_of(polygon, Polygon{{0, 0}, {0.3, 0.1}, {0, 0.3}, {0.2, 0.4}}).size(), 2);
}

TEST(ListedImages, OfShapesWithoutAPlaceRemain) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Shape& shape : {Shape(Circle{{nan, 0.5}, 0.2}), Shape(Circle{{0, 0}, nan}),
                               Shape(Circle{{0, 0}, 1e300}), Shape(Circle{{0, 0}, -1}),
                               Shape(Circle{{1e12, 0}, 0.2}), Shape(Ellipse{{0, 0}, 0.2, 0.1, nan}),
                               Shape(Polygon{}), Shape(Polygon{{nan, 0}, {0, 1}, {1, 0}})}) {
        EXPECT_EQ(lines_left_of(shape, shape).size(), 2) << shape.index();
    }
}

TEST(ListedImages, AreNamedWhereTheyAreRefused) {
    const Inclusion first{Ellipse{{0, 0.5}, 0.2, 0.1, 30}, 1, 3};
    const std::vector<std::pair<Inclusion, std::string>> cases{
        {{Ellipse{{2, -0.5}, 0.2, 0.1, 30}, 2, 7},
         "line 7: the shape is an image of that of line 3 with another tag; give both"},
        {{Ellipse{{2, -0.5}, 0.2, 0.1, 30}, 1, 7},
         "line 7: the shape is an image of that of line 3; remove one"},
        {{Ellipse{{1, 0.5}, 0.2, 0.11, 30}, 1, 7},
         "line 7: the shape lies on an image of that of line 3 but differs from it in size or"},
        {{Ellipse{{0, 0.5}, 0.2, 0.11, 30}, 1, 7},
         "line 7: the shape overlaps that of line 3; move one"},
        {{Ellipse{{1.1, 0.5}, 0.2, 0.1, 30}, 1, 7},
         "line 7: the shape overlaps that of line 3; move one"},
    };
    for (const auto& [bad, message] : cases) {
        try {
            const InclusionSet set(kSquare, {first, bad});
            ADD_FAILURE() << "accepted: " << message;
        } catch (const InvalidInput& error) {
            EXPECT_THAT(error.what(), ::testing::StartsWith(message));
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
