#include "io/run_files/cell_reader.hpp"

#include <array>

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// In either dimension.
constexpr std::size_t kColumns = 15;

using Fields = std::array<std::string_view, kColumns>;

/// Walks over the rows below the header.
class RowScanner {
   public:
    /// @param header  the first line that is not a comment.
    RowScanner(const std::string& name, std::string_view text, const char* header)
        : name_(name), rest_(text) {
        if (!next_line() || line_text_ != header) {
            refuse("the header is not that of a table of cells; write the file again with pcvt");
        }
    }

    bool next() {
        if (!next_line()) return false;
        std::string_view rest = line_text_;
        for (std::size_t k = 0; k < kColumns; ++k) {
            const std::size_t comma = rest.find(',');
            if ((comma == std::string_view::npos) != (k + 1 == kColumns)) {
                refuse("the row has not 15 fields; write the file again with pcvt");
            }
            fields_[k] = rest.substr(0, comma);
            rest.remove_prefix(k + 1 == kColumns ? rest.size() : comma + 1);
        }
        return true;
    }

    const Fields& fields() const { return fields_; }

    [[noreturn]] void refuse(const std::string& complaint) const {
        throw BadFile(name_ + ":" + std::to_string(line_) + ": " + complaint);
    }

   private:
    /// Advances to the next line that is not a comment.
    bool next_line() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line_text_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++line_;
            if (!line_text_.starts_with('#')) return true;
        }
        return false;
    }

    std::string name_;
    std::string_view rest_;
    std::string_view line_text_;
    Fields fields_ = {};
    int line_ = 0;
};

/// Compares the fields of one row from left to right.
class RowComparison {
   public:
    explicit RowComparison(const RowScanner& scanner) : scanner_(scanner) {}

    void number(double wanted) {
        const std::string_view field = scanner_.fields()[column_++];
        try {
            same_ = same_ && !field.empty() && parse_number(field) == wanted;
        } catch (const InvalidInput& fault) {
            scanner_.refuse(fault.what());
        }
    }
    void text(std::string_view wanted) { same_ = same_ && scanner_.fields()[column_++] == wanted; }
    /// Numbers with a blank between them.
    void list(const int* begin, const int* end) {
        std::string_view field = scanner_.fields()[column_++];
        for (const int* wanted = begin; wanted != end; ++wanted) {
            const std::size_t length = std::min(field.find(' '), field.size());
            same_ = same_ && field.substr(0, length) == std::to_string(*wanted);
            field.remove_prefix(std::min(length + 1, field.size()));
        }
        same_ = same_ && field.empty();
    }
    bool is_same() const { return same_ && column_ == kColumns; }

   private:
    const RowScanner& scanner_;
    std::size_t column_ = 0;
    bool same_ = true;
};

bool is_row_of(const RowScanner& scanner, const CellRows& rows, SiteId s) {
    RowComparison row(scanner);
    for_each_field(rows, s, row);
    return row.is_same();
}

}  // namespace

bool reads_back(const std::string& name, std::string_view text, const CellRows& rows) {
    RowScanner scanner(name, text, cell_header(rows.cells.dimension));
    for (SiteId s = 0; s < rows.cells.n_cells(); ++s) {
        checkpoint_each(s);
        if (!scanner.next() || !is_row_of(scanner, rows, s)) return false;
    }
    return !scanner.next();
}

}  // namespace pcvt
