#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "io/gltf/plane_gltf.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using testing::kOblique;

/// The model that tinygltf's own loader finds in a file.
tinygltf::Model loaded(const EncodedFile& file, bool is_binary) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const auto size = static_cast<unsigned>(file.bytes.size());
    if (is_binary) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(file.bytes.data());
        EXPECT_TRUE(loader.LoadBinaryFromMemory(&model, &error, &warning, bytes, size)) << error;
    } else {
        EXPECT_TRUE(
            loader.LoadASCIIFromString(&model, &error, &warning, file.bytes.data(), size, ""))
            << error;
    }
    EXPECT_EQ(error + warning, "");
    return model;
}

/// Loads both containers, which must hold one model.
void expect_model(const plane::Tile& tile, std::size_t n_nodes) {
    const tinygltf::Model text = loaded(encode_gltf(tile, {}, "t.gltf").at(0), false);
    tinygltf::Model binary = loaded(encode_glb(tile, {}, "t.glb").at(0), true);
    ASSERT_EQ(text.buffers.size(), 1U);
    ASSERT_EQ(binary.buffers.size(), 1U);
    binary.buffers[0].uri = text.buffers[0].uri;
    EXPECT_EQ(text, binary);
    EXPECT_EQ(text.nodes.size(), n_nodes);
    EXPECT_TRUE(text.nodes.at(0).extras.Has("periodic"));
    const int positions = text.meshes.at(0).primitives.at(0).attributes.at("POSITION");
    EXPECT_EQ(text.accessors.at(positions).count, tile.points.size());
}

// TinyGLTF reads our text back as the structures that it was written from.
TEST(TinyGltf, LoadsTheCellsAndTrianglesOfBothContainers) {
    // The root, the cells and the outlines.
    expect_model(testing::grid_tile(kOblique, 4, 3), 4 * 3 + 2);
    expect_model(testing::triangle_grid_tile(kOblique, 4, 3), 3);
}

}  // namespace
}  // namespace pcvt
