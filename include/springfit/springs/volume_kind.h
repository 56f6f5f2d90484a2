#ifndef springfit_springs_volume_kind_h
#define springfit_springs_volume_kind_h

#include <springfit/core/cell_kind.h>
#include <springfit/springs/kernel_kind.h>
#include <springfit/springs/lanes.h>
#include <springfit/springs/volume_kernel.h>
#include <springfit/springs/volume_operator.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /** The names n0, n1, ... of a cell's vertices in tables. */
  inline std::vector<std::string>
  vertex_names(const CellKind kind)
  {
    std::vector<std::string> names;
    for (int v = 0; v < n_vertices(kind); ++v)
      names.push_back('n' + std::to_string(v));
    return names;
  }


  /** The volumes of a cell with vertices at @p points, dim x n_nodes. */
  template <template <typename> class Coordinates>
  std::vector<double>
  volumes_at(const Eigen::MatrixXd &points)
  {
    using Volumes = Coordinates<double>;
    typename Volumes::Places places;
    for (int a = 0; a < Volumes::n_nodes; ++a)
      for (int d = 0; d < Volumes::dim; ++d)
        places[a].c[d] = points(d, a);
    const auto values = Volumes{typename Volumes::Edges(places)}.values();
    return {values.begin(), values.end()};
  }


  template <template <typename> class Coordinates, typename Law>
  class VolumeKind : public KernelKind<SingleVolumeKernel<Coordinates, Law>>
  {
  public:
    static constexpr CellKind kind = Coordinates<double>::kind;
    static constexpr int dim       = Coordinates<double>::dim;
    static constexpr int n_nodes   = Coordinates<double>::n_nodes;
    static constexpr int n_volumes = Coordinates<double>::n_volumes;
    using Base = KernelKind<SingleVolumeKernel<Coordinates, Law>>;

    /** @p word follows the law's prefix. */
    explicit VolumeKind(const std::string &word)
      : Base(Law::prefix() + word,
             Law::word(),
             vertex_names(kind),
             Law::columns(dimension(kind), n_volumes))
    {}

    bool
    is_shared() const override
    {
      return false;
    }

    bool
    bears_inversion() const override
    {
      return Law::is_smooth_everywhere;
    }

    /** Mirror a cell that is numbered inside out. */
    void
    canonicalise(std::vector<unsigned int> &nodes,
                 std::vector<std::vector<double>> &numbers,
                 const Eigen::MatrixXd &x) const override
    {
      Eigen::MatrixXd points(dim, n_nodes);
      for (int a = 0; a < n_nodes; ++a)
        points.col(a) = x.col(nodes[a]);
      double volume = 0.;
      for (const double V : volumes_at<Coordinates>(points))
        volume += V;
      if (volume >= 0.)
        return;
      mirror(nodes);
      if (n_volumes > 1)
        for (auto &column : numbers)
          mirror(column);
    }

    void
    add_forces(const Members &members,
               const Eigen::MatrixXd &x,
               Eigen::MatrixXd &forces) const override
    {
      if constexpr (!Law::is_smooth_everywhere)
        Base::add_forces(members, x, forces);
      else
        in_lanes(members,
                 [&](const auto &kernel,
                     const std::size_t m,
                     const unsigned int *nodes,
                     const auto &lanes) {
                   const auto places = lanes.gather(nodes, x);
                   auto gradient     = kernel.gradient(m, places);
                   for (auto &of_node : gradient)
                     of_node = -of_node;
                   lanes.scatter(nodes, gradient, forces);
                 });
    }

    void
    add_tangent_product(const Members &members,
                        const Eigen::MatrixXd &x,
                        const Eigen::MatrixXd &u,
                        Eigen::MatrixXd &product) const override
    {
      if constexpr (!Law::is_smooth_everywhere)
        Base::add_tangent_product(members, x, u, product);
      else
        in_lanes(members,
                 [&](const auto &kernel,
                     const std::size_t m,
                     const unsigned int *nodes,
                     const auto &lanes) {
                   lanes.scatter(nodes,
                                 kernel.product(m,
                                                lanes.gather(nodes, x),
                                                lanes.gather(nodes, u)),
                                 product);
                 });
    }

    std::unique_ptr<TangentOperator>
    tangent_operator(const Members &members) const override
    {
      if constexpr (!Law::is_smooth_everywhere)
        return Base::tangent_operator(members);
      else
        return std::make_unique<VolumeOperator<Coordinates, Law>>(members);
    }

  private:
    /** As many members at once as there are lanes, the last ones singly. */
    template <typename F>
    static void
    in_lanes(const Members &members, const F &f)
    {
      const std::size_t size    = members.nodes.size() / n_nodes;
      const unsigned int *nodes = members.nodes.data();
      const VolumeKernel<Coordinates, Law, Lanes> wide(members);
      const VolumeKernel<Coordinates, Law, double> narrow(members);
      std::size_t m = 0;
      for (; m + n_lanes <= size; m += n_lanes)
        f(wide, m, nodes + n_nodes * m, VolumeLanes<Coordinates, Lanes>());
      for (; m < size; ++m)
        f(narrow, m, nodes + n_nodes * m, VolumeLanes<Coordinates, double>());
    }

    /** Exchange the first two axes of the reference cell. */
    template <typename Vector>
    static void
    mirror(Vector &of_vertices)
    {
      std::swap(of_vertices[1], of_vertices[2]);
      if (kind == CellKind::hexahedron)
        std::swap(of_vertices[5], of_vertices[6]);
    }
  };
} // namespace springfit

#endif
