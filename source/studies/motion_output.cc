#include <springfit/core/error.h>
#include <springfit/output/mesh_vtu.h>
#include <springfit/output/motion_table.h>
#include <springfit/response/boundary_parts.h>
#include <springfit/response/loaded_surface.h>
#include <springfit/studies/motion_output.h>
#include <springfit/studies/place_in_mesh.h>

#include <Eigen/Geometry>

#include <cstdio>

namespace springfit
{
  namespace
  {
    template <int dim, int spacedim>
    unsigned int
    nearest_node(const dealii::Point<spacedim> &place,
                 const Mesh<dim, spacedim> &mesh)
    {
      const auto &vertices = mesh.triangulation.get_vertices();
      unsigned int nearest = 0;
      for (unsigned int v = 1; v < vertices.size(); ++v)
        if (place.distance(vertices[v]) < place.distance(vertices[nearest]))
          nearest = v;
      return nearest;
    }

    /** About the origin; in 2-d its only component. */
    Eigen::VectorXd
    angular_momentum(const MovingModel &model, const Eigen::MatrixXd &nodes)
    {
      const Eigen::MatrixXd x = nodes + model.state.displacement;
      const Eigen::MatrixXd p = mass_product(model.body, model.state.velocity);
      Eigen::Vector3d sum     = Eigen::Vector3d::Zero();
      for (Eigen::Index v = 0; v < x.cols(); ++v)
        {
          Eigen::Vector3d arm = Eigen::Vector3d::Zero(), of_node = arm;
          arm.head(x.rows())     = x.col(v);
          of_node.head(x.rows()) = p.col(v);
          sum += arm.cross(of_node);
        }
      return x.rows() == 2 ? Eigen::VectorXd(sum.tail(1))
                           : Eigen::VectorXd(sum);
    }

    Eigen::VectorXd
    force_of_obstacle(const Obstacle &obstacle,
                      const MovingModel &model,
                      const Excitation &excitation)
    {
      Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero(excitation.nodes.rows(), excitation.nodes.cols());
      add_contact_forces(obstacle,
                         places(excitation, model.state.displacement),
                         model.state.time,
                         forces);
      return forces.rowwise().sum();
    }

    MotionRow
    row_of(const MovingModel &model,
           const Excitation &excitation,
           const Observations &observations)
    {
      MotionRow row;
      row.time    = model.state.time;
      row.kinetic = kinetic_energy(model.body, model.state);
      row.elastic = elastic_energy(model.body, model.state);
      row.contact = 0.;
      for (const auto &obstacle : excitation.obstacles)
        row.contact +=
          contact_energy(obstacle,
                         places(excitation, model.state.displacement),
                         model.state.time);
      row.account          = model.account;
      row.momentum         = momentum(model.body, model.state);
      row.angular_momentum = angular_momentum(model, excitation.nodes);
      for (const unsigned int v : observations.nodes)
        row.vectors.push_back(model.state.displacement.col(v));
      for (const auto &weights : observations.weights)
        row.vectors.push_back(model.state.displacement * weights);
      for (const auto &held : observations.supports)
        {
          Eigen::MatrixXd reactions = model.forces.reactions;
          for (std::size_t i = 0; i < held.size(); ++i)
            if (!held[i])
              reactions.reshaped()[i] = 0.;
          row.vectors.push_back(reactions.rowwise().sum());
        }
      for (const auto &obstacle : excitation.obstacles)
        row.vectors.push_back(force_of_obstacle(obstacle, model, excitation));
      return row;
    }
  } // namespace

  template <int dim, int spacedim>
  Observations
  observations(const DynamicsSettings<spacedim> &settings,
               const Mesh<dim, spacedim> &mesh,
               const Element<dim, spacedim> &element,
               const Loading &loading,
               const std::vector<Obstacle> &obstacles)
  {
    Observations result;
    const auto name = [&](const std::string &kind, const std::string &what) {
      result.names.push_back(column_name(kind + what, result.names));
    };
    for (const auto &point : settings.points)
      {
        place_in_mesh(point.place, mesh, element, "Dynamics/Points");
        name("u_", point.name);
        result.nodes.push_back(nearest_node(point.place, mesh));
      }
    for (const auto &boundary : settings.boundaries)
      {
        const std::string entry = "Dynamics/Boundaries";
        auto faces              = faces_of_boundaries(mesh, boundary, entry);
        if (faces.empty())
          throw EntryError(entry,
                           "the boundary '" + boundary + "' has no faces.",
                           "Name another one.");
        name("mean_u_", boundary);
        const LoadedSurface<dim, spacedim> surface(mesh,
                                                   std::move(faces),
                                                   element);
        result.weights.push_back(surface.shares() / surface.area());
      }
    for (const auto &support : loading.supports)
      {
        name("force_of_", support.name);
        result.supports.push_back(support.held);
      }
    for (const auto &obstacle : obstacles)
      name("force_of_", obstacle.name);
    return result;
  }

  MotionRecord::MotionRecord(const std::filesystem::path &folder,
                             const std::string &base,
                             const Observations &observations)
    : folder_(folder)
    , base_(base)
    , observations_(observations)
    , table_(std::make_unique<GrowingTable>(folder / (base + "_motion.csv"),
                                            motion_header(observations.names)))
  {}

  MotionRecord::MotionRecord(const std::filesystem::path &folder,
                             const std::string &base,
                             const Observations &observations,
                             CheckpointReader &checkpoint)
    : folder_(folder), base_(base), observations_(observations)
  {
    std::uint64_t size, n_frames;
    checkpoint >> size >> n_frames;
    for (std::uint64_t f = 0; f < n_frames; ++f)
      {
        double time;
        std::string file;
        checkpoint >> time >> file;
        frames_.emplace_back(time, file);
      }
    table_ = std::make_unique<GrowingTable>(folder / (base + "_motion.csv"),
                                            motion_header(observations.names),
                                            size);
  }

  void
  MotionRecord::save(CheckpointWriter &checkpoint) const
  {
    checkpoint << std::uint64_t(table_->size())
               << std::uint64_t(frames_.size());
    for (const auto &[time, file] : frames_)
      checkpoint << time << file;
  }

  std::vector<std::string>
  MotionRecord::files() const
  {
    std::vector<std::string> files = {base_ + "_motion.csv"};
    if (!frames_.empty())
      files.push_back(base_ + ".pvd");
    for (const auto &frame : frames_)
      files.push_back(frame.second);
    return files;
  }

  void
  MotionRecord::add_row(const MovingModel &model, const Excitation &excitation)
  {
    write_motion_row(row_of(model, excitation, observations_), table_->row());
    table_->append();
  }

  template <int dim, int spacedim>
  void
  MotionRecord::add_frame(const MovingModel &model,
                          const Mesh<dim, spacedim> &mesh,
                          const Remains &remains)
  {
    char number[16];
    std::snprintf(number, sizeof(number), "_%05zu", frames_.size());
    const std::string file = base_ + number + ".vtu";
    write_mesh_vtu(folder_ / file,
                   mesh,
                   remains.cells,
                   {{"displacement", model.state.displacement},
                    {"velocity", model.state.velocity}});
    frames_.emplace_back(model.state.time, file);
    write_pvd(folder_ / (base_ + ".pvd"), frames_);
  }

  template Observations
  observations(const DynamicsSettings<2> &,
               const Mesh<2> &,
               const Element<2> &,
               const Loading &,
               const std::vector<Obstacle> &);
  template Observations
  observations(const DynamicsSettings<3> &,
               const Mesh<2, 3> &,
               const Element<2, 3> &,
               const Loading &,
               const std::vector<Obstacle> &);
  template Observations
  observations(const DynamicsSettings<3> &,
               const Mesh<3> &,
               const Element<3> &,
               const Loading &,
               const std::vector<Obstacle> &);
  template void
  MotionRecord::add_frame(const MovingModel &,
                          const Mesh<2> &,
                          const Remains &);
  template void
  MotionRecord::add_frame(const MovingModel &,
                          const Mesh<2, 3> &,
                          const Remains &);
  template void
  MotionRecord::add_frame(const MovingModel &,
                          const Mesh<3> &,
                          const Remains &);
} // namespace springfit
