#ifndef springfit_fit_cell_material_h
#define springfit_fit_cell_material_h

namespace springfit
{
  /**
   * What the published formulas know of a cell's material. In 2-d they are
   * for plane stress; plane strain is the plane stress of a material with
   * E / (1 - nu^2) and nu / (1 - nu), which is then given here.
   */
  struct IsotropicMaterial
  {
    double youngs_modulus; // Pa
    double poissons_ratio;
    double thickness; // m in 2-d, 1 in 3-d

    /**
     * Whether a stress across the plane vanishes: what large deformations of
     * two materials that look alike at rest tell apart.
     */
    bool is_in_plane_stress = false;
  };

  /**
   * The material that has these Lame constants (Pa) in the plane (@p dim 2: in
   * plane stress lambda is E nu / (1 - nu^2)) or in space.
   */
  inline IsotropicMaterial
  isotropic_material(const int dim,
                     const double lambda,
                     const double mu,
                     const double thickness)
  {
    const double ratio = lambda / (lambda + (dim == 2 ? 2. * mu : mu));
    const double nu    = dim == 2 ? ratio : ratio / 2.;
    return {2. * mu * (1. + nu), nu, thickness};
  }

  /** G = E / (2 (1 + nu)), Pa */
  inline double
  shear_modulus(const IsotropicMaterial &material)
  {
    return material.youngs_modulus / (2. * (1. + material.poissons_ratio));
  }

  /** The lambda that isotropic_material() was given, Pa. */
  inline double
  first_lame_constant(const int dim, const IsotropicMaterial &material)
  {
    const double nu = material.poissons_ratio;
    return 2. * shear_modulus(material) * nu / (1. - (dim == 2 ? nu : 2. * nu));
  }
} // namespace springfit

#endif
