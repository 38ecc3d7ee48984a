#pragma once

#include "mesher/optimize/objective.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::plane {

/// The linear map E from the free variables of orbits to displacements of all sites.
///
/// Each orbit that can move has a pair of variables. Site s of an orbit in general positions moves
/// by R_s z, with R_s the linear part of the operation that maps the representative to s. An orbit
/// on mirrors moves by sqrt(2) z_0 d_s, with d_s the unit vector along the mirror of s, and its z_1
/// has no effect. Orbits at centres have no variables. Therefore E^T E = c 1 on all other
/// variables, c the order of the group.
struct OrbitEmbedding {
    /// Per site: the index of its pair, or -1 at a centre.
    std::vector<int> pair;
    /// Per site: the 2 x 2 block of E, row by row.
    std::vector<std::array<double, 4>> block;
    /// Per pair: the site whose image each other site of its orbit is, and their number.
    std::vector<SiteId> representative;
    std::vector<int> n_sites;
    /// c
    double order = 1;
};

/// Ties the moves of the triangulation's sites, so that orbits remain orbits to the last bit, and
/// returns the map in the order and the frame of the triangulation.
/// @param delaunay  of sites.sites.
OrbitEmbedding tie_orbits(const SymmetricSites& sites, MovingDelaunay& delaunay);

/// An objective restricted to symmetric displacements: x = x_0 + E z, gradient E^T g, Hessian E^T H
/// E, with x, g and H of the objective of all sites. Residuals are those of all sites.
///
/// A preconditioner becomes E^T M^-1 E / c^2, which is symmetric and positive definite whether M
/// commutes with the group or not. If H and the group commute, the inverse of E^T H E is E^T H^-1 E
/// / c^2; M is as good an approximation here as it is without symmetry.
///
/// Example usage:
///
///     MovingDelaunay delaunay(symmetric.sites);
///     CvtObjective all(delaunay, workers);
///     SymmetricObjective objective(all, tie_orbits(symmetric, delaunay));
///     minimize_lbfgs(objective, options, workers);
///
/// Laws, tested by number:
///   (1) The value is that of the objective of all sites.
///   (2) The gradient is the derivative of the value, and the Hessian that of the gradient.
class SymmetricObjective final : public Objective {
   public:
    /// @param all  must outlive this object; its variables are displacements of the embedding's
    ///             sites, and its value has the symmetry.
    SymmetricObjective(Objective& all, OrbitEmbedding embedding);

    Eigen::Index n_variables() const override;
    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override;
    void accept() override;
    void reject() override;
    bool precondition(Evaluation& evaluation) override;
    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override;
    bool has_hessian() const override { return all_.has_hessian(); }
    void hessian(BlockMatrix& hessian) const override;

   private:
    template <class Vector>
    void expand(const Vector& z, Vector& x) const;
    template <class Vector>
    void fold(const Vector& g, Vector& folded) const;
    /// The evaluation of all sites that folds to the given one; without preconditioned gradient.
    Evaluation expanded(const Evaluation& evaluation) const;

    Objective& all_;
    OrbitEmbedding embedding_;
    Eigen::VectorXf direction_;
    Evaluation evaluation_;
    /// Whether a trial is neither accepted nor rejected, so that direction_ must not change.
    bool pending_ = false;
};

}  // namespace pcvt::plane
