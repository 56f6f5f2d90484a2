#ifndef springfit_reference_material_law_h
#define springfit_reference_material_law_h

#include <springfit/core/words.h>
#include <springfit/reference/material.h>

#include <Eigen/Core>

#include <optional>

namespace springfit
{
  /**
   * How the finite elements answer large deformations. All laws have the same
   * stiffness at rest.
   */
  enum class MaterialLaw
  {
    linear,              // small strains, small rotations
    st_venant_kirchhoff, // linear between Green's strain and S
    neo_hookean,         // compressible, after Simo and Pister (1984)
    stable_neo_hookean   // finite for every F, after Smith et al. (2018)
  };

  const WordTable<MaterialLaw> &
  material_law_words();


  /**
   * The state of a hyperelastic material at a point, total Lagrangian. F and
   * P, as vectors, are in columns: entry i + dim k is component (i, k).
   */
  template <int dim>
  struct MaterialState
  {
    static constexpr int n_components = dim * dim;

    double energy;                          // J/m^3
    Eigen::Matrix<double, dim, dim> stress; // P in Pa, 1st Piola-Kirchhoff
    Eigen::Matrix<double, n_components, n_components>
      tangent; // dP/dF in Pa, symmetric
  };

  /**
   * The energy lambda (tr E)^2 / 2 + mu E:E of Green's strain E. With the
   * constants of plane stress it is the law in plane stress (S_33 = 0).
   *
   * @param F deformation gradient
   */
  template <int dim>
  MaterialState<dim>
  st_venant_kirchhoff(const Eigen::Matrix<double, dim, dim> &F,
                      const LameConstants &lame);

  /**
   * The energy mu (tr C - 3 - 2 ln J) / 2 + lambda (ln J)^2 / 2 (Simo and
   * Pister 1984; Bonet and Wood 2008, eq. 6.27) in 3-d and in plane strain.
   * Nothing where det F <= 0: no finite energy turns material inside out.
   */
  template <int dim>
  std::optional<MaterialState<dim>>
  neo_hookean(const Eigen::Matrix<double, dim, dim> &F,
              const LameConstants &lame);

  /**
   * The same in plane stress: the stretch across the plane is the one that
   * leaves no stress there. @p lame has the lambda of plane stress.
   */
  std::optional<MaterialState<2>>
  neo_hookean_plane_stress(const Eigen::Matrix2d &F, const LameConstants &lame);

  /**
   * The energy mu (F:F - dim) / 2 - mu (J - 1) + (lambda + mu) (J - 1)^2 / 2:
   * B. Smith, F. de Goes, T. Kim, "Stable neo-Hookean flesh simulation", ACM
   * Transactions on Graphics 37 (2018), without the logarithm, and with the
   * Lame constants of the tangent at rest. A polynomial of F: finite, and
   * smooth, also where det F <= 0.
   *
   * In the plane it is a law of its own with the lambda of @p lame. In plane
   * stress it agrees with the law in 3-d at small strains only.
   */
  template <int dim>
  MaterialState<dim>
  stable_neo_hookean(const Eigen::Matrix<double, dim, dim> &F,
                     const LameConstants &lame);
} // namespace springfit

#endif
