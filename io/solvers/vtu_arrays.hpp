#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/file_fields.hpp"
#include "io/bytes/xml_scanner.hpp"
#include "io/forms/element_mesh.hpp"
#include "io/forms/lattice_numbers.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// A DataArray that a tile needs.
struct VtuArray {
    int line;
    std::string type;
    /// 1 if the file gives no number.
    int n_components = 1;
    std::vector<double> values = {};
    /// The line of each value.
    std::vector<int> lines = {};

    std::size_t size() const { return values.size(); }
    int integer(std::size_t k) const { return static_cast<int>(values[k]); }
    bool is_real() const { return type == "Float32" || type == "Float64"; }
};

/// The arrays of a VTU that encode_vtu() writes, by SECTION/NAME, and the counts of its piece.
///
/// Example usage:
///     const VtuArrays arrays(path, text);
///     const VtuArray& points = arrays.get("Points/Points", arrays.n_points(), 3, false);
class VtuArrays {
   public:
    /// @param further  SECTION/NAME of arrays that are read as well.
    /// @throws BadFile  the text is not a VTKFile with one piece of an UnstructuredGrid and arrays
    /// in
    ///         ASCII; an array is there twice.
    VtuArrays(const std::string& name, std::string_view text,
              std::span<const std::string_view> further = {});

    int n_points() const { return n_points_; }
    int n_cells() const { return n_cells_; }

    /// Returns an array; nullptr if the file lacks it.
    const VtuArray* find(const std::string& key) const;
    /// Returns an array of `n_tuples` tuples with `n_components` values each; `n_tuples` below 0
    /// permits any number of tuples.
    /// @throws BadFile  the file lacks it, or it has another size or type.
    const VtuArray& get(const std::string& key, int n_tuples, int n_components,
                        bool of_integers) const;

    const XmlScanner& scanner() const { return scanner_; }

   private:
    int count(std::string_view key) const;
    int integer(std::string_view word, int line) const;
    void read_piece();
    void read_array(const std::string& section, std::span<const std::string_view> further);
    void add_value(std::string_view word, int line, VtuArray& array) const;

    XmlScanner scanner_;
    std::map<std::string, VtuArray> arrays_;
    int n_points_ = -1;
    int n_cells_ = -1;
};

/// Returns the cells of a grid, which must be of one of some kinds. Polygons and polyhedra may have
/// any points.
/// @throws BadFile  another kind, or cells of two kinds; a wrong number of points; a point that
/// does
///         not exist.
ElementList read_vtu_cells(const VtuArrays& arrays, std::initializer_list<ElementKind> kinds);

/// Returns the lattice of a file.
/// @throws BadFile  there are not as many independent vectors as `Lattice` has.
template <class Lattice>
Lattice read_vtu_lattice(const VtuArrays& arrays) {
    constexpr int kSize = Lattice::kDimension;
    const VtuArray& periods = arrays.get("FieldData/PeriodicLattice", kSize, kSize, false);
    try {
        return lattice_from<Lattice>(periods.values);
    } catch (const InvalidInput& fault) {
        arrays.scanner().throw_bad_file(periods.line, fault.what());
    }
}

/// Returns the strings of an array that holds the codes of their characters, each ended by 0.
/// @throws BadFile  the array is missing, or holds another character.
std::vector<std::string> read_vtu_strings(const VtuArrays& arrays, const std::string& key);

/// Reads the names of phases from `PhaseNames`, and the phase of each site from another array.
/// @param n  the number of sites; -1: any.
/// @throws BadFile  an array is missing, a name is none of a phase, or a phase has no name.
void read_vtu_phases(const VtuArrays& arrays, const std::string& key, int n,
                     CellMaterials& materials);

/// Returns the fields of a VTU: the counts of its piece, and for each array that encode_vtu()
/// writes its type, the numbers of its components and tuples, and its values. The positions of
/// points are left out, because they are proved as those of the tile, and so are arrays of other
/// programs.
///
/// Example usage:
///     compare_fields(*vtu_fields(path, text), *vtu_fields(path, expected_text));
///
/// @throws BadFile  if the text is not XML.
std::optional<FileFields> vtu_fields(const std::string& name, std::string_view text);

}  // namespace pcvt
