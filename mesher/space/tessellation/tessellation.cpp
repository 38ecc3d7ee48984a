#include "mesher/space/tessellation/tessellation.hpp"

#include <utility>

#include "mesher/space/mesh/cell_measures.hpp"

namespace pcvt::space {

CellComplex Tessellation::complex() const {
    {
        const std::lock_guard lock(cache_->mutex);
        if (auto complex = std::exchange(cache_->complex, std::nullopt)) return std::move(*complex);
    }
    return cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights);
}

const CellTable& Tessellation::table() const {
    const std::lock_guard lock(cache_->mutex);
    if (!cache_->table) {
        if (!cache_->complex)
            cache_->complex = cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights);
        cache_->table = cell_table(*cache_->complex);
    }
    return *cache_->table;
}

}  // namespace pcvt::space
