#include <springfit/core/plane_stress.h>
#include <springfit/reference/material_law.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace springfit
{
  namespace
  {
    template <int dim>
    using Tensor = Eigen::Matrix<double, dim, dim>;

    template <int dim>
    using Tangent = decltype(MaterialState<dim>::tangent);

    /** A_kl B_ij in row (i, k), column (j, l). */
    template <int dim>
    Tangent<dim>
    product(const Tensor<dim> &A, const Tensor<dim> &B)
    {
      Tangent<dim> tangent;
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l)
          tangent.template block<dim, dim>(dim * k, dim * l) = A(k, l) * B;
      return tangent;
    }

    /** p V_ik V_jl + q V_il V_jk in row (i, k), column (j, l). */
    template <int dim>
    Tangent<dim>
    products(const Tensor<dim> &V, const double p, const double q)
    {
      Tangent<dim> tangent;
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l)
          tangent.template block<dim, dim>(dim * k, dim * l) =
            p * V.col(k) * V.col(l).transpose() +
            q * V.col(l) * V.col(k).transpose();
      return tangent;
    }

    // cof F = dJ/dF and its derivative are polynomials, det F = 0 or not.

    Eigen::Matrix2d
    cofactor(const Eigen::Matrix2d &F)
    {
      Eigen::Matrix2d cof;
      cof << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
      return cof;
    }

    Eigen::Matrix3d
    cofactor(const Eigen::Matrix3d &F)
    {
      Eigen::Matrix3d cof;
      for (int k = 0; k < 3; ++k)
        cof.col(k) = F.col((k + 1) % 3).cross(F.col((k + 2) % 3));
      return cof;
    }

    Tangent<2>
    cofactor_derivative(const Eigen::Matrix2d &)
    {
      Eigen::Matrix2d e;
      e << 0., 1., -1., 0.;
      return product<2>(e, e);
    }

    Tangent<3>
    cofactor_derivative(const Eigen::Matrix3d &F)
    {
      Tangent<3> tangent = Tangent<3>::Zero();
      for (int k = 0; k < 3; ++k)
        {
          const int l             = (k + 1) % 3;
          const Eigen::Vector3d f = F.col((k + 2) % 3);
          Eigen::Matrix3d cross; // cross * x = f x x
          cross << 0., -f[2], f[1], f[2], 0., -f[0], -f[1], f[0], 0.;
          tangent.block<3, 3>(3 * k, 3 * l) = -cross;
          tangent.block<3, 3>(3 * l, 3 * k) = cross;
        }
      return tangent;
    }
  } // namespace

  const WordTable<MaterialLaw> &
  material_law_words()
  {
    static const WordTable<MaterialLaw> table = {
      {MaterialLaw::linear, "linear"},
      {MaterialLaw::st_venant_kirchhoff, "st venant-kirchhoff"},
      {MaterialLaw::neo_hookean, "neo-hookean"},
      {MaterialLaw::stable_neo_hookean, "stable neo-hookean"}};
    return table;
  }

  template <int dim>
  MaterialState<dim>
  st_venant_kirchhoff(const Tensor<dim> &F, const LameConstants &lame)
  {
    const Tensor<dim> I = Tensor<dim>::Identity();
    const Tensor<dim> E = 0.5 * (F.transpose() * F - I);
    const Tensor<dim> S = lame.lambda * E.trace() * I + 2. * lame.mu * E;
    MaterialState<dim> state;
    state.energy =
      0.5 * lame.lambda * E.trace() * E.trace() + lame.mu * E.squaredNorm();
    state.stress  = F * S;
    state.tangent = product<dim>(S, I) +
                    lame.mu * product<dim>(I, F * F.transpose()) +
                    products<dim>(F, lame.lambda, lame.mu);
    return state;
  }

  template <int dim>
  std::optional<MaterialState<dim>>
  neo_hookean(const Tensor<dim> &F, const LameConstants &lame)
  {
    const double J = F.determinant();
    if (!(J > 0.))
      return {};
    const double log_J    = std::log(J);
    const double pressure = lame.lambda * log_J;
    const Tensor<dim> V   = F.inverse().transpose();

    MaterialState<dim> state;
    state.energy = 0.5 * lame.mu * (F.squaredNorm() - dim - 2. * log_J) +
                   0.5 * pressure * log_J;
    state.stress  = lame.mu * (F - V) + pressure * V;
    state.tangent = lame.mu * Tangent<dim>::Identity() +
                    products<dim>(V, lame.lambda, lame.mu - pressure);
    return state;
  }

  std::optional<MaterialState<2>>
  neo_hookean_plane_stress(const Eigen::Matrix2d &F, const LameConstants &lame)
  {
    const double J_plane = F.determinant();
    if (!(J_plane > 0.))
      return {};
    const auto squared_stretch =
      squared_stretch_across(std::log(J_plane), lame.lambda, lame.mu);
    if (!squared_stretch)
      return {};
    const double mu         = lame.mu;
    const double c          = *squared_stretch;
    const double log_J      = std::log(J_plane) + 0.5 * std::log(c);
    const Eigen::Matrix2d V = F.inverse().transpose();

    // lambda ln J = mu (1 - c), whatever lambda is.
    MaterialState<2> state;
    state.energy = 0.5 * mu * (F.squaredNorm() + c - 3. - 2. * log_J) +
                   0.5 * mu * (1. - c) * log_J;
    state.stress  = mu * (F - c * V);
    state.tangent = mu * Tangent<2>::Identity() +
                    products<2>(V,
                                2. * mu * lame.lambda /
                                  (2. * mu - lame.lambda + lame.lambda / c),
                                mu * c);
    return state;
  }

  template <int dim>
  MaterialState<dim>
  stable_neo_hookean(const Tensor<dim> &F, const LameConstants &lame)
  {
    const double growth   = F.determinant() - 1.;
    const double bulk     = lame.lambda + lame.mu;
    const double pressure = bulk * growth - lame.mu;
    const Tensor<dim> cof = cofactor(F);

    MaterialState<dim> state;
    state.energy = 0.5 * lame.mu * (F.squaredNorm() - dim) - lame.mu * growth +
                   0.5 * bulk * growth * growth;
    state.stress  = lame.mu * F + pressure * cof;
    state.tangent = lame.mu * Tangent<dim>::Identity() +
                    products<dim>(cof, bulk, 0.) +
                    pressure * cofactor_derivative(F);
    return state;
  }

  template MaterialState<2>
  st_venant_kirchhoff<2>(const Eigen::Matrix2d &, const LameConstants &);
  template MaterialState<3>
  st_venant_kirchhoff<3>(const Eigen::Matrix3d &, const LameConstants &);
  template std::optional<MaterialState<2>>
  neo_hookean<2>(const Eigen::Matrix2d &, const LameConstants &);
  template std::optional<MaterialState<3>>
  neo_hookean<3>(const Eigen::Matrix3d &, const LameConstants &);
  template MaterialState<2>
  stable_neo_hookean<2>(const Eigen::Matrix2d &, const LameConstants &);
  template MaterialState<3>
  stable_neo_hookean<3>(const Eigen::Matrix3d &, const LameConstants &);
} // namespace springfit
