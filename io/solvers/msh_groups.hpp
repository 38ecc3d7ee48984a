#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/forms/numbered_items.hpp"
#include "io/solvers/msh_rows.hpp"

namespace pcvt {

/// A line of an MSH file, and the tag of its curve.
struct MshLine {
    int curve;
    int from;
    int to;
    /// The node in its middle; nothing for order 1.
    std::optional<int> middle;
    int line;
};

/// The physical groups of a file of pcvt.
///
/// Example usage:
///     groups.parse_names(rows);      // after $PhysicalNames
///     groups.parse_entities(rows);   // after $Entities
///     if (const auto fault = groups.fault(path, items, surfaces, lines)) throw BadFile(*fault);
class MshGroups {
   public:
    /// Parses a section up to its last row. @throws BadFile with the line.
    void parse_names(MshRows& rows);
    void parse_entities(MshRows& rows);

    /// Returns nothing if `cell_s` consists of the triangles whose "cell_id" is s, and
    /// `grain_boundary` of edges of two triangles, among them all edges between triangles of
    /// different cells; else the first fault, as `name:line: problem; remedy`. A file without
    /// groups of cells has no fault.
    /// @param surfaces  the tag of the surface of each triangle of `items`.
    std::optional<std::string> fault(const std::string& name, const NumberedItems& items,
                                     const std::vector<int>& surfaces,
                                     const std::vector<MshLine>& lines) const;

   private:
    /// Curves and surfaces.
    static constexpr int kDimensions = 2;

    const std::string& name_of(int dimension, int entity) const;
    std::optional<std::string> fault_of_cells(const NumberedItems& items,
                                              const std::vector<int>& surfaces) const;
    std::optional<std::string> fault_of_boundary(const NumberedItems& items,
                                                 const std::vector<MshLine>& lines) const;

    /// The name of each physical group and the group of each entity, by dimension - 1.
    std::array<std::map<int, std::string>, kDimensions> names_;
    std::array<std::map<int, int>, kDimensions> groups_;
    bool has_cells_ = false;
};

}  // namespace pcvt
