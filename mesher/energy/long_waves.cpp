#include "mesher/energy/long_waves.hpp"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <mutex>
#include <numbers>
#include <span>

namespace pcvt {
namespace {

/// The measured stiffness C_L along and C_T across the wave vector, in units of h^4.
constexpr double kAlong = 0.417;
constexpr double kAcross = 0.0963;
/// The weight w of the long waves and the number of grid nodes per h; measured.
constexpr double kShare = 0.4;
constexpr double kNodesPerSpacing = 0.6;
constexpr int kSitesPerStretch = 1 << 14;
constexpr int kRowsPerTask = 32;
/// Rows repeated before the first and after the last row, so that sites slightly outside of their
/// period stay next to their neighbours.
constexpr int kMargin = 16;

/// FFTW's planner is not thread-safe.
std::mutex& planning() {
    static std::mutex mutex;
    return mutex;
}

/// Returns the next even number without prime factors above 7.
int good_size(double wanted) {
    for (int size = std::max(4, 2 * static_cast<int>(std::ceil(wanted / 2)));; size += 2) {
        int rest = size;
        for (const int factor : {2, 3, 5, 7}) {
            while (rest % factor == 0) rest /= factor;
        }
        if (rest == 1) return size;
    }
}

/// Converts a coordinate in periods to rows or columns of a grid: in [-margin, size + margin), and
/// unwrapped if it lies in this range.
float on_grid(double u, int size, int margin) {
    const double unwrapped = u * size;
    if (unwrapped >= -margin && unwrapped < size + margin - 1) {
        return static_cast<float>(unwrapped);
    }
    const auto wrapped = static_cast<float>((u - std::floor(u)) * size);
    return wrapped < static_cast<float>(size) ? wrapped : 0;
}

}  // namespace

/// The values at the nodes of a periodic grid, with additional rows on both sides and an additional
/// column that repeat others; the Fourier transform uses the same memory.
class LongWaves::Grid {
   public:
    Grid(int n_rows, int n_columns);
    ~Grid();
    Grid(const Grid&) = delete;
    Grid& operator=(const Grid&) = delete;

    int n_rows() const { return n_rows_; }
    int n_columns() const { return n_columns_; }
    /// Returns row i, -kMargin <= i <= n_rows() + kMargin; each row also has column n_columns().
    float* row(int i) { return numbers_ + std::ptrdiff_t(i + kMargin) * row_stride_; }
    std::span<std::complex<float>> waves(int i) {
        return {reinterpret_cast<std::complex<float>*>(row(i)), std::size_t(n_columns_ / 2 + 1)};
    }

    void clear() { std::fill(row(-kMargin), row(n_rows_ + kMargin + 1), 0.0F); }
    /// Adds the repeated rows and column to the originals.
    void fold();
    void repeat();
    void to_waves() { fftwf_execute(to_waves_); }
    void to_nodes() { fftwf_execute(to_nodes_); }

   private:
    int n_rows_;
    int n_columns_;
    std::ptrdiff_t row_stride_;
    float* numbers_;
    fftwf_plan to_waves_;
    fftwf_plan to_nodes_;
};

LongWaves::Grid::Grid(int n_rows, int n_columns)
    : n_rows_(n_rows), n_columns_(n_columns), row_stride_(n_columns + 2) {
    numbers_ = fftwf_alloc_real(std::size_t(n_rows + 2 * kMargin + 1) * row_stride_);
    if (numbers_ == nullptr) throw std::bad_alloc();
    float* const nodes = row(0);
    auto* const waves = reinterpret_cast<fftwf_complex*>(nodes);
    // FFTW_ESTIMATE: measured plans round differently from run to run.
    const std::scoped_lock lock(planning());
    to_waves_ = fftwf_plan_dft_r2c_2d(n_rows, n_columns, nodes, waves, FFTW_ESTIMATE);
    to_nodes_ = fftwf_plan_dft_c2r_2d(n_rows, n_columns, waves, nodes, FFTW_ESTIMATE);
}

LongWaves::Grid::~Grid() {
    const std::scoped_lock lock(planning());
    fftwf_destroy_plan(to_waves_);
    fftwf_destroy_plan(to_nodes_);
    fftwf_free(numbers_);
}

void LongWaves::Grid::fold() {
    for (int i = -kMargin; i <= n_rows_ + kMargin; ++i) {
        if (i >= 0 && i < n_rows_) continue;
        float* const repeated = row(((i % n_rows_) + n_rows_) % n_rows_);
        for (int j = 0; j <= n_columns_; ++j) repeated[j] += row(i)[j];
    }
    for (int i = 0; i < n_rows_; ++i) row(i)[0] += row(i)[n_columns_];
}

void LongWaves::Grid::repeat() {
    for (int i = 0; i < n_rows_; ++i) row(i)[n_columns_] = row(i)[0];
    for (int i = -kMargin; i <= n_rows_ + kMargin; ++i) {
        if (i >= 0 && i < n_rows_) continue;
        std::copy_n(row(((i % n_rows_) + n_rows_) % n_rows_), n_columns_ + 1, row(i));
    }
}

LongWaves::LongWaves(const MovingDelaunay& delaunay, Workers& workers)
    : workers_(workers),
      frame_(delaunay.frame()),
      area_per_site_(delaunay.spacing() * delaunay.spacing()),
      n_sites_(delaunay.n_sites()) {
    const double per_length = kNodesPerSpacing / delaunay.spacing();
    const int n_rows = good_size(per_length * frame_.ax);
    const int n_columns = good_size(per_length * std::hypot(frame_.bx, frame_.by));
    x_ = std::make_unique<Grid>(n_rows, n_columns);
    y_ = std::make_unique<Grid>(n_rows, n_columns);
    place_sites(delaunay);
}

LongWaves::~LongWaves() = default;

void LongWaves::place_sites(const MovingDelaunay& delaunay) {
    place_.resize(2, n_sites_);
    for (SiteId s = 0; s < n_sites_; ++s) {
        const Vec2 u = delaunay.coordinates().col(s);
        place_.col(s) << on_grid(u.x(), x_->n_rows(), kMargin), on_grid(u.y(), x_->n_columns(), 0);
    }
    for (int first = 0; first < n_sites_; first += kSitesPerStretch) {
        const int end = std::min(first + kSitesPerStretch, n_sites_);
        const auto rows = place_.row(0).segment(first, end - first);
        stretches_.push_back(
            {first, end, static_cast<int>(rows.minCoeff()), static_cast<int>(rows.maxCoeff()) + 2});
    }
    if (!neighbours_only()) stretches_ = {{0, n_sites_, 0, x_->n_rows() + 1}};
}

/// Whether stretches that are not neighbours use different rows.
bool LongWaves::neighbours_only() const {
    int reached = -kMargin;
    for (std::size_t k = 2; k < stretches_.size(); ++k) {
        reached = std::max(reached, stretches_[k - 2].end_row);
        if (stretches_[k].first_row < reached) return false;
    }
    return true;
}

/// Distributes the sites' values to the nodes round each site: P^T r.
void LongWaves::collect(const Eigen::VectorXd& r) {
    // Add the values of one stretch of sites with bilinear weights.
    const auto add = [&](const Stretch& stretch) {
        for (int s = stretch.first_site; s < stretch.end_site; ++s) {
            const auto i = static_cast<int>(place_(0, s) + kMargin) - kMargin;
            const auto j = static_cast<int>(place_(1, s));
            const float down = place_(0, s) - static_cast<float>(i);
            const float right = place_(1, s) - static_cast<float>(j);
            const std::array<float, 4> weight{(1 - down) * (1 - right), (1 - down) * right,
                                              down * (1 - right), down * right};
            const std::array<Grid*, 2> grids{x_.get(), y_.get()};
            for (const int c : {0, 1}) {
                const auto number = static_cast<float>(r[2 * s + c]);
                float* const upper = grids[c]->row(i) + j;
                float* const lower = grids[c]->row(i + 1) + j;
                upper[0] += weight[0] * number;
                upper[1] += weight[1] * number;
                lower[0] += weight[2] * number;
                lower[1] += weight[3] * number;
            }
        }
    };
    // Process alternate stretches in parallel: they use different rows.
    const auto n = static_cast<int>(stretches_.size());
    for (const int parity : {0, 1}) {
        workers_.for_each((n + 1 - parity) / 2, [&](int k) { add(stretches_[2 * k + parity]); });
    }
}

/// Divides the amplitude of each wave by its stiffness.
void LongWaves::solve() {
    // Compute the normalisation.
    const int n_rows = x_->n_rows();
    const int n_columns = x_->n_columns();
    // 1 / n normalises the sum over sites; FFTW's factor N, the number of nodes, cancels against
    // the 1 / N of the sum over nodes.
    const double factor = kShare / (area_per_site_ * area_per_site_ * n_sites_);
    // Split each wave into its parts along and across the wave vector.
    const auto solve_row = [&](int i) {
        const auto x = x_->waves(i);
        const auto y = y_->waves(i);
        const double kx = 2 * std::numbers::pi * (i <= n_rows / 2 ? i : i - n_rows) / frame_.ax;
        for (int j = 0; j <= n_columns / 2; ++j) {
            const double ky = (2 * std::numbers::pi * j - kx * frame_.bx) / frame_.by;
            const double square = kx * kx + ky * ky;
            const bool two_signs = 2 * i == n_rows || 2 * j == n_columns;
            if (two_signs || i + j == 0) {
                x[j] = y[j] = 0;
                continue;
            }
            const auto across = static_cast<float>(factor / (kAcross * square));
            const auto along = static_cast<float>(factor / (kAlong * square));
            const auto ex = static_cast<float>(kx / std::sqrt(square));
            const auto ey = static_cast<float>(ky / std::sqrt(square));
            const std::complex<float> part = (along - across) * (ex * x[j] + ey * y[j]);
            x[j] = across * x[j] + ex * part;
            y[j] = across * y[j] + ey * part;
        }
    };
    // Process the rows in parallel.
    workers_.for_each((n_rows + kRowsPerTask - 1) / kRowsPerTask, [&](int task) {
        const int first = task * kRowsPerTask;
        for (int i = first; i < std::min(first + kRowsPerTask, n_rows); ++i) solve_row(i);
    });
}

/// Adds r / (2 h^2) and the nodes' values interpolated at the sites.
void LongWaves::distribute(const Eigen::VectorXd& r, Eigen::VectorXf& p) {
    const double alone = 1 / (2 * area_per_site_);
    const auto stretch = [&](const Stretch& part) {
        for (int s = part.first_site; s < part.end_site; ++s) {
            const auto i = static_cast<int>(place_(0, s) + kMargin) - kMargin;
            const auto j = static_cast<int>(place_(1, s));
            const float down = place_(0, s) - static_cast<float>(i);
            const float right = place_(1, s) - static_cast<float>(j);
            const std::array<Grid*, 2> grids{x_.get(), y_.get()};
            for (const int c : {0, 1}) {
                const float* const upper = grids[c]->row(i) + j;
                const float* const lower = grids[c]->row(i + 1) + j;
                const float above = upper[0] + right * (upper[1] - upper[0]);
                const float below = lower[0] + right * (lower[1] - lower[0]);
                p[2 * s + c] =
                    static_cast<float>(alone * r[2 * s + c]) + above + down * (below - above);
            }
        }
    };
    workers_.for_each(static_cast<int>(stretches_.size()), [&](int k) { stretch(stretches_[k]); });
}

void LongWaves::apply(const Eigen::VectorXd& r, Eigen::VectorXf& p) {
    p.resize(r.size());
    const std::array<Grid*, 2> grids{x_.get(), y_.get()};
    workers_.for_each(2, [&](int c) { grids[c]->clear(); });
    collect(r);
    workers_.for_each(2, [&](int c) {
        grids[c]->fold();
        grids[c]->to_waves();
    });
    solve();
    workers_.for_each(2, [&](int c) {
        grids[c]->to_nodes();
        grids[c]->repeat();
    });
    distribute(r, p);
}

}  // namespace pcvt
