#ifndef springfit_studies_motion_output_h
#define springfit_studies_motion_output_h

#include <springfit/mesh/mesh.h>
#include <springfit/motion/checkpoint.h>
#include <springfit/motion/dynamics.h>
#include <springfit/output/growing_table.h>
#include <springfit/reference/element.h>
#include <springfit/response/load_case.h>
#include <springfit/studies/moving_model.h>
#include <springfit/studies/openings.h>

#include <Eigen/Core>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /** What of a motion goes into its table, by names of columns. */
  struct Observations
  {
    std::vector<std::string> names;

    // In the order of the names: displacements of nodes, mean displacements of
    // boundaries, forces of supports, forces of obstacles.
    std::vector<unsigned int> nodes;
    std::vector<Eigen::VectorXd> weights; // of the nodes, of sum 1
    std::vector<std::vector<bool>> supports;
  };

  /** @throws EntryError when a boundary is unknown or has no faces. */
  template <int dim, int spacedim>
  Observations
  observations(const DynamicsSettings<spacedim> &settings,
               const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const Loading &loading,
               const std::vector<Obstacle> &obstacles);


  /** The table and the series of pictures of a model, while they grow. */
  class MotionRecord
  {
  public:
    /** @param base their names without an ending */
    MotionRecord(const std::filesystem::path &folder,
                 const std::string &base,
                 const Observations &observations);

    /** Goes on where a checkpoint was made. */
    MotionRecord(const std::filesystem::path &folder,
                 const std::string &base,
                 const Observations &observations,
                 CheckpointReader &checkpoint);

    void
    save(CheckpointWriter &checkpoint) const;

    /** The files that a checkpoint speaks of. */
    std::vector<std::string>
    files() const;

    void
    add_row(const MovingModel &model, const Excitation &excitation);

    template <int dim, int spacedim>
    void
    add_frame(const MovingModel &model,
              const Mesh<dim, spacedim> &mesh,
              const Remains &remains);

  private:
    const std::filesystem::path folder_;
    const std::string base_;
    const Observations &observations_;
    std::vector<std::pair<double, std::string>> frames_;
    std::unique_ptr<GrowingTable> table_;
  };
} // namespace springfit

#endif
