#ifndef springfit_studies_mixed_body_h
#define springfit_studies_mixed_body_h

#include <springfit/calibration/cell_network.h>
#include <springfit/reference/cell_energy.h>
#include <springfit/response/elastic_body.h>
#include <springfit/studies/calibrated_scene.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * A mesh each of whose cells has one of several models on the same nodes: the
   * networks of a calibrated scene by their order, and the finite elements
   * after them.
   */
  template <int dim, int spacedim>
  class MixedBody
  {
  public:
    /** @p calibrated must outlive the object. */
    MixedBody(const CalibratedScene<dim, spacedim> &calibrated,
              MaterialLaw law,
              Kinematics kinematics);

    /** Their number, finite elements included. */
    unsigned int
    n_models() const;

    /** "stable_neo_hookean_volume", and "fem" as the last. */
    std::string
    name(unsigned int model) const;

    /** @param models by cell */
    SpringNetwork
    network(const std::vector<unsigned int> &models) const;

    std::unique_ptr<const BodyOfMembers>
    body(const std::vector<unsigned int> &models) const;

    /** Of finite elements everywhere. */
    std::unique_ptr<const BodyOfMembers>
    exact_body() const;

    /**
     * The forces of a cell's finite element less those of each of the models,
     * at a displacement (m, spacedim x n_nodes): what a model misses, E(k) u of
     * linear ones. N, a column per node of the cell in the order of the mesh.
     */
    std::vector<Eigen::MatrixXd>
    missing_forces(unsigned int cell,
                   const Eigen::MatrixXd &displacement) const;

  private:
    const CalibratedScene<dim, spacedim> &calibrated_;
    const MaterialLaw law_;
    const Kinematics kinematics_;
    const DistinctCells cells_;
    std::vector<CellIterator<dim, spacedim>> iterators_;
    std::vector<std::vector<CellModel>> models_; // of each network
    mutable CellEnergy<dim, spacedim> energy_;
  };
} // namespace springfit

#endif
