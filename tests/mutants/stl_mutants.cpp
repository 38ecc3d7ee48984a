#include <array>

#include "io/bytes/little_endian.hpp"
#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kHead = kHeader + 4;
constexpr std::size_t kFacet = 50;

void add(std::vector<Field>& fields, const BaseFile& base, std::size_t at, std::size_t n,
         Binary type, const std::vector<std::string>& names) {
    const auto more = binary_fields(base.files, 0, at, n, type, names);
    fields.insert(fields.end(), more.begin(), more.end());
}

/// The words of the header, as often as a blank ends one.
std::vector<Field> header_fields(const BaseFile& base) {
    std::vector<Field> fields;
    const std::string& bytes = base.files[0].bytes;
    for (std::size_t begin = 0; begin < kHeader;) {
        const std::size_t end = std::min(bytes.find(' ', begin), kHeader);
        if (end > begin) {
            const std::string name = fields.size() < 3 ? "form" : "periods";
            fields.push_back({name, bytes.substr(begin, end - begin),
                              [&base, begin, end](const std::string& value) {
                                  std::string all = base.files[0].bytes;
                                  std::string header = all.substr(0, kHeader);
                                  header.replace(begin, end - begin, value);
                                  header.resize(kHeader, ' ');
                                  return with_bytes(base.files, 0, header + all.substr(kHeader));
                              }});
        }
        begin = end + 1;
    }
    return fields;
}

/// Deletes or repeats each facet, or exchanges it with the next one.
std::vector<Mutant> facet_mutants(const BaseFile& base, std::size_t n) {
    const auto rows = [&base](std::size_t k, const std::string& facets, std::size_t n_replaced,
                              std::size_t count) {
        std::string bytes = base.files[0].bytes;
        bytes.replace(kHead + k * kFacet, n_replaced * kFacet, facets);
        std::string number;
        append_little_endian(number, count, 4);
        return with_bytes(base.files, 0, bytes.replace(kHeader, 4, number));
    };
    const auto facet = [&base](std::size_t k) {
        return base.files[0].bytes.substr(kHead + k * kFacet, kFacet);
    };
    std::vector<Mutant> mutants;
    for (std::size_t k = 0; k < n; ++k) {
        mutants.push_back({"facet row", "delete", [=] { return rows(k, "", 1, n - 1); }});
        mutants.push_back(
            {"facet row", "duplicate", [=] { return rows(k, facet(k) + facet(k), 1, n + 1); }});
        if (k + 1 == n) break;
        mutants.push_back(
            {"facet row", "swap", [=] { return rows(k, facet(k + 1) + facet(k), 2, n); }});
    }
    return mutants;
}

}  // namespace

std::vector<Mutant> stl_mutants(const BaseFile& base) {
    const std::string& bytes = base.files[0].bytes;
    const std::size_t n = (bytes.size() - kHead) / kFacet;
    std::vector<Field> fields = header_fields(base);
    add(fields, base, kHeader, 1, Binary::kUint32, {"count"});
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t at = kHead + k * kFacet;
        add(fields, base, at, 3, Binary::kFloat32, {"normal.x", "normal.y", "normal.z"});
        add(fields, base, at + 12, 9, Binary::kFloat32, {"corner.x", "corner.y", "corner.z"});
        add(fields, base, at + 48, 1, Binary::kUint16, {"attribute"});
    }
    std::vector<Mutant> mutants = mutants_of(fields, kDigit);
    const std::vector<Mutant> facets = facet_mutants(base, n);
    mutants.insert(mutants.end(), facets.begin(), facets.end());
    return mutants;
}

std::span<const Harmless> harmless_in_stl() {
    static constexpr std::array kHarmless{
        Harmless{"facet row", "swap", "facets have no order"},
        Harmless{"form", "", "a file of another program proves less"},
        Harmless{"periods", "", "another basis of the same lattice", "cells octahedra"},
        Harmless{"periods", "", "another basis of the same lattice", "boundary octahedra"},
        Harmless{"periods", "", "another basis of the same lattice", "cells left-handed"},
        Harmless{"periods", "", "another basis of the same lattice", "boundary left-handed"},
        Harmless{"periods", "word", "a header without nine numbers states no periods"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
