#include "mesher/space/tessellation/tessellation.hpp"

#include <utility>

#include "mesher/space/mesh/cell_measures.hpp"
#include "mesher/space/mesh/elongated_cells.hpp"

namespace pcvt::space {

CellComplex Tessellation::new_complex() const {
    CellComplex complex = cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights);
    if (!elongation) return complex;
    return from_round(std::move(complex), elongation->metric, elongation->sites);
}

CellComplex Tessellation::complex() const {
    {
        const std::lock_guard lock(cache_->mutex);
        if (auto complex = std::exchange(cache_->complex, std::nullopt)) return std::move(*complex);
    }
    return new_complex();
}

const CellTable& Tessellation::table() const {
    const std::lock_guard lock(cache_->mutex);
    if (!cache_->table) {
        if (!cache_->complex) cache_->complex = new_complex();
        cache_->table = cell_table(*cache_->complex);
    }
    return *cache_->table;
}

}  // namespace pcvt::space
