#include "mesher/plane/interfaces/curve_samples.hpp"

#include <cmath>

namespace pcvt::plane {

void grade(std::vector<Sample>& samples) {
    const auto bound = [](Sample& sample, const Sample& neighbour) {
        const double step = std::abs(sample.along - neighbour.along);
        sample.size = std::min(sample.size, neighbour.size + kGrading * step);
    };
    for (int round = 0; round < 2; ++round) {
        for (std::size_t k = 1; k < samples.size(); ++k) bound(samples[k], samples[k - 1]);
        samples.front().size = std::min(samples.front().size, samples.back().size);
        for (std::size_t k = samples.size() - 1; k-- > 0;) bound(samples[k], samples[k + 1]);
        samples.back().size = std::min(samples.front().size, samples.back().size);
    }
}

std::vector<double> chord_counts(const std::vector<Sample>& samples) {
    std::vector<double> counts{0};
    for (std::size_t k = 1; k < samples.size(); ++k) {
        const double step = samples[k].along - samples[k - 1].along;
        counts.push_back(counts.back() +
                         step * (1 / samples[k].size + 1 / samples[k - 1].size) / 2);
    }
    return counts;
}

}  // namespace pcvt::plane
