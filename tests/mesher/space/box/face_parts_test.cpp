#include "mesher/space/box/face_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace pcvt::space {
namespace {

/// The sides of the corners of a face without repetitions, from a first one on the plane if there
/// is any.
std::string pattern(const std::vector<SidedCorner>& face) {
    std::string sides;
    for (const SidedCorner& corner : face) sides += "-0+"[corner.side + 1];
    std::rotate(sides.begin(),
                sides.begin() + static_cast<long>(sides.find_first_not_of('0') % sides.size()),
                sides.end());
    std::rotate(sides.begin(), sides.begin() + static_cast<long>(sides.find('0') % sides.size()),
                sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    return sides;
}

/// All faces of n corners with one corner on the plane at least between two sides.
std::vector<std::vector<SidedCorner>> faces_of(int n) {
    std::vector<std::vector<SidedCorner>> faces{{}};
    for (int k = 0; k < n; ++k) {
        std::vector<std::vector<SidedCorner>> longer;
        for (const auto& face : faces) {
            for (const int side : {-1, 0, 1}) {
                longer.push_back(face);
                longer.back().push_back({{k, {}}, side});
            }
        }
        faces = std::move(longer);
    }
    std::erase_if(faces, [n](const auto& face) {
        for (int k = 0; k < n; ++k) {
            if (face[k].side * face[(k + 1) % n].side < 0) return true;
        }
        return false;
    });
    return faces;
}

/// Parts that are polygons of n corners in all have n - 2 triangles in all.
int n_triangles(const FaceParts& parts) {
    int n = 0;
    for (const auto* part : {&parts.below, &parts.inside, &parts.above}) {
        if (part->empty()) continue;
        EXPECT_GE(part->size(), 3U);
        EXPECT_TRUE(std::is_sorted(part->begin(), part->end()));
        n += static_cast<int>(part->size()) - 2;
    }
    return n;
}

TEST(FaceParts, FillEveryFaceThatAPlaneCutsAtMostTwice) {
    const std::set<std::string> sound{"0", "+", "-", "0+", "0-", "0+0-", "0-0+"};
    int n_flat = 0;
    for (int n = 3; n <= 7; ++n) {
        for (const auto& face : faces_of(n)) {
            for (const bool is_flat : {false, true}) {
                SCOPED_TRACE(pattern(face));
                const FaceParts parts = face_parts(face, [&](const auto&) { return is_flat; });
                EXPECT_EQ(parts.is_sound, sound.contains(pattern(face)));
                if (!parts.is_sound) continue;
                EXPECT_EQ(n_triangles(parts), n - 2);
                for (const VertexImage& v : parts.below) EXPECT_LE(face[v.vertex].side, 0);
                for (const VertexImage& v : parts.inside) EXPECT_EQ(face[v.vertex].side, 0);
                for (const VertexImage& v : parts.above) EXPECT_GE(face[v.vertex].side, 0);
                const auto n_on = std::count_if(face.begin(), face.end(),
                                                [](const auto& c) { return c.side == 0; });
                EXPECT_EQ(!parts.inside.empty(), n_on == n || (n_on > 2 && is_flat));
                n_flat += parts.inside.empty() ? 0 : 1;
            }
        }
    }
    EXPECT_GT(n_flat, 100);
}

}  // namespace
}  // namespace pcvt::space
