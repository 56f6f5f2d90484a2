#include <springfit/response/loaded_surface.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <utility>

namespace springfit
{
  template <int dim, int spacedim>
  LoadedSurface<dim, spacedim>::LoadedSurface(
    const Mesh<dim, spacedim> &mesh,
    std::vector<Face> faces,
    const Element<dim, spacedim> &element)
    : mesh_(mesh), faces_(std::move(faces)), element_(element)
  {
    dealii::FEFaceValues<dim, spacedim> values(
      *element_.mapping,
      *element_.scalar,
      element_.face_quadrature,
      dealii::update_quadrature_points | dealii::update_normal_vectors |
        dealii::update_JxW_values);
    dealii::Tensor<1, spacedim> moment;
    for (const auto &face : faces_)
      {
        values.reinit(face.cell, face.number);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            area_ += values.JxW(q);
            moment += values.quadrature_point(q) * values.JxW(q);
            mean_normal_ += values.normal_vector(q) * values.JxW(q);
          }
      }
    centroid_ = dealii::Point<spacedim>(moment / area_);
    mean_normal_ /= area_;
  }

  template <int dim, int spacedim>
  double
  LoadedSurface<dim, spacedim>::area() const
  {
    return area_;
  }

  template <int dim, int spacedim>
  dealii::Point<spacedim>
  LoadedSurface<dim, spacedim>::centroid() const
  {
    return centroid_;
  }

  template <int dim, int spacedim>
  dealii::Tensor<1, spacedim>
  LoadedSurface<dim, spacedim>::mean_normal() const
  {
    return mean_normal_;
  }

  template <int dim, int spacedim>
  double
  LoadedSurface<dim, spacedim>::radius() const
  {
    double radius = 0.;
    for (const auto &[cell, number] : faces_)
      for (const unsigned int v : cell->face(number)->vertex_indices())
        radius =
          std::max(radius, centroid_.distance(cell->face(number)->vertex(v)));
    return radius;
  }

  template <int dim, int spacedim>
  Eigen::VectorXd
  LoadedSurface<dim, spacedim>::shares() const
  {
    dealii::FEFaceValues<dim, spacedim> values(*element_.mapping,
                                               *element_.scalar,
                                               element_.face_quadrature,
                                               dealii::update_values |
                                                 dealii::update_JxW_values);
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(mesh_.nodes.size());
    for (const auto &[cell, number] : faces_)
      {
        values.reinit(cell, number);
        for (const unsigned int a : mesh_.nodes.of_faces[number])
          for (const unsigned int q : values.quadrature_point_indices())
            shares[mesh_.nodes.of(cell)[a]] +=
              values.shape_value(a, q) * values.JxW(q);
      }
    return shares;
  }

  template <int dim, int spacedim>
  Eigen::MatrixXd
  LoadedSurface<dim, spacedim>::forces(const Traction &traction) const
  {
    const Eigen::VectorXd of_nodes = shares();
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(spacedim, of_nodes.size());
    for (unsigned int v = 0; v < of_nodes.size(); ++v)
      if (of_nodes[v] != 0.)
        {
          const auto t = traction(mesh_.nodes.places[v]);
          for (int d = 0; d < spacedim; ++d)
            forces(d, v) = of_nodes[v] * t[d];
        }
    return forces;
  }

  template class LoadedSurface<2>;
  template class LoadedSurface<2, 3>;
  template class LoadedSurface<3>;
} // namespace springfit
