#ifndef springfit_response_loaded_surface_h
#define springfit_response_loaded_surface_h

#include <springfit/mesh/mesh.h>
#include <springfit/reference/element.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace springfit
{
  /** The part of a mesh's boundary on which a traction acts. */
  template <int dim, int spacedim = dim>
  class LoadedSurface
  {
  public:
    struct Face
    {
      typename dealii::Triangulation<dim, spacedim>::active_cell_iterator cell;
      unsigned int number;
    };

    /** Traction in Pa at a point. */
    using Traction = std::function<dealii::Tensor<1, spacedim>(
      const dealii::Point<spacedim> &)>;

    /** @p mesh and @p element must outlive the object. */
    LoadedSurface(const Mesh<dim, spacedim> &mesh,
                  std::vector<Face> faces,
                  const Element<dim, spacedim> &element);

    /** m^2, or m in 2-d. */
    double
    area() const;

    dealii::Point<spacedim>
    centroid() const;

    /** The integral of the outward normal divided by the area. */
    dealii::Tensor<1, spacedim>
    mean_normal() const;

    /** Largest distance of a vertex from the centroid, m. */
    double
    radius() const;

    /** The integrals of the nodes' shape functions over it, m^2 (2-d: m). */
    Eigen::VectorXd
    shares() const;

    /**
     * The nodal forces of a traction, the traction at node a times its share,
     * in N (N/m in 2-d: not yet multiplied by a thickness), spacedim x
     * n_nodes. They are the consistent forces where the traction is uniform;
     * where it varies, its product with N_a is integrated by the nodal rule
     * that gives the lumped masses too.
     */
    Eigen::MatrixXd
    forces(const Traction &traction) const;

  private:
    const Mesh<dim, spacedim> &mesh_;
    const std::vector<Face> faces_;
    const Element<dim, spacedim> &element_;
    double area_ = 0.;
    dealii::Point<spacedim> centroid_;
    dealii::Tensor<1, spacedim> mean_normal_;
  };
} // namespace springfit

#endif
