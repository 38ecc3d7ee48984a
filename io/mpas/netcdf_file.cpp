#include "io/mpas/netcdf_file.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

enum class ListTag : std::uint64_t {
    kAbsent = 0,
    kDimensions = 10,
    kVariables = 11,
    kAttributes = 12
};

/// The bytes of a value of each external type, whose numbers count from 1.
constexpr std::array<std::uint64_t, 11> kTypeBytes{1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
constexpr std::size_t kTagBytes = 4;
/// Names and values are padded to a multiple of this.
constexpr std::uint64_t kPadding = 4;

/// Types of these numbers; those above kDouble have no sign, but for kLargeSigned.
constexpr std::uint32_t kText = 2;
constexpr std::uint32_t kFloat = 5;
constexpr std::uint32_t kDouble = 6;
constexpr std::uint32_t kLargeSigned = 10;

/// @pre  The part lies within the bytes.
std::string_view part(std::string_view bytes, std::uint64_t begin, std::uint64_t n_bytes) {
    return bytes.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(n_bytes));
}

std::uint64_t big_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
}

const std::string_view& name_of(const auto& entry) {
    if constexpr (requires { entry.name; }) {
        return entry.name;
    } else {
        return entry.values.name;
    }
}

}  // namespace

/// Walks over a header; the grammar is that of the classic formats in the netCDF documentation.
class NetcdfHeaderScanner {
   public:
    explicit NetcdfHeaderScanner(NetcdfFile& file) : file_(file) {
        const std::string_view bytes = file.bytes_;
        if (!bytes.starts_with("CDF") || bytes.size() < 4) {
            file.throw_bad_file(
                "not a netCDF file of the classic formats; convert it with nccopy -k nc6");
        }
        const int version = static_cast<unsigned char>(bytes[3]);
        at_ = 4;
        if (version != 1 && version != 2 && version != 5) {
            throw_bad_header("is of version " + std::to_string(version) + ", not 1, 2 or 5");
        }
        count_bytes_ = version == 5 ? 8 : 4;
        offset_bytes_ = version == 1 ? 4 : 8;
    }

    void scan() {
        count();  // of records
        for (auto n = list(ListTag::kDimensions); n > 0; --n) {
            const std::string_view entry = name();
            file_.dimensions_.push_back({entry, count()});
        }
        file_.attributes_ = attributes();
        for (auto n = list(ListTag::kVariables); n > 0; --n) {
            NetcdfFile::Variable& variable = file_.variables_.emplace_back();
            variable.values.name = name();
            for (auto k = possible(count(), count_bytes_); k > 0; --k)
                variable.dimensions.push_back(count());
            variable.attributes = attributes();
            variable.values.type = type();
            count();  // of bytes, which the dimensions state as well
            variable.values.begin = number(offset_bytes_);
        }
    }

   private:
    [[noreturn]] void throw_bad_header(const std::string& fault) const {
        file_.throw_bad_file("the header " + fault + " at byte " + std::to_string(at_) +
                             "; give the whole file");
    }

    std::uint64_t number(std::uint64_t n_bytes) { return big_endian(take(1, n_bytes)); }
    std::uint64_t count() { return number(count_bytes_); }

    /// Takes `count` entries, and the padding after them.
    std::string_view take(std::uint64_t count, std::uint64_t entry_bytes) {
        const std::uint64_t left = file_.bytes_.size() - at_;
        if (count > left / entry_bytes) throw_bad_header("ends too early");
        const std::uint64_t padded = (count * entry_bytes + kPadding - 1) / kPadding * kPadding;
        if (padded > left) throw_bad_header("ends too early");
        const std::string_view taken = part(file_.bytes_, at_, count * entry_bytes);
        at_ += padded;
        return taken;
    }

    /// Returns a number of entries, which the rest of the file must be able to hold.
    std::uint64_t possible(std::uint64_t n, std::uint64_t entry_bytes) const {
        if (n > (file_.bytes_.size() - at_) / entry_bytes) throw_bad_header("ends too early");
        return n;
    }

    /// Returns the number of entries of the list that begins here.
    std::uint64_t list(ListTag tag) {
        const std::uint64_t found = number(kTagBytes);
        const std::uint64_t n = count();
        const bool absent = found == std::uint64_t(ListTag::kAbsent) && n == 0;
        if (!absent && found != std::uint64_t(tag))
            throw_bad_header("has another list than is due");
        // Every entry has at least the length of its name.
        return possible(n, count_bytes_);
    }

    std::string_view name() { return take(count(), 1); }

    std::uint32_t type() {
        const std::uint64_t found = number(kTagBytes);
        if (found < 1 || found > kTypeBytes.size()) throw_bad_header("names an unknown type");
        return static_cast<std::uint32_t>(found);
    }

    std::vector<NetcdfFile::Values> attributes() {
        std::vector<NetcdfFile::Values> found;
        for (auto n = list(ListTag::kAttributes); n > 0; --n) {
            NetcdfFile::Values& values = found.emplace_back();
            values.name = name();
            values.type = type();
            values.count = count();
            values.begin = at_;
            take(values.count, kTypeBytes[values.type - 1]);
        }
        return found;
    }

    NetcdfFile& file_;
    std::uint64_t count_bytes_ = 4;
    std::uint64_t offset_bytes_ = 8;
    std::uint64_t at_ = 0;
};

NetcdfFile::NetcdfFile(std::string path, std::string_view bytes)
    : path_(std::move(path)), bytes_(bytes) {
    NetcdfHeaderScanner(*this).scan();
}

void NetcdfFile::throw_bad_file(const std::string& complaint) const {
    throw BadFile(path_ + ": " + complaint);
}

template <class Entries>
const auto& NetcdfFile::find(const Entries& entries, std::string_view name) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto& entry) { return name_of(entry) == name; });
    if (found != entries.end()) return *found;
    throw_bad_file(std::string(name) +
                   " cannot be read: the file has none; give an MPAS mesh file");
}

std::size_t NetcdfFile::dimension(std::string_view name) const {
    return static_cast<std::size_t>(find(dimensions_, name).size);
}

/// Returns a value that lies within the file.
double NetcdfFile::number(const Values& values, std::uint64_t k) const {
    const std::uint64_t width = kTypeBytes[values.type - 1];
    const std::uint64_t bits = big_endian(part(bytes_, values.begin + k * width, width));
    if (values.type == kFloat)
        return Eigen::numext::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (values.type == kDouble) return Eigen::numext::bit_cast<double>(bits);
    const bool has_sign = values.type < kFloat || values.type == kLargeSigned;
    if (!has_sign) return static_cast<double>(bits);
    // Shift the sign to the highest bit and back.
    const std::uint64_t shift = 64 - 8 * width;
    return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
}

bool NetcdfFile::has_attribute(std::string_view name) const {
    return std::any_of(attributes_.begin(), attributes_.end(),
                       [&](const Values& values) { return values.name == name; });
}

std::string_view NetcdfFile::text(std::string_view name) const {
    const Values& values = find(attributes_, name);
    if (values.type != kText) throw_bad_file("attribute " + std::string(name) + " is not a text");
    return part(bytes_, values.begin, values.count);
}

std::string_view NetcdfFile::text_of(std::string_view variable, std::string_view name) const {
    for (const Values& values : find(variables_, variable).attributes) {
        if (values.name != name || values.type != kText) continue;
        return part(bytes_, values.begin, values.count);
    }
    return "";
}

double NetcdfFile::attribute(std::string_view name) const {
    const Values& values = find(attributes_, name);
    if (values.count != 1 || values.type == kText) {
        throw_bad_file("attribute " + std::string(name) + " is not one number");
    }
    return number(values, 0);
}

/// Returns a variable of numbers whose values lie within the file.
const NetcdfFile::Variable& NetcdfFile::variable(std::string_view name,
                                                 const std::vector<std::size_t>& size) const {
    const Variable& found = find(variables_, name);
    std::uint64_t entries = 1;
    for (const std::uint64_t index : found.dimensions) {
        if (index >= dimensions_.size()) {
            throw_bad_file(std::string(name) + " has an unknown dimension; give the whole file");
        }
        // No more entries than bytes; the number of values of another length is not of interest.
        entries *= std::min<std::uint64_t>(dimensions_[static_cast<std::size_t>(index)].size,
                                           bytes_.size() + 1);
        entries = std::min<std::uint64_t>(entries, bytes_.size() + 1);
    }
    std::uint64_t wanted = 1;
    for (const std::size_t length : size) wanted *= length;
    const std::uint64_t width = kTypeBytes[found.values.type - 1];
    if (found.dimensions.size() > 2 || entries != wanted || wanted > bytes_.size() / width) {
        throw_bad_file(std::string(name) + " has " + std::to_string(entries) + " entries, not " +
                       std::to_string(wanted) + "; give the whole file");
    }
    const std::uint64_t begin = found.values.begin;
    if (found.values.type == kText || begin > bytes_.size() ||
        wanted * width > bytes_.size() - begin) {
        throw_bad_file(std::string(name) +
                       " cannot be read: the file does not hold its values; give the whole file");
    }
    return found;
}

std::vector<int> NetcdfFile::integers(std::string_view name,
                                      const std::vector<std::size_t>& size) const {
    std::vector<int> result;
    for (const double value : numbers(name, size)) {
        if (!(value >= std::numeric_limits<int>::min()) ||
            !(value <= std::numeric_limits<int>::max()) || value != std::floor(value)) {
            throw_bad_file(
                std::string(name) +
                " cannot be read: a value is not an integer of 32 bits; give an MPAS mesh "
                "file");
        }
        result.push_back(static_cast<int>(value));
    }
    return result;
}

std::vector<double> NetcdfFile::numbers(std::string_view name,
                                        const std::vector<std::size_t>& size) const {
    const Variable& found = variable(name, size);
    std::size_t n = 1;
    for (const std::size_t length : size) n *= length;
    std::vector<double> result;
    result.reserve(n);
    for (std::size_t k = 0; k < n; ++k) result.push_back(number(found.values, k));
    return result;
}

}  // namespace pcvt
