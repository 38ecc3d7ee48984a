#include "io/run_files/phase_reader.hpp"

#include <map>
#include <optional>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/table_reader.hpp"
#include "mesher/cells/phase_fractions.hpp"

namespace pcvt {
namespace {

std::optional<std::size_t> find_phase_column(const TableScanner& scanner) {
    for (const char* column : {"phase", "phases", "phase name", "phase id"}) {
        if (const auto found = scanner.find(column)) return found;
    }
    return std::nullopt;
}

std::size_t phase_column(TableScanner& scanner, const TableName& name) {
    if (name.columns.size() > 1) {
        scanner.refuse_header("a site has one phase, but " + std::to_string(name.columns.size()) +
                              " columns are named; name one");
    }
    if (!name.columns.empty()) return scanner.choose(name.columns).front();
    if (scanner.n_columns() == 1) return 0;
    if (const auto found = find_phase_column(scanner)) return *found;
    scanner.refuse_header("the table has several columns; name that of the phases, such as " +
                          with_columns(name, "", scanner.typed(scanner.n_columns() - 1)));
}

/// Whether the first word is a phase: a single column of words begins with a header only if that
/// is a word for phases, or the column that is named.
bool is_list(const TableScanner& scanner, const TableName& name) {
    if (scanner.n_columns() != 1 || !scanner.has_header() || find_phase_column(scanner))
        return false;
    return name.columns.size() != 1 || !scanner.find(name.columns.front());
}

/// The index of a phase among those that are known, to which it is added.
class PhaseNames {
   public:
    explicit PhaseNames(std::vector<std::string>& names) : names_(&names) {}

    int index_of(const TableScanner& scanner, std::size_t column) {
        const std::string name(scanner.word(column));
        const auto [entry, is_new] = index_.try_emplace(name, static_cast<int>(names_->size()));
        if (!is_new) return entry->second;
        names_->push_back(name);
        try {
            require_phase_names(*names_);
        } catch (const InvalidInput& fault) {
            scanner.refuse(column, fault.what());
        }
        return entry->second;
    }

   private:
    std::vector<std::string>* names_;
    std::map<std::string, int> index_;
};

}  // namespace

PhaseFile parse_phase_table(const TableName& name, std::string_view text) {
    refuse_binary(name.path, text, "give a text with the phase of one site a line");
    PhaseFile file;
    PhaseNames names(file.names);
    TableScanner scanner(name.path, text);
    if (is_list(scanner, name)) scanner = TableScanner(name.path, text, false);
    if (scanner.n_columns() > 0) {
        const std::size_t column = phase_column(scanner, name);
        while (scanner.next()) {
            // Without a header and a named column the scanner admits rows of other widths.
            if (name.columns.empty() && !scanner.has_header() && scanner.fields().size() > 1) {
                scanner.refuse("this line has " + std::to_string(scanner.fields().size()) +
                               " words; write one phase a line");
            }
            file.site_phases.push_back(names.index_of(scanner, column));
        }
    }
    if (file.site_phases.empty()) {
        throw BadFile(name.path + ": holds no phase; give one a line, one for each site");
    }
    return file;
}

PhaseFile read_phases(const TableName& name) {
    return parse_phase_table(name, read_whole_file(name.path, kSiteInput));
}

}  // namespace pcvt
