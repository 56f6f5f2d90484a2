#include <springfit/response/loaded_surface.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <utility>

namespace springfit
{
  template <int dim>
  LoadedSurface<dim>::LoadedSurface(std::vector<Face> faces,
                                    const Element<dim> &element)
    : faces_(std::move(faces)), element_(element)
  {
    dealii::FEFaceValues<dim> values(*element_.mapping,
                                     *element_.scalar,
                                     element_.face_quadrature,
                                     dealii::update_quadrature_points |
                                       dealii::update_normal_vectors |
                                       dealii::update_JxW_values);
    dealii::Tensor<1, dim> moment;
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
    centroid_ = dealii::Point<dim>(moment / area_);
    mean_normal_ /= area_;
  }

  template <int dim>
  double
  LoadedSurface<dim>::area() const
  {
    return area_;
  }

  template <int dim>
  dealii::Point<dim>
  LoadedSurface<dim>::centroid() const
  {
    return centroid_;
  }

  template <int dim>
  dealii::Tensor<1, dim>
  LoadedSurface<dim>::mean_normal() const
  {
    return mean_normal_;
  }

  template <int dim>
  double
  LoadedSurface<dim>::radius() const
  {
    double radius = 0.;
    for (const auto &[cell, number] : faces_)
      for (const unsigned int v : cell->face(number)->vertex_indices())
        radius =
          std::max(radius, centroid_.distance(cell->face(number)->vertex(v)));
    return radius;
  }

  template <int dim>
  Eigen::VectorXd
  LoadedSurface<dim>::shares(const unsigned int n_nodes) const
  {
    dealii::FEFaceValues<dim> values(*element_.mapping,
                                     *element_.scalar,
                                     element_.face_quadrature,
                                     dealii::update_values |
                                       dealii::update_JxW_values);
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(n_nodes);
    for (const auto &[cell, number] : faces_)
      {
        values.reinit(cell, number);
        for (const unsigned int v : cell->face(number)->vertex_indices())
          {
            // The cell's number of the vertex is that of its shape function.
            unsigned int a = 0;
            while (cell->vertex_index(a) != cell->face(number)->vertex_index(v))
              ++a;
            for (const unsigned int q : values.quadrature_point_indices())
              shares[cell->vertex_index(a)] +=
                values.shape_value(a, q) * values.JxW(q);
          }
      }
    return shares;
  }

  template <int dim>
  Eigen::MatrixXd
  LoadedSurface<dim>::forces(const Traction &traction,
                             const unsigned int n_nodes) const
  {
    const Eigen::VectorXd of_nodes = shares(n_nodes);
    Eigen::MatrixXd forces         = Eigen::MatrixXd::Zero(dim, n_nodes);
    if (faces_.empty())
      return forces;
    const auto &vertices =
      faces_.front().cell->get_triangulation().get_vertices();
    for (unsigned int v = 0; v < n_nodes; ++v)
      if (of_nodes[v] != 0.)
        {
          const auto t = traction(vertices[v]);
          for (int d = 0; d < dim; ++d)
            forces(d, v) = of_nodes[v] * t[d];
        }
    return forces;
  }

  template class LoadedSurface<2>;
  template class LoadedSurface<3>;
} // namespace springfit
