#include "io/outputs/journal.hpp"

#include <charconv>

#include "io/outputs/run_file.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kJournal = "pcvt journal 2";
constexpr std::string_view kPointer = "pcvt pointer 1";
/// No more than a file of kMostBytes can hold.
constexpr long long kMostItems = 1 << 24;

/// FNV-1a, 64 bits.
std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t sum = 0xCBF29CE484222325U;
    for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return sum;
}

/// Fields that end with a NUL byte, which no path holds; the last one is the checksum of the
/// others.
class FieldWriter {
   public:
    void add(std::string_view field) { (bytes_ += field) += '\0'; }
    void add(long long number) { add(std::to_string(number)); }
    void add(const FileStamp& stamp) {
        for (const long long part : {stamp.size, stamp.seconds, stamp.nanoseconds}) add(part);
    }
    std::string finish() {
        const std::uint64_t sum = checksum(bytes_);
        add(std::to_string(sum));
        return std::move(bytes_);
    }

   private:
    std::string bytes_;
};

/// Reads fields; after the first fault, every field is empty and every number 0.
class FieldReader {
   public:
    explicit FieldReader(std::string_view bytes) : rest_(bytes) {
        if (bytes.empty() || bytes.back() != '\0') return;
        const std::string_view body = bytes.substr(0, bytes.size() - 1);
        const std::size_t last = body.rfind('\0');
        if (last == std::string_view::npos) return;
        rest_ = bytes.substr(0, last + 1);
        good_ = body.substr(last + 1) == std::to_string(checksum(rest_));
    }

    std::string_view text() {
        const std::size_t end = good_ ? rest_.find('\0') : std::string_view::npos;
        if (end == std::string_view::npos) return fail();
        const std::string_view field = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return field;
    }
    long long number() {
        const std::string_view field = text();
        long long value = 0;
        const auto [stop, fault] =
            std::from_chars(field.data(), field.data() + field.size(), value);
        if (fault != std::errc() || stop != field.data() + field.size()) fail();
        return value;
    }
    /// A number from 0 to `most`.
    std::size_t count(long long most) {
        const long long value = number();
        if (value < 0 || value > most) fail();
        return good_ ? static_cast<std::size_t>(value) : 0;
    }
    FileStamp stamp() {
        FileStamp stamp;
        stamp.size = number();
        stamp.seconds = number();
        stamp.nanoseconds = number();
        return stamp;
    }
    void require(bool condition) {
        if (!condition) fail();
    }
    bool is_good() const { return good_; }
    bool ends_well() const { return good_ && rest_.empty(); }

   private:
    std::string_view fail() {
        good_ = false;
        return {};
    }
    std::string_view rest_;
    bool good_ = false;
};

/// Whether the path stays below the folder that it is relative to.
bool stays_below(std::string_view path) {
    while (true) {
        const std::size_t end = std::min(path.find('/'), path.size());
        const std::string_view part = path.substr(0, end);
        if (part.empty() || part == "." || part == "..") return false;
        if (end == path.size()) return true;
        path.remove_prefix(end + 1);
    }
}

Journal::Move read_move(FieldReader& fields, const Journal& journal) {
    Journal::Move move;
    move.kind = static_cast<FileMove::Kind>(
        fields.count(static_cast<long long>(FileMove::Kind::kNewFolder)));
    move.folder = fields.count(static_cast<long long>(journal.folders.size()) - 1);
    move.temporary = fields.text();
    move.target = fields.text();
    move.fresh = fields.stamp();
    move.old = fields.stamp();
    if (!fields.is_good()) return move;
    fields.require(temporary_token(move.temporary) == journal.folders[move.folder].token);
    fields.require(stays_below(move.temporary) && move.temporary.find('/') == std::string::npos);
    fields.require(stays_below(move.target));
    return move;
}

}  // namespace

std::string encode_journal(const Journal& journal) {
    FieldWriter fields;
    fields.add(kJournal);
    fields.add(static_cast<long long>(journal.folders.size()));
    for (const Journal::Folder& folder : journal.folders) {
        fields.add(folder.path);
        fields.add(folder.token);
    }
    fields.add(static_cast<long long>(journal.moves.size()));
    for (const Journal::Move& move : journal.moves) {
        fields.add(static_cast<long long>(move.kind));
        fields.add(static_cast<long long>(move.folder));
        fields.add(move.temporary);
        fields.add(move.target);
        fields.add(move.fresh);
        fields.add(move.old);
    }
    return fields.finish();
}

std::optional<Journal> decode_journal(std::string_view bytes) {
    FieldReader fields(bytes);
    fields.require(fields.text() == kJournal);
    Journal journal;
    for (std::size_t n = fields.count(kMostItems); n > 0 && fields.is_good(); --n) {
        const std::string path(fields.text());
        journal.folders.push_back({path, std::string(fields.text())});
    }
    for (std::size_t n = fields.count(kMostItems); n > 0 && fields.is_good(); --n) {
        journal.moves.push_back(read_move(fields, journal));
    }
    if (!fields.ends_well()) return {};
    return journal;
}

std::string encode_pointer(const std::string& run_file) {
    FieldWriter fields;
    fields.add(kPointer);
    fields.add(run_file);
    return fields.finish();
}

std::optional<std::string> decode_pointer(std::string_view bytes) {
    FieldReader fields(bytes);
    fields.require(fields.text() == kPointer);
    const std::string run_file(fields.text());
    if (!fields.ends_well()) return {};
    return run_file;
}

}  // namespace pcvt
