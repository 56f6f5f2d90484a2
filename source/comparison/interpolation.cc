#include <springfit/comparison/interpolation.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>

namespace springfit
{
  namespace
  {
    /** A place in a cell's own coordinates. */
    template <int dim>
    struct UnitPlace
    {
      dealii::Point<dim> place;
      double distance = std::numeric_limits<double>::max(); // from the cell, m
    };

    template <int dim, int spacedim, typename Cell>
    dealii::Point<spacedim>
    place_in_space(const dealii::FiniteElement<dim, spacedim> &linear,
                   const Cell &cell,
                   const dealii::Point<dim> &place)
    {
      dealii::Point<spacedim> point;
      for (const unsigned int v : cell->vertex_indices())
        point += linear.shape_value(v, place) * cell->vertex(v);
      return point;
    }

    template <int dim>
    dealii::Point<dim>
    nearest_in_reference_cell(dealii::Point<dim> place, const bool is_simplex)
    {
      double sum = 0.;
      for (int d = 0; d < dim; ++d)
        {
          place[d] = std::clamp(place[d], 0., 1.);
          sum += place[d];
        }
      if (is_simplex && sum > 1.)
        place /= sum;
      return place;
    }

    // Newton's method for the place of least distance in the (multi)linear
    // extension of the cell: exact at once on simplices.
    template <int dim, int spacedim, typename Cell>
    UnitPlace<dim>
    place_in_cell(const dealii::FiniteElement<dim, spacedim> &linear,
                  const Cell &cell,
                  const dealii::Point<spacedim> &point)
    {
      const auto reference = linear.reference_cell();
      UnitPlace<dim> result;
      result.place = reference.template barycenter<dim>();
      for (int i = 0; i < 20; ++i)
        {
          const auto rest = point - place_in_space(linear, cell, result.place);
          Eigen::Matrix<double, spacedim, dim> J =
            Eigen::Matrix<double, spacedim, dim>::Zero();
          Eigen::Matrix<double, spacedim, 1> r;
          for (int e = 0; e < spacedim; ++e)
            r[e] = rest[e];
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto gradient = linear.shape_grad(v, result.place);
              for (int e = 0; e < spacedim; ++e)
                for (int d = 0; d < dim; ++d)
                  J(e, d) += cell->vertex(v)[e] * gradient[d];
            }
          const Eigen::Matrix<double, dim, 1> change =
            (J.transpose() * J).inverse() * (J.transpose() * r);
          if (!change.allFinite())
            return result;
          for (int d = 0; d < dim; ++d)
            // Far outside a cell its extension may fold.
            result.place[d] = std::clamp(result.place[d] + change[d], -2., 3.);
          if (change.norm() < 1e-12)
            break;
        }
      result.distance = point.distance(place_in_space(
        linear,
        cell,
        nearest_in_reference_cell(result.place, reference.is_simplex())));
      return result;
    }
  } // namespace

  template <int dim, int spacedim>
  Interpolation
  interpolation(const Mesh<dim, spacedim> &mesh,
                const Element<dim, spacedim> &element,
                const std::vector<dealii::Point<spacedim>> &points)
  {
    using Cell =
      typename dealii::Triangulation<dim, spacedim>::active_cell_iterator;
    std::vector<std::pair<dealii::BoundingBox<spacedim>, Cell>> boxes;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      boxes.emplace_back(cell->bounding_box(), cell);
    const auto tree = dealii::pack_rtree(boxes);

    const auto linear = make_element<dim, spacedim>(mesh.cell_kind);

    // More boxes than this hold no point: not many cells share a vertex.
    constexpr unsigned int most_cells = 100;

    Interpolation result;
    std::vector<Eigen::Triplet<double>> weights;
    for (const auto &point : points)
      {
        UnitPlace<dim> best;
        Cell of_best = boxes.front().second;
        for (auto near =
               tree.qbegin(boost::geometry::index::nearest(point, most_cells));
             near != tree.qend();
             ++near)
          {
            const double size = near->second->diameter();
            const auto place =
              place_in_cell(*linear.scalar, near->second, point);
            if (place.distance < best.distance)
              {
                best    = place;
                of_best = near->second;
              }
            if (best.distance <= 1e-10 * size)
              break;
          }
        const auto &nodes = mesh.nodes.of(of_best);
        for (unsigned int a = 0; a < nodes.size(); ++a)
          weights.emplace_back(nodes[a],
                               result.distances.size(),
                               element.scalar->shape_value(a, best.place));
        result.distances.push_back(best.distance);
      }
    result.weights.resize(mesh.nodes.size(), points.size());
    result.weights.setFromTriplets(weights.begin(), weights.end());
    return result;
  }

  template Interpolation
  interpolation(const Mesh<2> &,
                const Element<2> &,
                const std::vector<dealii::Point<2>> &);
  template Interpolation
  interpolation(const Mesh<2, 3> &,
                const Element<2, 3> &,
                const std::vector<dealii::Point<3>> &);
  template Interpolation
  interpolation(const Mesh<3> &,
                const Element<3> &,
                const std::vector<dealii::Point<3>> &);
} // namespace springfit
