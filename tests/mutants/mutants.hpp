#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"

namespace pcvt::testing {

using Files = std::vector<EncodedFile>;

/// Real numbers change by this much.
inline constexpr double kDigit = 1e-5;

/// One number or word of a file that a consumer reads.
struct Field {
    /// The same for all fields of one meaning: "v.x".
    std::string name;
    /// As text.
    std::string value;
    /// Returns the files with another value in this place.
    std::function<Files(const std::string&)> with;
};

/// The files with one change of one field.
struct Mutant {
    std::string field;
    /// "+1", "-1", "sign", "digit", "swap", "word"; of rows "delete", "duplicate", "swap".
    std::string change;
    std::function<Files()> files;
};

/// Returns the mutants of fields: integers change by 1, in sign, and with the next different value
/// of the same name; real numbers also by `digit`; words get another letter.
///
/// Example usage:
///   const std::vector<Mutant> mutants = mutants_of(fields, 1e-5);
///   for (const Mutant& mutant : mutants) EXPECT_NE(refusal(format, mutant.files()), "");
std::vector<Mutant> mutants_of(const std::vector<Field>& fields, double digit);

/// The meaning of one line of a text: the name of its row and of each of its words. An empty name
/// leaves a row or a word as it is.
struct LineNames {
    std::string row = {};
    std::vector<std::string> words = {};
    /// The words in front of a part of a list that goes on in the next row of this name; 0: the row
    /// does not belong to such a list.
    std::size_t n_before_part = 0;
};
using LineNamer = std::function<LineNames(const std::vector<std::string_view>& words)>;

/// The fields and the mutants of rows of a text that consists of lines.
struct TextParts {
    std::vector<Field> fields;
    std::vector<Mutant> rows;
};

/// Names the words of each line of files[file], which blanks separate and the characters of
/// `separators` too. Rows of one name are deleted, duplicated, and exchanged with the next one,
/// unless two parts of a list make up the same list in both orders.
/// @pre the files outlive the result.
TextParts text_parts(const Files& files, std::size_t file, const LineNamer& namer,
                     std::string_view separators = "");

/// Returns the mutants of the fields and rows of text_parts().
std::vector<Mutant> text_mutants(const Files& files, std::size_t file, const LineNamer& namer,
                                 std::string_view separators, double digit);

/// The types of numbers in binary files, little-endian.
enum class Binary { kUint8, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

std::size_t width_of(Binary type);

/// The numbers of files[file] from byte `at` on. names[k % names.size()] is that of number k.
/// @pre the files outlive the result.
std::vector<Field> binary_fields(const Files& files, std::size_t file, std::size_t at,
                                 std::size_t count, Binary type,
                                 const std::vector<std::string>& names);

/// Returns the files with other bytes in one of them.
Files with_bytes(const Files& files, std::size_t file, std::string bytes);

}  // namespace pcvt::testing
