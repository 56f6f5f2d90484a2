#ifndef springfit_reference_material_h
#define springfit_reference_material_h

#include <springfit/mesh/mesh.h>

#include <deal.II/base/parameter_acceptor.h>

#include <map>
#include <string>

namespace springfit
{
  enum class PlaneState
  {
    stress,
    strain
  };

  /** The constants of a linear isotropic material. */
  struct ElasticConstants
  {
    double youngs_modulus; // Pa
    double poissons_ratio;
    double density; // kg/m^3
  };

  /**
   * What the stiffness of a cell is made of: the Lame constants that hold in
   * the space of the mesh (in plane stress, lambda is E nu / (1 - nu^2)).
   */
  struct LameConstants
  {
    double lambda; // Pa
    double mu;     // Pa
  };

  /** 3-d, and plane strain. */
  LameConstants
  lame_constants(const ElasticConstants &material);

  LameConstants
  lame_constants_plane_stress(const ElasticConstants &material);


  /** A material as a cell meets it. */
  struct CellMaterial
  {
    ElasticConstants constants;
    LameConstants lame;
    double thickness; // m of cells of dimension 2, 1 of others

    /** Has a meaning for cells of dimension 2 only. */
    PlaneState plane_state = PlaneState::stress;
  };

  /** By the material ids of a mesh's cells. */
  using MaterialTable = std::map<dealii::types::material_id, CellMaterial>;


  /** The section "Material". */
  template <int spacedim>
  class Material : public dealii::ParameterAcceptor
  {
  public:
    Material();

    /**
     * The materials of @p mesh.
     *
     * @throws EntryError when a material id of the mesh is not given, or one
     * is given that the mesh does not have; or when a surface in space shall
     * be in plane strain.
     */
    template <int dim>
    MaterialTable
    resolve(const Mesh<dim, spacedim> &mesh) const;

    /**
     * Any linear isotropic material in the plane state and with the thickness
     * of this section, in cells of dimension @p dim.
     */
    template <int dim = spacedim>
    CellMaterial
    with_constants(const ElasticConstants &constants) const;

    PlaneState
    plane_state() const;

    /** @throws EntryError of @p entry when E is not positive or no number of
     * a material, in Pa. */
    void
    check_youngs_modulus(double modulus, const std::string &entry) const;

    /**
     * @throws EntryError, of the given entry, when no material of this plane
     * state has such a ratio.
     */
    void
    check_poissons_ratio(double ratio, const std::string &entry) const;

  private:
    /** A constant for every cell, or one for each of several materials. */
    struct Constant
    {
      std::string entry;
      std::map<std::string, double> by_name; // "" is every material
    };

    void
    check();

    std::string youngs_modulus_text_ = "1e4";
    std::string poissons_ratio_text_ = "0.3";
    std::string density_text_        = "1000";
    std::string plane_state_word_    = "stress";
    double thickness_                = 0.01;

    Constant youngs_modulus_;
    Constant poissons_ratio_;
    Constant density_;

    static Constant
    parse(const std::string &entry, const std::string &text);

    template <int dim>
    static double
    value(const Constant &constant,
          const Mesh<dim, spacedim> &mesh,
          dealii::types::material_id id);
  };
} // namespace springfit

#endif
