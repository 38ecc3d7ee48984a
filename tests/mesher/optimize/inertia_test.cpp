#include "mesher/optimize/inertia.hpp"

#include <gtest/gtest.h>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Points of a periodic cubic grid with springs to their neighbours, also diagonal ones, two
/// variables a point: positive semidefinite with the constants as null vectors.
/// @param softened  the stiffness of one spring, 1 like the others or negative.
BlockMatrix springs(int side, double softened) {
    const int n = side * side * side;
    const auto at = [side](int x, int y, int z) {
        const auto wrap = [side](int k) { return (k + side) % side; };
        return (wrap(x) * side + wrap(y)) * side + wrap(z);
    };
    BlockMatrix matrix;
    matrix.resize(std::vector<int>(static_cast<std::size_t>(n), 14));
    for (int i = 0; i < n; ++i) matrix.diagonal[i] = {0, 0, 0, 0};
    std::vector<int> next(matrix.row_begin.begin(), matrix.row_begin.end() - 1);
    const auto add = [&](int i, int j, double stiffness) {
        for (const auto& [row, column] : {std::pair(i, j), std::pair(j, i)}) {
            matrix.diagonal[row][0] += stiffness;
            matrix.diagonal[row][3] += stiffness;
            matrix.column[next[row]] = column;
            matrix.block[next[row]++] = {float(-stiffness), 0, 0, float(-stiffness)};
        }
    };
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            for (int z = 0; z < side; ++z) {
                const int i = at(x, y, z);
                add(i, at(x + 1, y, z), i == 0 ? softened : 1);
                add(i, at(x, y + 1, z), 1);
                add(i, at(x, y, z + 1), 1);
                add(i, at(x + 1, y + 1, z), 1);
                add(i, at(x, y + 1, z + 1), 1);
                add(i, at(x + 1, y, z - 1), 1);
                add(i, at(x + 1, y + 1, z + 1), 1);
            }
        }
    }
    return matrix;
}

TEST(Inertia, TellsAMinimumFromASaddle) {
    EXPECT_EQ(minimum_by_inertia(springs(5, 1), 2), Minimum::kYes);
    EXPECT_EQ(minimum_by_inertia(springs(5, -8), 2), Minimum::kNo);
    // One null direction too many, or too few.
    EXPECT_EQ(minimum_by_inertia(springs(5, 1), 1), Minimum::kUnknown);
    EXPECT_EQ(minimum_by_inertia(springs(5, 1), 3), Minimum::kUnknown);
}

TEST(Inertia, AFactorisationCanBeCancelled) {
    class Counter final : public Client {
       public:
        explicit Counter(int most) : most_(most) {}
        void pass() override {
            if (++n_passes == most_) throw Cancelled{};
        }
        int n_passes = 0;

       private:
        int most_;
    };
    const BlockMatrix matrix = springs(10, 1);
    Counter patient(-1);
    {
        const ClientScope scope(&patient);
        EXPECT_EQ(minimum_by_inertia(matrix, 2), Minimum::kYes);
    }
    // Some 10^8 operations.
    EXPECT_GT(patient.n_passes, 50);
    Counter impatient(patient.n_passes - 5);
    const ClientScope scope(&impatient);
    EXPECT_THROW(minimum_by_inertia(matrix, 2), Cancelled);
}

}  // namespace
}  // namespace pcvt
