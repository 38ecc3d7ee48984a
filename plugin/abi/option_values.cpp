#include "plugin/abi/option_values.hpp"

#include <cmath>
#include <thread>

#include "plugin/pcvt.h"

namespace pcvt::abi {
namespace {

constexpr int kMostThreads = 1024;

bool are_finite(const double* values, int n) {
    return std::all_of(values, values + n, [](double value) { return std::isfinite(value); });
}

}  // namespace

void require_finite(const char* name, const double* values, int n) {
    if (are_finite(values, n)) return;
    throw InvalidInput(std::string(name) + " is not finite; give finite numbers");
}

void require_finite_points(const char* name, const double* numbers, int n, int dimension) {
    if (n < 0) throw InvalidInput("the number of sites is negative; take 0 or more");
    for (int s = 0; s < n; ++s) {
        if (are_finite(numbers + std::ptrdiff_t{s} * dimension, dimension)) continue;
        throw InvalidInput(std::string(name) + " " + std::to_string(s) +
                           " is not finite; give finite numbers");
    }
}

void require_positive(const char* name, double value) {
    if (value > 0 && std::isfinite(value)) return;
    throw InvalidInput(std::string(name) + " is not a positive number");
}

std::optional<double> positive_or_none(const char* name, double value) {
    if (value == 0) return std::nullopt;
    require_positive(name, value);
    return value;
}

plane::Lattice plane_lattice(const double* numbers) {
    require_finite("lattice", numbers, 4);
    return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

void require_one_start(const double* sites, std::int32_t start) {
    if (sites == nullptr || start == PCVT_START_DEFAULT) return;
    throw InvalidInput("start is for drawn sites, but sites gives them; leave one out");
}

int thread_count(std::int32_t wanted) {
    if (wanted < 0 || wanted > kMostThreads) {
        throw InvalidInput("n_threads is not between 0 and " + std::to_string(kMostThreads) +
                           "; take 0 for all cores");
    }
    if (wanted > 0) return wanted;
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace pcvt::abi
