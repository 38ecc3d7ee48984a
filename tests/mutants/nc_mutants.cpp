#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// The types of the values of a netCDF file.
constexpr int kChar = 2;
constexpr int kInt = 4;
constexpr int kDouble = 6;

std::size_t width_of_type(int type) { return type == kChar ? 1 : type == kDouble ? 8 : 4; }

std::string reversed(std::string bytes) {
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

template <class Number>
Number big_endian(const std::string& bytes, std::size_t at) {
    Number number{};
    const std::string little = reversed(bytes.substr(at, sizeof number));
    std::memcpy(&number, little.data(), sizeof number);
    return number;
}

template <class Number>
std::string big_endian_bytes(Number number) {
    return reversed({reinterpret_cast<const char*>(&number), sizeof number});
}

/// The values of one attribute or variable, or the length of one dimension.
struct Values {
    std::string name;
    int type;
    std::size_t at;
    std::size_t count;
};

/// Reads the header of a file in the 64-bit offset format, and lists all of its values.
class NetcdfHeader {
   public:
    explicit NetcdfHeader(const std::string& bytes) : bytes_(bytes) {}

    std::vector<Values> values() {
        at_ = kAfterRecords;
        for (std::uint32_t n = list_length(); n > 0; --n) {
            const std::string name = text();
            values_.push_back({"dimension " + name, kInt, at_, 1});
            lengths_.push_back(number());
        }
        read_attributes("");
        for (std::uint32_t n = list_length(); n > 0; --n) read_variable();
        return std::move(values_);
    }

   private:
    static constexpr std::size_t kAfterRecords = 8;

    std::uint32_t number() {
        at_ += 4;
        return big_endian<std::uint32_t>(bytes_, at_ - 4);
    }
    /// A list begins with its tag and its length.
    std::uint32_t list_length() {
        number();
        return number();
    }
    void skip(std::size_t n_bytes) { at_ += (n_bytes + 3) / 4 * 4; }
    std::string text() {
        const std::uint32_t length = number();
        const std::string name = bytes_.substr(at_, length);
        skip(length);
        return name;
    }

    void read_attributes(const std::string& owner) {
        for (std::uint32_t n = list_length(); n > 0; --n) {
            const std::string name = owner + "attribute " + text();
            const int type = static_cast<int>(number());
            const std::uint32_t count = number();
            values_.push_back({name, type, at_, count});
            skip(count * width_of_type(type));
        }
    }

    void read_variable() {
        const std::string name = text();
        std::size_t count = 1;
        for (std::uint32_t n = number(); n > 0; --n) count *= lengths_[number()];
        read_attributes(name + " ");
        const int type = static_cast<int>(number());
        number();
        const auto begin = big_endian<std::uint64_t>(bytes_, at_);
        at_ += sizeof begin;
        values_.push_back({name, type, begin, count});
    }

    const std::string& bytes_;
    std::size_t at_ = 0;
    std::vector<std::uint32_t> lengths_;
    std::vector<Values> values_;
};

/// A real number keeps a point, so that it changes as one.
std::string as_text(double number) {
    std::array<char, 64> text{};
    char* const end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    const std::string word(text.data(), end);
    return word.find_first_not_of("-0123456789") == std::string::npos ? word + ".0" : word;
}

Field field_of(const Files& files, const Values& values, std::size_t k) {
    const std::size_t at = values.at + k * width_of_type(values.type);
    const auto with_bytes_at = [&files, at](const std::string& value) {
        std::string bytes = files[0].bytes;
        return with_bytes(files, 0, bytes.replace(at, value.size(), value));
    };
    const std::string& bytes = files[0].bytes;
    if (values.type == kInt) {
        const auto number = big_endian<std::int32_t>(bytes, at);
        return {values.name + (number == 0 ? " unused" : ""), std::to_string(number),
                [with_bytes_at](const std::string& value) {
                    return with_bytes_at(big_endian_bytes(std::int32_t(std::stoll(value))));
                }};
    }
    if (values.type == kDouble) {
        return {values.name, as_text(big_endian<double>(bytes, at)),
                [with_bytes_at](const std::string& value) {
                    return with_bytes_at(big_endian_bytes(std::stod(value)));
                }};
    }
    // A character becomes another one.
    return {values.name, "letter",
            [with_bytes_at](const std::string&) { return with_bytes_at("?"); }};
}

}  // namespace

std::vector<Mutant> nc_mutants(const BaseFile& base) {
    std::vector<Field> fields;
    for (const Values& values : NetcdfHeader(base.files[0].bytes).values()) {
        for (std::size_t k = 0; k < values.count; ++k) {
            fields.push_back(field_of(base.files, values, k));
        }
    }
    std::vector<Mutant> mutants = mutants_of(fields, kDigit);
    const auto graph = [](const std::vector<std::string_view>& words) {
        LineNames names{.row = "graph row"};
        names.words.assign(words.size(), "graph");
        return names;
    };
    const std::vector<Mutant> of_graph = text_mutants(base.files, 1, graph, "", kDigit);
    mutants.insert(mutants.end(), of_graph.begin(), of_graph.end());
    return mutants;
}

std::span<const Harmless> harmless_in_nc() {
    static constexpr std::array kHarmless{
        Harmless{"dimension Time unused", "", "the number of records, of which there are none"},
        Harmless{"attribute mesh_spec", "", "the version of the format, which no model reads"},
        Harmless{"attribute history", "", "the options of the run, stated once"},
        Harmless{"edgesOnEdge unused", "-1", "an entry that no model reads is 0 or negative"},
        Harmless{"cellsOnCell unused", "-1", "an entry that no model reads is 0 or negative"},
        Harmless{"edgesOnCell unused", "-1", "an entry that no model reads is 0 or negative"},
        Harmless{"verticesOnCell unused", "-1", "an entry that no model reads is 0 or negative"},
        Harmless{"xCell", "+1", "one period farther lies the same point"},
        Harmless{"xCell", "-1", "one period farther lies the same point"},
        Harmless{"xEdge", "+1", "one period farther lies the same point"},
        Harmless{"xEdge", "-1", "one period farther lies the same point"},
        Harmless{"xVertex", "+1", "one period farther lies the same point"},
        Harmless{"xVertex", "-1", "one period farther lies the same point"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
