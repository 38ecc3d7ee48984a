#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/xml_scanner.hpp"
#include "mesher/plane/voxels/voxel_proof.hpp"
#include "mesher/space/voxels/voxel_proof.hpp"

namespace pcvt {

/// The arrays of the field data of a voxel image that hold the sites of its cells:
/// PeriodicLattice and SitePositions, with two or three numbers a tuple, and where they differ from
/// the default, SiteWeights and Metric.
///
/// Example usage:
///     CellFields fields;
///     if (fields.begin(scanner)) fields.end(text_of_the_array);
///     if (!fields.empty()) file.cells = fields.cells(scanner.name());
class CellFields {
   public:
    /// Records the type and the size that the tag of an array states.
    /// @returns false if it is another array, or not in text form; it has no end() then.
    /// @throws BadFile if they are not those of its kind.
    bool begin(const XmlScanner& scanner);
    /// The text of the array that began last; it must outlive this object.
    void end(std::string_view text) { last_->text = text; }

    bool empty() const { return fields_.empty(); }
    /// Whether the sites have three coordinates.
    bool are_in_space() const;
    /// @param file  its name in messages.
    /// @pre are_in_space() for the second.
    /// @throws BadFile if an array is missing, or has not the numbers that its tag states.
    plane::VoxelCells cells(const std::string& file) const;
    space::VoxelCells cells_in_space(const std::string& file) const;

   private:
    struct Field {
        int line;
        /// As its tag states them.
        double width;
        double n_numbers;
        std::string_view text;
    };
    /// The numbers of all arrays, those of some may be missing.
    struct Numbers {
        std::vector<double> lattice;
        std::vector<double> sites;
        std::vector<double> weights;
        std::vector<double> metric;
    };
    Numbers all_numbers(const std::string& file, std::size_t dimension) const;
    std::vector<double> numbers(const std::string& file, const std::string& name) const;
    [[noreturn]] void refuse(const std::string& file, const std::string& name,
                             const std::string& complaint) const;

    std::map<std::string, Field> fields_;
    Field* last_ = nullptr;
};

/// The number that an attribute of the current tag states; `nullopt` if it is missing.
/// @throws BadFile if it is not a number.
std::optional<double> number_attribute(const XmlScanner& scanner, std::string_view key);

/// The words of a text, between blanks and line feeds.
std::vector<std::string_view> words_of(std::string_view text);

}  // namespace pcvt
