#include "tests/bench/cases.hpp"

#include <malloc.h>

#include <ctime>
#include <vector>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::bench {

plane::Points Input::sites() const { return uniform_points(lattice, n, 1); }

benchmark::internal::Benchmark* add_case(const std::string& name,
                                         const std::function<void(benchmark::State&)>& body) {
    return benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

benchmark::internal::Benchmark* add_case(const std::string& what, const Input& input,
                                         const std::function<void(benchmark::State&)>& body) {
    return add_case(what + '/' + input.lattice_name + '/' + std::to_string(input.n), body);
}

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

void warm_the_heap() {
    // Exceeds the need of the largest case: the mirror diagram of 1e6 sites takes 0.3 GB.
    constexpr std::size_t kBytes = std::size_t{1} << 29;
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
    std::vector<char> touched(kBytes, 1);
    benchmark::DoNotOptimize(touched.data());
}

void cool_the_heap() {
    // The initial values of malloc (mallopt(3)).
    mallopt(M_MMAP_MAX, 1 << 16);
    mallopt(M_MMAP_THRESHOLD, 1 << 17);
    mallopt(M_TRIM_THRESHOLD, 1 << 17);
    malloc_trim(0);
}

}  // namespace pcvt::bench
