#include "io/graphics/om_bytes.hpp"

#include <Eigen/Core>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

std::string_view OmBytes::take(std::size_t n_bytes) {
    if (n_bytes > rest_.size()) throw_bad_file("is cut short");
    const std::string_view taken = rest_.substr(0, n_bytes);
    rest_.remove_prefix(n_bytes);
    return taken;
}

std::size_t OmBytes::read_size(std::size_t width) {
    return static_cast<std::size_t>(integer_of(take(width)) & ((std::int64_t{1} << 8 * width) - 1));
}

std::size_t OmBytes::read_count() {
    const std::size_t count = read_size(4);
    if (count > rest_.size()) throw_bad_file("is cut short");
    return count;
}

std::int64_t OmBytes::integer_of(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        value |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * k);
    }
    const auto unused = static_cast<int>(64 - 8 * bytes.size());
    return static_cast<std::int64_t>(value << unused) >> unused;
}

double OmBytes::double_of(std::string_view bytes) {
    return Eigen::numext::bit_cast<double>(integer_of(bytes.substr(0, 8)));
}

void OmBytes::throw_bad_file(const std::string& complaint) const {
    throw BadFile(name_ + ": " + complaint + "; write the file again with pcvt");
}

void OmBytes::throw_other_fault(const InvalidInput& fault) const {
    throw BadFile(name_ + ": " + fault.what());
}

}  // namespace pcvt
