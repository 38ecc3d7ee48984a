#include "mesher/plane/energy/long_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "mesher/plane/energy/fourier_transform.hpp"

namespace pcvt::plane {
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

using Number = std::complex<float>;

/// The product of finite numbers; the operator also treats infinite ones.
Number product(const Number& z, const Number& w) {
    return {z.real() * w.real() - z.imag() * w.imag(), z.real() * w.imag() + z.imag() * w.real()};
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

/// The values (x, y) at the nodes of a periodic grid as complex numbers x + iy, with additional
/// rows on both sides and an additional column that repeat others; the Fourier transform uses the
/// same memory.
class LongWaves::Grid {
   public:
    Grid(int n_rows, int n_columns);

    int n_rows() const { return n_rows_; }
    int n_columns() const { return n_columns_; }
    /// Returns row i, -kMargin <= i <= n_rows() + kMargin; each row also has column n_columns().
    Number* row(int i) { return &numbers_[std::ptrdiff_t(i + kMargin) * (n_columns_ + 1)]; }

    void clear() { std::fill(numbers_.begin(), numbers_.end(), Number{}); }
    /// Adds the repeated rows and column to the originals.
    void fold();
    void repeat();
    void to_waves(Workers& workers);
    /// The inverse, times the number of nodes.
    void to_nodes(Workers& workers);

   private:
    /// The numbers in a row or a column, and the distances between them and between two series.
    struct Layout {
        std::ptrdiff_t along;
        std::ptrdiff_t across;
        int n_series;
    };
    void transform(const FourierTransform& transform, const Layout& layout, bool is_inverse,
                   Workers& workers);
    void transform_rows(bool is_inverse, Workers& workers);
    void transform_columns(bool is_inverse, Workers& workers);

    int n_rows_;
    int n_columns_;
    std::vector<Number> numbers_;
    FourierTransform of_row_;
    FourierTransform of_column_;
};

LongWaves::Grid::Grid(int n_rows, int n_columns)
    : n_rows_(n_rows),
      n_columns_(n_columns),
      numbers_(std::size_t(n_rows + 2 * kMargin + 1) * (n_columns + 1)),
      of_row_(n_columns),
      of_column_(n_rows) {}

void LongWaves::Grid::fold() {
    for (int i = -kMargin; i <= n_rows_ + kMargin; ++i) {
        if (i >= 0 && i < n_rows_) continue;
        Number* const repeated = row(((i % n_rows_) + n_rows_) % n_rows_);
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

/// Transforms the series of a layout, kLanes in each task.
void LongWaves::Grid::transform(const FourierTransform& transform, const Layout& layout,
                                bool is_inverse, Workers& workers) {
    using Element = FourierTransform::Element;
    const int n = transform.length();
    // The inverse exchanges real and imaginary parts.
    constexpr auto kReal = &Element::real;
    constexpr auto kImaginary = &Element::imaginary;
    const auto first = is_inverse ? kImaginary : kReal;
    const auto second = is_inverse ? kReal : kImaginary;
    const auto transform_some = [&](int task) {
        const int begin = task * FourierTransform::kLanes;
        const int n_lanes = std::min(FourierTransform::kLanes, layout.n_series - begin);
        Number* const corner = row(0) + begin * layout.across;
        const auto elements = std::make_unique<Element[]>(2 * std::size_t(n));
        for (int k = 0; k < n; ++k) {
            const Number* const from = corner + k * layout.along;
            for (int lane = 0; lane < n_lanes; ++lane) {
                (elements[k].*first)[lane] = from[lane * layout.across].real();
                (elements[k].*second)[lane] = from[lane * layout.across].imag();
            }
        }
        transform.apply(&elements[0], &elements[n]);
        for (int k = 0; k < n; ++k) {
            Number* const to = corner + k * layout.along;
            for (int lane = 0; lane < n_lanes; ++lane) {
                to[lane * layout.across] = {(elements[k].*first)[lane],
                                            (elements[k].*second)[lane]};
            }
        }
    };
    workers.for_each((layout.n_series + FourierTransform::kLanes - 1) / FourierTransform::kLanes,
                     transform_some);
}

void LongWaves::Grid::transform_rows(bool is_inverse, Workers& workers) {
    const Layout rows{.along = 1, .across = n_columns_ + 1, .n_series = n_rows_};
    transform(of_row_, rows, is_inverse, workers);
}

void LongWaves::Grid::transform_columns(bool is_inverse, Workers& workers) {
    const Layout columns{.along = n_columns_ + 1, .across = 1, .n_series = n_columns_};
    transform(of_column_, columns, is_inverse, workers);
}

void LongWaves::Grid::to_waves(Workers& workers) {
    transform_rows(false, workers);
    transform_columns(false, workers);
}

void LongWaves::Grid::to_nodes(Workers& workers) {
    transform_columns(true, workers);
    transform_rows(true, workers);
}

LongWaves::LongWaves(const MovingDelaunay& delaunay, Workers& workers)
    : workers_(workers),
      frame_(delaunay.frame()),
      across_(coordinate_across_columns(delaunay.gram())),
      area_per_site_(delaunay.spacing() * delaunay.spacing()),
      n_sites_(delaunay.n_sites()) {
    const double per_length = kNodesPerSpacing / delaunay.spacing();
    const auto n_nodes = [&](double length) {
        return FourierTransform::good_length(static_cast<int>(std::ceil(per_length * length)));
    };
    const int nodes[] = {n_nodes(frame_.ax), n_nodes(Vec2(frame_.bx, frame_.by).norm())};
    grid_ = std::make_unique<Grid>(nodes[across_], nodes[1 - across_]);
    place_sites(delaunay);
}

LongWaves::~LongWaves() = default;

void LongWaves::place_sites(const MovingDelaunay& delaunay) {
    place_.resize(2, n_sites_);
    for (SiteId s = 0; s < n_sites_; ++s) {
        const Vec2 u = delaunay.coordinates().col(s);
        place_.col(s) << on_grid(u[across_], grid_->n_rows(), kMargin),
            on_grid(u[1 - across_], grid_->n_columns(), 0);
    }
    for (int first = 0; first < n_sites_; first += kSitesPerStretch) {
        const int end = std::min(first + kSitesPerStretch, n_sites_);
        const auto rows = place_.row(0).segment(first, end - first);
        stretches_.push_back(
            {first, end, static_cast<int>(rows.minCoeff()), static_cast<int>(rows.maxCoeff()) + 2});
    }
    if (!neighbours_only()) stretches_ = {{0, n_sites_, 0, grid_->n_rows() + 1}};
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
            const Number number(static_cast<float>(r[2 * s]), static_cast<float>(r[2 * s + 1]));
            Number* const upper = grid_->row(i) + j;
            Number* const lower = grid_->row(i + 1) + j;
            upper[0] += (1 - down) * (1 - right) * number;
            upper[1] += (1 - down) * right * number;
            lower[0] += down * (1 - right) * number;
            lower[1] += down * right * number;
        }
    };
    // Process alternate stretches in parallel: they use different rows.
    const auto n = static_cast<int>(stretches_.size());
    for (const int parity : {0, 1}) {
        workers_.for_each((n + 1 - parity) / 2, [&](int k) { add(stretches_[2 * k + parity]); });
    }
}

/// The wave vector of i periods across the rows and j along them.
Vec2 LongWaves::wave_vector(int i, int j) const {
    if (across_ == 1) std::swap(i, j);
    const double kx = 2 * std::numbers::pi * i / frame_.ax;
    return {kx, (2 * std::numbers::pi * j - kx * frame_.bx) / frame_.by};
}

/// Divides the amplitude of each wave by its stiffness.
///
/// With the amplitudes X and Y of x and y for a wave k, and those of -k, which are their
/// conjugates, the grid holds Z(k) = X + iY and conj Z(-k) = X - iY. Therefore the symmetric matrix
/// with the rows (a, b) and (b, c), which acts on (X, Y), returns
///
///   Z'(k) = (a + c) / 2 Z(k) + ((a - c) / 2 + ib) conj Z(-k).
void LongWaves::solve() {
    // Compute the normalisation.
    const int n_rows = grid_->n_rows();
    const int n_columns = grid_->n_columns();
    // 1 / n normalises the sum over sites; the transforms' factor N, the number of nodes, cancels
    // against the 1 / N of the sum over nodes.
    const double factor = kShare / (area_per_site_ * area_per_site_ * n_sites_);
    // Process the waves k and -k of one row i >= 0.
    const auto solve_row = [&](int i) {
        Number* const waves = grid_->row(i);
        Number* const opposite = grid_->row((n_rows - i) % n_rows);
        // Waves with a largest index have two signs, and the one with the least is constant.
        if (2 * i == n_rows) std::fill_n(waves, n_columns, Number{});
        waves[n_columns / 2] = opposite[n_columns / 2] = 0;
        if (i == 0) waves[0] = 0;
        const int end = i == 0 ? n_columns / 2 : 2 * i == n_rows ? 0 : n_columns;
        for (int j = i == 0 ? 1 : 0; j < end; ++j) {
            const int index = 2 * j < n_columns ? j : j - n_columns;
            const Vec2 k = wave_vector(i, index);
            const double square = k.squaredNorm();
            const double across = factor / (kAcross * square);
            const double more_along = factor / (kAlong * square) - across;
            const auto mean = static_cast<float>(across + more_along / 2);
            const Number turned(
                static_cast<float>(more_along * (k.x() * k.x() - k.y() * k.y()) / (2 * square)),
                static_cast<float>(more_along * k.x() * k.y() / square));
            Number& wave = waves[j];
            Number& other = opposite[(n_columns - j) % n_columns];
            const Number before = wave;
            wave = mean * wave + product(turned, std::conj(other));
            other = mean * other + product(turned, std::conj(before));
        }
    };
    // Process the rows in parallel.
    const int n_pairs = n_rows / 2 + 1;
    workers_.for_each((n_pairs + kRowsPerTask - 1) / kRowsPerTask, [&](int task) {
        const int first = task * kRowsPerTask;
        for (int i = first; i < std::min(first + kRowsPerTask, n_pairs); ++i) solve_row(i);
    });
}

/// Adds r / (2 h^2) and the nodes' values interpolated at the sites.
void LongWaves::distribute(const Eigen::VectorXd& r, Eigen::VectorXf& p) {
    const double local = 1 / (2 * area_per_site_);
    const auto stretch = [&](const Stretch& part) {
        for (int s = part.first_site; s < part.end_site; ++s) {
            const auto i = static_cast<int>(place_(0, s) + kMargin) - kMargin;
            const auto j = static_cast<int>(place_(1, s));
            const float down = place_(0, s) - static_cast<float>(i);
            const float right = place_(1, s) - static_cast<float>(j);
            const Number* const upper = grid_->row(i) + j;
            const Number* const lower = grid_->row(i + 1) + j;
            const Number above = upper[0] + right * (upper[1] - upper[0]);
            const Number below = lower[0] + right * (lower[1] - lower[0]);
            const Number moved = above + down * (below - above);
            p[2 * s] = static_cast<float>(local * r[2 * s]) + moved.real();
            p[2 * s + 1] = static_cast<float>(local * r[2 * s + 1]) + moved.imag();
        }
    };
    workers_.for_each(static_cast<int>(stretches_.size()), [&](int k) { stretch(stretches_[k]); });
}

void LongWaves::apply(const Eigen::VectorXd& r, Eigen::VectorXf& p) {
    p.resize(r.size());
    grid_->clear();
    collect(r);
    grid_->fold();
    grid_->to_waves(workers_);
    solve();
    grid_->to_nodes(workers_);
    grid_->repeat();
    distribute(r, p);
}

}  // namespace pcvt::plane
