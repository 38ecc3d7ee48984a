#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/colours/palette.hpp"
#include "io/gltf/gltf_container.hpp"
#include "io/gltf/gltf_surface.hpp"

namespace pcvt {

/// Requires that a buffer of this size can be counted.
/// @throws LimitExceeded naming the path.
void require_gltf_size(std::size_t n_bytes, const std::string& path);

/// Builds a glTF model; every returned number is an index into one of its tables.
class ModelBuilder {
   public:
    /// @param n_bytes      the approximate size of the data.
    /// @param translation  that of the node `tile`, length units.
    ModelBuilder(std::size_t n_bytes, const Eigen::Vector3d& translation);

    /// Adds an accessor with its own buffer view: rows of 1, 2 or 3 numbers.
    int add_floats(std::span<const float> numbers, std::size_t width);

    /// The same of one row per vertex.
    template <std::size_t kWidth>
    int add_vertex_data(const std::vector<std::array<float, kWidth>>& rows) {
        return add_floats({rows.data()->data(), kWidth * rows.size()}, kWidth);
    }

    int add_positions(const std::vector<Point3>& points);

    /// Adds accessors of ranges of `indices`, range k from begin[k] to begin[k + 1] - 1, in 16 bits
    /// if n_vertices permits. Returns the first accessor; the others follow it.
    int add_indices(const std::vector<int>& indices, const std::vector<int>& begin,
                    std::size_t n_vertices);

    int add_material(const std::string& name, Colour colour);
    /// Adds one that shows its colour in any light.
    int add_unlit_material(const std::string& name, Colour colour);

    /// Adds a child of the node `tile`.
    void add_node(const std::string& name, std::vector<tinygltf::Primitive> primitives);

    /// Returns the file of the model, with its buffer, which is moved away.
    /// @param periodic  the JSON of extras.periodic of the node `tile`.
    /// @throws LimitExceeded  as require_gltf_size().
    std::vector<EncodedFile> encode(const std::string& path, std::string_view periodic,
                                    GltfContainer container) &&;

   private:
    int add_view(const void* data, std::size_t size, int target);

    template <class Index>
    int add_index_view(const std::vector<int>& indices) {
        std::vector<Index> narrow;
        narrow.reserve(indices.size());
        for (const int index : indices) narrow.push_back(static_cast<Index>(index));
        return add_view(narrow.data(), narrow.size() * sizeof(Index),
                        TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    }

    int add_accessor(int view, std::size_t offset, int component_type, std::size_t count, int type);

    tinygltf::Model model_;
};

}  // namespace pcvt
