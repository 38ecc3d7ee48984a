#include "mesher/plane/energy/energy.hpp"

#include <algorithm>
#include <array>

#include "mesher/base/huge_pages.hpp"
#include "mesher/base/prefetch.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/plane/energy/triangle_terms.hpp"

namespace pcvt::plane {
namespace {

/// A slab, the task of one worker, has at least kSitesPerSlab sites; at most kMostSlabs slabs
/// exist. Most triangles of a slab have all corners among its sites: both are numbered by columns.
constexpr int kSitesPerSlab = 12'500;
constexpr int kMostSlabs = 32;
/// Slabs up to kSitesClearedAtOnce sites clear their sums in advance. Larger slabs, whose sums
/// exceed the cache, clear kSitesCleared sites ahead and prefetch kSitesFetched sites after these.
constexpr int kSitesClearedAtOnce = 16'000;
constexpr int kSitesCleared = 64;
constexpr int kSitesFetched = 192;
/// Sites (points and gradients), and corners, per cache line.
constexpr int kSitesPerLine = 4;
constexpr int kCornersPerLine = 16;
/// The number of blocks by which the prefetch of corners is ahead.
constexpr int kBlocksFetched = 4;
/// Terms much larger than the sum that contains them are not subtracted again, since their rounding
/// would remain: terms with a cotangent above kSteepest, or with a largest part that is too large
/// relative to F, or for many sites relative to the mean over the cells.
constexpr double kSteepest = 32;
constexpr double kLargestPart = 500;
constexpr double kLargestPartOfCell = 5e4;
/// With more than one flip per this number of sites a second pass is cheaper than corrections.
constexpr int kSitesPerFlip = 10;

/// Returns the largest of the numbers below `end`, or -1.
PCVT_TARGET_CLONES int last_below(int end, const int* numbers, int n) {
    int last = -1;
    for (int k = 0; k < n; ++k) last = std::max(last, numbers[k] < end ? numbers[k] : -1);
    return last;
}

void resize(Eigen::Index n, Eigen::VectorXd& sums) {
    if (sums.size() == n) return;
    sums.resize(n);
    prefer_huge_pages(sums);
}

void append(std::vector<int>& list, const std::vector<int>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

/// One task of the pass: a range of sites and a range of triangles.
struct EnergyPass::Slab {
    /// A triangle's terms at a corner in another slab.
    struct Foreign {
        SiteId site;
        double gx;
        double gy;
        double mass;
    };

    int first_site;
    int n_sites;
    double value = 0;
    Suspects suspects = {};
    std::vector<Foreign> foreign = {};
    /// The number of sites whose sums are cleared.
    int n_cleared = 0;
    /// The number of suspect halfedges that were examined and kept, and the number whose adjacent
    /// triangles were prefetched.
    std::size_t n_examined = 0;
    std::size_t n_fetched = 0;

    void run(const MovingDelaunay& delaunay, Energy& energy);

   private:
    void clear_for(const SiteId* corners, int n_corners, const Points& coordinates, Energy& energy);
    void clear(int end, Energy& energy);
    void gather(const MovingDelaunay& delaunay, int first, int n, TriangleBlock& block) const;
    void scatter(const MovingDelaunay& delaunay, int first, int n, const TriangleBlock& block,
                 Energy& energy);
    void suspect(const MovingDelaunay& delaunay, int t, const TriangleBlock& block, int k);
    void examine_suspects(const MovingDelaunay& delaunay);
    std::size_t certify_edges(const MovingDelaunay& delaunay, std::size_t end);
};

namespace {

void add(SiteId site, double gx, double gy, double mass, double* gradients, double* masses) {
    double* gradient = gradients + 2 * std::size_t(site);
    gradient[0] += gx;
    gradient[1] += gy;
    masses[site] += mass;
}

}  // namespace

void EnergyPass::Slab::run(const MovingDelaunay& delaunay, Energy& energy) {
    // Reset the sums and lists.
    value = 0;
    suspects = {};
    foreign.clear();
    n_cleared = 0;
    n_examined = 0;
    n_fetched = 0;
    if (n_sites <= kSitesClearedAtOnce) clear(n_sites, energy);
    // Process the triangles block by block.
    TriangleBlock block;
    for (int done = 0; done < 2 * n_sites; done += TriangleBlock::kSize) {
        const int n = std::min(TriangleBlock::kSize, 2 * n_sites - done);
        gather(delaunay, 2 * first_site + done, n, block);
        block.compute(delaunay.frame());
        clear_for(
            delaunay.triangulation().corner_sites().data() + 3 * std::size_t(2 * first_site + done),
            3 * n, delaunay.coordinates(), energy);
        examine_suspects(delaunay);
        scatter(delaunay, 2 * first_site + done, n, block, energy);
    }
    // Examine the last suspects, and clear sites without triangles here.
    certify_edges(delaunay, suspects.halfedges.size());
    clear(n_sites, energy);
}

/// Clears the sums of the sites up to the given corners, and prefetches the data of the sites that
/// follow.
void EnergyPass::Slab::clear_for(const SiteId* corners, int n_corners, const Points& coordinates,
                                 Energy& energy) {
    if (n_cleared == n_sites) return;
    const int last = last_below(first_site + n_sites, corners, n_corners) - first_site;
    if (last < n_cleared) return;
    clear(std::min(last + kSitesCleared, n_sites), energy);
    const int begin = first_site + n_cleared;
    const int end = std::min(begin + kSitesFetched, first_site + n_sites);
    for (int s = begin; s < end; s += kSitesPerLine) {
        prefetch(coordinates.data() + 2 * std::size_t(s));
        prefetch(energy.gradient.data() + 2 * std::size_t(s));
        prefetch(energy.mass.data() + std::size_t(s));
    }
}

void EnergyPass::Slab::clear(int end, Energy& energy) {
    energy.gradient.segment(2 * (first_site + n_cleared), 2 * (end - n_cleared)).setZero();
    energy.mass.segment(first_site + n_cleared, end - n_cleared).setZero();
    n_cleared = end;
}

void EnergyPass::Slab::gather(const MovingDelaunay& delaunay, int first, int n,
                              TriangleBlock& block) const {
    const SiteId* site = delaunay.triangulation().corner_sites().data() + 3 * std::size_t(first);
    // Prefetch the corners of a later block.
    constexpr int kCorners = 3 * TriangleBlock::kSize;
    for (int c = 0; c < kCorners; c += kCornersPerLine) {
        prefetch(site + kBlocksFetched * kCorners + c);
    }
    block.gather(delaunay.triangulation(), delaunay.coordinates(), first, n);
}

void EnergyPass::Slab::scatter(const MovingDelaunay& delaunay, int first, int n,
                               const TriangleBlock& block, Energy& energy) {
    const SiteId* site = delaunay.triangulation().corner_sites().data() + 3 * std::size_t(first);
    double* const gradients = energy.gradient.data();
    double* const masses = energy.mass.data();
    const auto inside = [first_site = first_site, n_sites = n_sites](SiteId s) {
        return static_cast<unsigned>(s - first_site) < static_cast<unsigned>(n_sites);
    };
    // Terms at sites of other slabs are kept until all slabs have finished.
    const auto add_or_keep = [&](const Foreign& f) {
        if (inside(f.site)) {
            add(f.site, f.gx, f.gy, f.mass, gradients, masses);
        } else {
            foreign.push_back(f);
        }
    };
    double sum = 0;
    for (int k = 0; k < n; ++k, site += 3) {
        // Collect the triangles that the block could not certify.
        if (!(block.thick[k] > 0)) {
            suspects.triangles.push_back(first + k);
            continue;
        }
        if (!(block.acute[k] > 0)) suspect(delaunay, first + k, block, k);
        sum += block.value[k];
        // Add the terms of all three corners.
        if (int(inside(site[0])) & int(inside(site[1])) & int(inside(site[2]))) {
            add(site[0], block.gx0[k], block.gy0[k], block.m0[k], gradients, masses);
            add(site[1], block.gx1[k], block.gy1[k], block.m1[k], gradients, masses);
            add(site[2], block.gx2[k], block.gy2[k], block.m2[k], gradients, masses);
        } else {
            add_or_keep({site[0], block.gx0[k], block.gy0[k], block.m0[k]});
            add_or_keep({site[1], block.gx1[k], block.gy1[k], block.m1[k]});
            add_or_keep({site[2], block.gx2[k], block.gy2[k], block.m2[k]});
        }
    }
    value += sum;
}

void EnergyPass::Slab::suspect(const MovingDelaunay& delaunay, int t, const TriangleBlock& block,
                               int k) {
    suspects.halfedges.push_back(block.opposite_to_largest_angle(t, k));
    delaunay.triangulation().fetch_opposite(suspects.halfedges.back());
}

/// Called once per block: the data of a suspect is prefetched in two steps, one in each of two
/// successive blocks.
void EnergyPass::Slab::examine_suspects(const MovingDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    const std::size_t n_suspects = suspects.halfedges.size();
    for (std::size_t k = n_fetched; k < n_suspects; ++k) {
        t.fetch_triangle(t.opposite(suspects.halfedges[k]));
    }
    n_fetched = n_suspects - certify_edges(delaunay, n_fetched);
}

/// Removes the certified halfedges from the unexamined suspects before `end`; returns their number.
std::size_t EnergyPass::Slab::certify_edges(const MovingDelaunay& delaunay, std::size_t end) {
    const auto begin = suspects.halfedges.begin();
    const auto kept = std::remove_if(begin + n_examined, begin + end,
                                     [&](int h) { return delaunay.is_certainly_delaunay(h); });
    suspects.halfedges.erase(kept, begin + end);
    n_examined = static_cast<std::size_t>(kept - begin);
    return end - n_examined;
}

EnergyPass::EnergyPass(MovingDelaunay& delaunay, Workers& workers)
    : delaunay_(delaunay), workers_(workers) {
    const int n_slabs = std::clamp(delaunay.n_sites() / kSitesPerSlab, 1, kMostSlabs);
    int first = 0;
    for (int k = 1; k <= n_slabs; ++k) {
        const auto end = static_cast<int>(std::int64_t{delaunay.n_sites()} * k / n_slabs);
        slabs_.push_back({.first_site = first, .n_sites = end - first});
        first = end;
    }
}

EnergyPass::~EnergyPass() = default;

Suspects EnergyPass::run(Energy& energy) {
    resize(2 * delaunay_.n_sites(), energy.gradient);
    resize(delaunay_.n_sites(), energy.mass);
    workers_.for_each(static_cast<int>(slabs_.size()),
                      [&](int k) { slabs_[k].run(delaunay_, energy); });
    energy.value = 0;
    Suspects suspects;
    for (const Slab& slab : slabs_) {
        energy.value += slab.value;
        for (const Slab::Foreign& f : slab.foreign)
            add(f.site, f.gx, f.gy, f.mass, energy.gradient.data(), energy.mass.data());
        append(suspects.triangles, slab.suspects.triangles);
        append(suspects.halfedges, slab.suspects.halfedges);
    }
    for (const int t : suspects.triangles)
        append(suspects.halfedges, {3 * t, 3 * t + 1, 3 * t + 2});
    return suspects;
}

void EnergyPass::add_terms(int triangle, double sign) {
    const TorusTriangulation& t = delaunay_.triangulation();
    std::array<Image, 3> corner;
    for (int k = 0; k < 3; ++k) {
        const Corner c = t.corner(3 * triangle + k);
        corner[k] = image(delaunay_.coordinates(), c.site, c.offset);
    }
    const TriangleTerms terms = triangle_terms(difference(corner[0], corner[1]),
                                               difference(corner[0], corner[2]), delaunay_.frame());
    energy_->value += sign * terms.value;
    for (int k = 0; k < 3; ++k) {
        const Vec2 g = sign * terms.gradient[k];
        add(corner[k].site, g.x(), g.y(), sign * terms.mass[k], energy_->gradient.data(),
            energy_->mass.data());
    }
    steepest_ = std::max(steepest_, terms.steepest);
    largest_part_ = std::max(largest_part_, terms.largest_part);
}

bool EnergyPass::corrections_pay() const {
    return steepest_ <= kSteepest && n_corrections_ <= 1 + delaunay_.n_sites() / kSitesPerFlip;
}

/// Valid after the last flip, when F has a few correct digits at least.
bool EnergyPass::corrections_are_exact() const {
    const double limit = std::min(kLargestPart, kLargestPartOfCell / delaunay_.n_sites());
    return n_corrections_ == 0 || !(largest_part_ > limit * energy_->value);
}

void EnergyPass::fetch(SiteId site) const {
    prefetch(energy_->gradient.data() + 2 * std::size_t(site));
    prefetch(energy_->mass.data() + std::size_t(site));
}

void EnergyPass::before_flip(int h) {
    ++n_corrections_;
    if (!corrections_pay()) return;
    add_terms(h / 3, -1);
    add_terms(delaunay_.triangulation().opposite(h) / 3, -1);
}

void EnergyPass::after_flip(int h) {
    if (!corrections_pay()) return;
    add_terms(h / 3, 1);
    add_terms(delaunay_.triangulation().opposite(h) / 3, 1);
}

bool EnergyPass::evaluate(Energy& energy) {
    energy_ = &energy;
    for (;;) {
        Suspects suspects = run(energy);
        const std::vector<int> inverted = delaunay_.inverted(suspects);
        if (!inverted.empty()) {
            if (!delaunay_.untangle(inverted, suspects)) return false;
            continue;
        }
        for (const int t : suspects.triangles) add_terms(t, 1);
        steepest_ = 0;
        largest_part_ = 0;
        n_corrections_ = 0;
        delaunay_.flip(suspects, this);
        if (corrections_pay() && corrections_are_exact()) break;
    }
    return true;
}

}  // namespace pcvt::plane
