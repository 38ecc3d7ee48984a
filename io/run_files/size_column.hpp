#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/run_files/table_name.hpp"
#include "io/run_files/table_reader.hpp"

namespace pcvt {

/// The size of a cell that a column holds.
enum class SizeKind { kArea, kDiameter, kRadius, kVolume };

/// The words for a kind: the prefix of a file's name, and its plural for summaries.
struct SizeWords {
    SizeKind kind;
    std::string_view prefix;
    const char* plural;
};
const SizeWords& size_words(SizeKind kind);

/// Returns the kind of size that the header's name of a column states, such as "ECD", "Area" or
/// "EquivalentDiameters".
std::optional<SizeKind> stated_size(std::string_view column);

/// An option that takes a table of sizes.
struct SizeOption {
    /// "--areas".
    const char* option;
    /// The sizes of a column without a name, of which cells of its dimension have one.
    SizeKind plain;
    /// Sizes of cells of the other dimension, which are refused.
    SizeKind foreign;
    /// "cells in the plane have areas, not volumes".
    const char* why;
};
inline constexpr SizeOption kAreaOption{.option = "--areas",
                                        .plain = SizeKind::kArea,
                                        .foreign = SizeKind::kVolume,
                                        .why = "cells in the plane have areas, not volumes"};
inline constexpr SizeOption kVolumeOption{.option = "--volumes",
                                          .plain = SizeKind::kVolume,
                                          .foreign = SizeKind::kArea,
                                          .why = "cells in space have volumes, not areas"};

/// A column of sizes.
struct SizeColumn {
    std::size_t column = 0;
    SizeKind kind = SizeKind::kArea;
};

/// Finds the column of sizes of a table: the one that is named, else the only one of the header
/// whose name states a size, else the only one. Its name or the prefix of the file states the kind;
/// without a header, sizes are areas, or volumes.
///
/// Example usage:
///     const TableName name = parse_table_name("diameter:grains.csv:size", {"area", "diameter"});
///     TableScanner scanner(name.path, text);
///     const SizeColumn sizes = find_sizes(scanner, name);
///
/// @throws BadFile naming the line of the header and the remedy if no column or several ones
///         qualify, if the kind is not stated or is not one of the dimension, and if prefix and
///         header contradict each other.
SizeColumn find_sizes(TableScanner& scanner, const TableName& name,
                      const SizeOption& option = kAreaOption);

}  // namespace pcvt
