#include "io/bytes/nearest_word.hpp"

#include <algorithm>
#include <numeric>

namespace pcvt {
namespace {

constexpr int kMostEdits = 2;
constexpr std::size_t kShortestBeginning = 3;

/// Returns the only word that begins with `beginning`, or else an empty string.
std::string only_continuation(std::string_view beginning, const std::vector<std::string>& words) {
    const auto continues = [&](const std::string& word) { return word.starts_with(beginning); };
    if (beginning.size() < kShortestBeginning) return {};
    if (std::count_if(words.begin(), words.end(), continues) != 1) return {};
    return *std::find_if(words.begin(), words.end(), continues);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    // Row i holds the distances of the first i characters of `a` to all beginnings of `b`.
    std::vector<int> before_last;
    std::vector<int> last(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::vector<int> row(b.size() + 1, static_cast<int>(i));
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last = std::move(last);
        last = std::move(row);
    }
    return last.back();
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& words) {
    const int most = std::min(kMostEdits, static_cast<int>(word.size() / 2));
    std::string nearest;
    // Two for each edit, less one for a word that only continues `word`.
    int least_cost = 2 * most + 1;
    for (const std::string& candidate : words) {
        const int distance = edit_distance(word, candidate);
        const int cost = 2 * distance - (candidate.starts_with(word) ? 1 : 0);
        if (distance > most || cost > least_cost) continue;
        nearest = cost < least_cost ? candidate : std::string();
        least_cost = cost;
    }
    const bool is_near = least_cost <= 2 * most;
    return is_near ? nearest : only_continuation(word, words);
}

}  // namespace pcvt
