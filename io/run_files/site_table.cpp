#include "io/run_files/site_table.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/input_file.hpp"
#include "io/run_files/orientation_reader.hpp"
#include "io/run_files/table_reader.hpp"

namespace pcvt {
namespace {

/// A quantity of each site, and the columns of a header that hold it.
struct SiteQuantity {
    bool SiteColumns::*is_wanted;
    std::vector<std::string> columns;
};

const std::array<SiteQuantity, 3>& site_quantities() {
    static const std::array<SiteQuantity, 3> kQuantities{
        {{&SiteColumns::weights, {"weight"}},
         {&SiteColumns::phases, {"phase"}},
         {&SiteColumns::orientations, {"phi1", "Phi", "phi2"}}}};
    return kQuantities;
}

/// The columns of a quantity; none if the header lacks one of them.
std::vector<std::size_t> columns_of(const TableScanner& scanner, const SiteQuantity& quantity) {
    std::vector<std::size_t> columns;
    for (const std::string& column : quantity.columns) {
        const std::optional<std::size_t> found = scanner.find(column);
        if (!found) return {};
        columns.push_back(*found);
    }
    return columns;
}

/// The quantities of which a row has a field that is not empty.
SiteColumns filled_columns(const std::string& name, std::string_view text,
                           const SiteColumns& wanted) {
    SiteColumns filled{.weights = false, .phases = false, .orientations = false};
    TableScanner scanner(name, text);
    std::array<std::vector<std::size_t>, 3> columns;
    for (std::size_t q = 0; q < columns.size() && scanner.has_header(); ++q) {
        const SiteQuantity& quantity = site_quantities()[q];
        if (wanted.*quantity.is_wanted) columns[q] = columns_of(scanner, quantity);
    }
    const auto is_settled = [](const auto& of_quantity) { return of_quantity.empty(); };
    while (!std::all_of(columns.begin(), columns.end(), is_settled) && scanner.next()) {
        for (std::size_t q = 0; q < columns.size(); ++q) {
            const bool is_filled =
                std::any_of(columns[q].begin(), columns[q].end(),
                            [&](std::size_t k) { return !scanner.fields()[k].empty(); });
            if (!is_filled) continue;
            filled.*site_quantities()[q].is_wanted = true;
            columns[q].clear();
        }
    }
    return filled;
}

/// Adds to a fault of a column that the positions may be taken without it.
template <int Dimension, class Parse>
void naming_positions(const TableName& name, const Parse& parse) {
    try {
        parse();
    } catch (const BadFile& fault) {
        throw BadFile(std::string(fault.what()) + ", or take only the positions, --input " +
                      with_columns(name, "", names_of_coordinates(Dimension)));
    }
}

}  // namespace

template <int Dimension>
SiteTable<Dimension> parse_site_table(const TableName& name, std::string_view text,
                                      const SiteColumns& wanted) {
    SiteTable<Dimension> table{.sites = parse_sites<Dimension>(name, text)};
    if (!name.columns.empty()) return table;
    const std::string& path = table.sites.name;
    const SiteColumns filled = filled_columns(path, text, wanted);
    const auto of_quantity = [&](std::size_t q) {
        return TableName{.path = path, .columns = site_quantities()[q].columns};
    };
    naming_positions<Dimension>(name, [&] {
        if (filled.weights) table.weights = parse_weights(of_quantity(0), text);
        if (filled.phases) table.phases = parse_phase_table(of_quantity(1), text);
        if (filled.orientations) {
            table.orientations = parse_orientations(of_quantity(2), text).angles;
        }
    });
    return table;
}

template <int Dimension>
SiteTable<Dimension> read_site_table(const TableName& name, const SiteColumns& wanted) {
    return parse_site_table<Dimension>(
        name, name.path == "-" ? read_standard_input() : read_whole_file(name.path, kSiteInput),
        wanted);
}

template SiteTable<2> parse_site_table<2>(const TableName& name, std::string_view text,
                                          const SiteColumns& wanted);
template SiteTable<3> parse_site_table<3>(const TableName& name, std::string_view text,
                                          const SiteColumns& wanted);
template SiteTable<2> read_site_table<2>(const TableName& name, const SiteColumns& wanted);
template SiteTable<3> read_site_table<3>(const TableName& name, const SiteColumns& wanted);

}  // namespace pcvt
