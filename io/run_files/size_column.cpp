#include "io/run_files/size_column.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr std::array<SizeWords, 4> kSizes{{{SizeKind::kArea, "area", "areas"},
                                           {SizeKind::kDiameter, "diameter", "diameters"},
                                           {SizeKind::kRadius, "radius", "radii"},
                                           {SizeKind::kVolume, "volume", "volumes"}}};

/// A comparable name of a column, and the size that it states.
struct SizeName {
    std::string_view name;
    SizeKind kind;
};
constexpr std::array kSizeNames{SizeName{"area", SizeKind::kArea},
                                SizeName{"areas", SizeKind::kArea},
                                SizeName{"grainarea", SizeKind::kArea},
                                SizeName{"cellarea", SizeKind::kArea},
                                SizeName{"d", SizeKind::kDiameter},
                                SizeName{"ecd", SizeKind::kDiameter},
                                SizeName{"diam", SizeKind::kDiameter},
                                SizeName{"diameter", SizeKind::kDiameter},
                                SizeName{"diameters", SizeKind::kDiameter},
                                SizeName{"graindiameter", SizeKind::kDiameter},
                                SizeName{"celldiameter", SizeKind::kDiameter},
                                SizeName{"eqd", SizeKind::kDiameter},
                                SizeName{"eqdiam", SizeKind::kDiameter},
                                SizeName{"eqdiameter", SizeKind::kDiameter},
                                SizeName{"equivdiameter", SizeKind::kDiameter},
                                SizeName{"equivalentdiameter", SizeKind::kDiameter},
                                SizeName{"equivalentdiameters", SizeKind::kDiameter},
                                SizeName{"equivalentcirclediameter", SizeKind::kDiameter},
                                SizeName{"equivalentcirculardiameter", SizeKind::kDiameter},
                                SizeName{"circleequivalentdiameter", SizeKind::kDiameter},
                                SizeName{"r", SizeKind::kRadius},
                                SizeName{"radius", SizeKind::kRadius},
                                SizeName{"radii", SizeKind::kRadius},
                                SizeName{"equivalentradius", SizeKind::kRadius},
                                SizeName{"volume", SizeKind::kVolume},
                                SizeName{"volumes", SizeKind::kVolume},
                                SizeName{"grainvolume", SizeKind::kVolume},
                                SizeName{"cellvolume", SizeKind::kVolume},
                                SizeName{"esd", SizeKind::kDiameter},
                                SizeName{"equivalentspherediameter", SizeKind::kDiameter},
                                SizeName{"equivalentsphericaldiameter", SizeKind::kDiameter},
                                SizeName{"sphereequivalentdiameter", SizeKind::kDiameter}};
/// Parts of names that state a size if the name holds no other one, such as "Feret diameter". They
/// count only in columns that the user has named.
constexpr std::array kSizeParts{
    SizeName{"area", SizeKind::kArea}, SizeName{"diam", SizeKind::kDiameter},
    SizeName{"radius", SizeKind::kRadius}, SizeName{"volume", SizeKind::kVolume}};

std::optional<SizeKind> hinted_size(std::string_view column) {
    if (const std::optional<SizeKind> stated = stated_size(column)) return stated;
    const std::string name = comparable_name(column);
    std::optional<SizeKind> found;
    for (const SizeName& part : kSizeParts) {
        if (name.find(part.name) == std::string::npos) continue;
        if (found) return std::nullopt;
        found = part.kind;
    }
    return found;
}

/// Parts of names in other languages. They only make suggestions, which a user confirms.
struct ForeignSize {
    std::string_view begin;
    std::string_view later;
    const char* prefix;
};
constexpr std::array kForeignSizes{
    ForeignSize{"durchm", "", "diameter"},   ForeignSize{"di", "metr", "diameter"},
    ForeignSize{"diam", "", "diameter"},     ForeignSize{"fl", "che", "area"},
    ForeignSize{"aire", "", "area"},         ForeignSize{"superfic", "", "area"},
    ForeignSize{"rea", "", "area"},          ForeignSize{"radius", "", "radius"},
    ForeignSize{"halbmesser", "", "radius"}, ForeignSize{"rayon", "", "radius"},
    ForeignSize{"raggio", "", "radius"},     ForeignSize{"radio", "", "radius"}};

/// The prefix of a column that states its size, or that may do so in another language; empty for
/// others.
std::string suggested_prefix(std::string_view column, const SizeOption& option) {
    if (const std::optional<SizeKind> stated = stated_size(column)) {
        return *stated == option.foreign ? "" : std::string(size_words(*stated).prefix);
    }
    const std::string name = comparable_name(column);
    for (const ForeignSize& size : kForeignSizes) {
        const std::size_t begin = name.find(size.begin);
        if (begin == std::string::npos) continue;
        if (name.find(size.later, begin + size.begin.size()) == std::string::npos) continue;
        return size.prefix == size_words(option.foreign).prefix ? "" : size.prefix;
    }
    return {};
}

/// The options that a user may paste for the columns that seem to hold sizes; else for the last one
/// as either size.
/// @param has_foreign  whether a column holds sizes of the other dimension, which may be the last
/// one.
std::string suggested_options(const TableScanner& scanner, const TableName& name, bool has_foreign,
                              const SizeOption& option) {
    const std::string plain(size_words(option.plain).prefix);
    const std::string word = std::string(option.option) + " ";
    std::string text;
    const auto append = [&](const std::string& prefix, std::size_t column) {
        text +=
            (text.empty() ? "" : " or ") + word + with_columns(name, prefix, scanner.typed(column));
    };
    for (std::size_t k = 0; k < scanner.n_columns(); ++k) {
        const std::string prefix = suggested_prefix(scanner.header()[k].name, option);
        if (!prefix.empty()) append(prefix, k);
    }
    if (!text.empty()) return text;
    if (has_foreign) {
        return word + with_columns(name, plain, "COLUMN") + " or " + word +
               with_columns(name, "diameter", "COLUMN");
    }
    append(plain, scanner.n_columns() - 1);
    append("diameter", scanner.n_columns() - 1);
    return text;
}

std::optional<SizeKind> prefix_size(const std::string& prefix) {
    for (const SizeWords& words : kSizes) {
        if (words.prefix == prefix) return words.kind;
    }
    return std::nullopt;
}

/// The only column of the header that may hold the sizes.
std::size_t only_candidate(const TableScanner& scanner, const TableName& name,
                           const std::optional<SizeKind>& wanted, const SizeOption& option) {
    std::vector<std::size_t> found;
    bool has_foreign = false;
    for (std::size_t k = 0; k < scanner.n_columns(); ++k) {
        const std::optional<SizeKind> kind = stated_size(scanner.header()[k].name);
        if (!kind || (wanted && kind != wanted)) continue;
        has_foreign = has_foreign || kind == option.foreign;
        if (kind != option.foreign) found.push_back(k);
    }
    if (found.size() == 1) return found.front();
    if (found.empty() && scanner.n_columns() == 1) return 0;
    if (found.size() > 1) {
        const std::string first = scanner.typed(found[0]);
        scanner.refuse_header("both " + scanner.label(found[0]) + " and " +
                              scanner.label(found[1]) + " hold sizes; name one, such as " +
                              with_columns(name, name.prefix, first));
    }
    const std::string plain(size_words(option.plain).prefix);
    scanner.refuse_header(
        (has_foreign ? option.why : "no column is called " + plain + " or diameter") +
        "; name the column of sizes of " + scanner.listed_columns() + ": " +
        suggested_options(scanner, name, has_foreign, option));
}

/// The column that the name of the table gives; else with a header the only candidate, without one
/// the first.
std::size_t chosen_column(TableScanner& scanner, const TableName& name,
                          const std::optional<SizeKind>& wanted, const SizeOption& option) {
    if (!name.columns.empty()) return scanner.choose(name.columns).front();
    return scanner.has_header() ? only_candidate(scanner, name, wanted, option) : 0;
}

[[noreturn]] void refuse_unstated(const TableScanner& scanner, const TableName& name,
                                  std::size_t column, const SizeOption& option) {
    const std::string text = name.columns.empty() ? "" : name.columns.front();
    const SizeWords& plain = size_words(option.plain);
    const std::string word = std::string(option.option) + " ";
    scanner.refuse_header(scanner.label(column) + " may hold " + plain.plural +
                          " or diameters; write " + word +
                          with_columns(name, std::string(plain.prefix), text) + " or " + word +
                          with_columns(name, "diameter", text) + scanner.title_remedy());
}

}  // namespace

const SizeWords& size_words(SizeKind kind) {
    return *std::find_if(kSizes.begin(), kSizes.end(),
                         [&](const SizeWords& words) { return words.kind == kind; });
}

std::optional<SizeKind> stated_size(std::string_view column) {
    const std::string name = comparable_name(column);
    for (const SizeName& size : kSizeNames) {
        if (size.name == name) return size.kind;
    }
    return std::nullopt;
}

SizeColumn find_sizes(TableScanner& scanner, const TableName& name, const SizeOption& option) {
    if (name.columns.size() > 1) {
        scanner.refuse_header("sizes are one column, not " + std::to_string(name.columns.size()) +
                              "; write " + with_columns(name, name.prefix, name.columns.front()));
    }
    const std::optional<SizeKind> wanted = prefix_size(name.prefix);
    const std::size_t column = chosen_column(scanner, name, wanted, option);
    if (!scanner.has_header()) return {column, wanted.value_or(option.plain)};
    const std::optional<SizeKind> stated = hinted_size(scanner.header()[column].name);
    if (wanted && stated && wanted != stated) {
        scanner.refuse_header(scanner.label(column) + " holds " + size_words(*stated).plural +
                              ", but the file is given as " + size_words(*wanted).plural +
                              "; remove " + name.prefix + ":");
    }
    if (!wanted && !stated) refuse_unstated(scanner, name, column, option);
    const SizeKind kind = wanted ? *wanted : *stated;
    if (kind == option.foreign) {
        scanner.refuse_header(scanner.label(column) + " holds " + size_words(kind).plural +
                              ", but " +
                              std::string(option.why).substr(0, std::string(option.why).find(',')) +
                              "; name a column of " + size_words(option.plain).plural +
                              " or diameters, " + with_columns(name, "", "COLUMN"));
    }
    return {column, kind};
}

}  // namespace pcvt
