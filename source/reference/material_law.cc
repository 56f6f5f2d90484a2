#include <springfit/reference/material_law.h>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <optional>

namespace springfit
{
  namespace
  {
    template <int dim>
    using Tensor = Eigen::Matrix<double, dim, dim>;

    /** The index pair of a Voigt component. */
    template <int dim>
    std::array<int, 2>
    voigt_pair(const int component)
    {
      if (component < dim)
        return {{component, component}};
      if (dim == 2)
        return {{0, 1}};
      constexpr std::array<std::array<int, 2>, 3> shear = {
        {{{0, 1}}, {{1, 2}}, {{2, 0}}}};
      return shear[component - dim];
    }

    /**
     * p A_ij A_kl + q (A_ik A_jl + A_il A_jk) as a Voigt matrix; A symmetric.
     */
    template <int dim>
    auto
    voigt_products(const Tensor<dim> &A, const double p, const double q)
    {
      constexpr int n = MaterialState<dim>::n_voigt;
      Eigen::Matrix<double, n, n> matrix;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
          {
            const auto [i, j] = voigt_pair<dim>(a);
            const auto [k, l] = voigt_pair<dim>(b);
            matrix(a, b)      = p * A(i, j) * A(k, l) +
                           q * (A(i, k) * A(j, l) + A(i, l) * A(j, k));
          }
      return matrix;
    }

    /**
     * The square c of the stretch across a plane without stress: the root of
     * mu (c - 1) + lambda ln J = 0, ln J = ln J_plane + ln(c) / 2, times
     * 1 - lambda* / (2 mu) so that the equation holds for every nu <= 0.5.
     * Newton's method in ln c: for nu >= 0 the function is convex and rising,
     * and the start is right of the root or one step away from it. For nu < 0
     * there may be no root under much compression: nothing then.
     */
    std::optional<double>
    squared_stretch_across(const double log_J_plane, const LameConstants &lame)
    {
      const double p = lame.mu - 0.5 * lame.lambda;
      double log_c   = 0.;
      for (int step = 0; step < 100; ++step)
        {
          const double c = std::exp(log_c);
          const double value =
            p * (c - 1.) + lame.lambda * (log_J_plane + 0.5 * log_c);
          const double change = -value / (p * c + 0.5 * lame.lambda);
          log_c += change;
          if (std::abs(change) <= 1e-14 * (1. + std::abs(log_c)))
            return std::exp(log_c);
        }
      return {};
    }
  } // namespace

  const WordTable<MaterialLaw> &
  material_law_words()
  {
    static const WordTable<MaterialLaw> table = {
      {MaterialLaw::linear, "linear"},
      {MaterialLaw::st_venant_kirchhoff, "st venant-kirchhoff"},
      {MaterialLaw::neo_hookean, "neo-hookean"}};
    return table;
  }

  template <int dim>
  MaterialState<dim>
  st_venant_kirchhoff(const Tensor<dim> &F, const LameConstants &lame)
  {
    const Tensor<dim> I = Tensor<dim>::Identity();
    const Tensor<dim> E = 0.5 * (F.transpose() * F - I);
    MaterialState<dim> state;
    state.energy =
      0.5 * lame.lambda * E.trace() * E.trace() + lame.mu * E.squaredNorm();
    state.stress  = lame.lambda * E.trace() * I + 2. * lame.mu * E;
    state.tangent = voigt_products<dim>(I, lame.lambda, lame.mu);
    return state;
  }

  template <int dim>
  std::optional<MaterialState<dim>>
  neo_hookean(const Tensor<dim> &F, const LameConstants &lame)
  {
    const double J = F.determinant();
    if (!(J > 0.))
      return {};
    const double log_J        = std::log(J);
    const Tensor<dim> C       = F.transpose() * F;
    const Tensor<dim> inverse = C.inverse();
    const double pressure     = lame.lambda * log_J;

    MaterialState<dim> state;
    state.energy =
      0.5 * lame.mu * (C.trace() - dim - 2. * log_J) + 0.5 * pressure * log_J;
    state.stress =
      lame.mu * (Tensor<dim>::Identity() - inverse) + pressure * inverse;
    state.tangent =
      voigt_products<dim>(inverse, lame.lambda, lame.mu - pressure);
    return state;
  }

  std::optional<MaterialState<2>>
  neo_hookean_plane_stress(const Eigen::Matrix2d &F, const LameConstants &lame)
  {
    const double J_plane = F.determinant();
    if (!(J_plane > 0.))
      return {};
    const auto squared_stretch =
      squared_stretch_across(std::log(J_plane), lame);
    if (!squared_stretch)
      return {};
    const double mu               = lame.mu;
    const double c                = *squared_stretch;
    const double log_J            = std::log(J_plane) + 0.5 * std::log(c);
    const Eigen::Matrix2d C       = F.transpose() * F;
    const Eigen::Matrix2d inverse = C.inverse();

    // lambda ln J = mu (1 - c), whatever lambda is.
    MaterialState<2> state;
    state.energy = 0.5 * mu * (C.trace() + c - 3. - 2. * log_J) +
                   0.5 * mu * (1. - c) * log_J;
    state.stress = mu * (Eigen::Matrix2d::Identity() - c * inverse);
    state.tangent =
      voigt_products<2>(inverse,
                        2. * mu * lame.lambda /
                          (2. * mu - lame.lambda + lame.lambda / c),
                        mu * c);
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
} // namespace springfit
