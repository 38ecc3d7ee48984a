#include "io/tiles/kind_word.hpp"

namespace pcvt {

std::string kind_word(MeshKind kind) {
    switch (kind) {
        case MeshKind::kVoronoi:
            return "cells";
        case MeshKind::kDelaunay:
            return "triangles";
        case MeshKind::kGrains:
            return "grains";
    }
    return "";
}

std::optional<MeshKind> kind_of_word(std::string_view word) {
    for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
        if (word == kind_word(kind)) return kind;
    }
    return std::nullopt;
}

}  // namespace pcvt
