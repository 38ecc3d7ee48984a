#include "io/run_files/site_table.hpp"

#include "io/bytes/input_file.hpp"
#include "io/run_files/orientation_reader.hpp"
#include "io/run_files/table_reader.hpp"

namespace pcvt {
namespace {

/// The columns of a header whose fields are not empty in the first row.
class FilledColumns {
   public:
    FilledColumns(const std::string& name, std::string_view text) : scanner_(name, text) {
        if (!scanner_.has_header() || !scanner_.next()) return;
        has_rows_ = true;
    }

    bool has(const char* column) const {
        if (!has_rows_) return false;
        const std::optional<std::size_t> found = scanner_.find(column);
        return found && !scanner_.fields()[*found].empty();
    }
    [[noreturn]] void refuse(const char* column, const std::string& complaint) const {
        scanner_.refuse(*scanner_.find(column), complaint);
    }

   private:
    TableScanner scanner_;
    bool has_rows_ = false;
};

}  // namespace

template <int Dimension>
SiteTable<Dimension> parse_site_table(const TableName& name, std::string_view text) {
    SiteTable<Dimension> table{.sites = parse_sites<Dimension>(name, text)};
    if (!name.columns.empty()) return table;
    const auto column = [&](std::vector<std::string> columns) {
        return TableName{.path = table.sites.name, .columns = std::move(columns)};
    };
    const FilledColumns filled(table.sites.name, text);
    if (filled.has("weight")) {
        if (Dimension == 3) {
            filled.refuse("weight",
                          "weights are for the plane only; name the columns of the "
                          "coordinates, " +
                              with_columns(name, "", "x,y,z"));
        }
        table.weights = parse_weights(column({"weight"}), text);
    }
    if (filled.has("phase")) table.phases = parse_phase_table(column({"phase"}), text);
    if (filled.has("phi1") && filled.has("Phi") && filled.has("phi2")) {
        table.orientations = parse_orientations(column({"phi1", "Phi", "phi2"}), text);
    }
    return table;
}

template <int Dimension>
SiteTable<Dimension> read_site_table(const TableName& name) {
    return parse_site_table<Dimension>(
        name, name.path == "-" ? read_standard_input() : read_whole_file(name.path, kSiteInput));
}

template SiteTable<2> parse_site_table<2>(const TableName& name, std::string_view text);
template SiteTable<3> parse_site_table<3>(const TableName& name, std::string_view text);
template SiteTable<2> read_site_table<2>(const TableName& name);
template SiteTable<3> read_site_table<3>(const TableName& name);

}  // namespace pcvt
