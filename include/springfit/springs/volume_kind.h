#ifndef springfit_springs_volume_kind_h
#define springfit_springs_volume_kind_h

#include <springfit/core/cell_kind.h>
#include <springfit/springs/kernel_kind.h>
#include <springfit/springs/lanes.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  /**
   * Springs of one or several volumes V_g of a cell under a law of volumes
   * (volume_laws.h). A class Coordinates<T>, with T as in lanes.h, has
   *
   *     static constexpr CellKind kind;
   *     static constexpr int dim, n_nodes, n_volumes;
   *     using Places = NodeVectors<dim, n_nodes, T>;
   *     using Values = std::array<T, n_volumes>;
   *     struct Edges { explicit Edges(const Places &); }; // differences of
   * them explicit Coordinates(const Edges &x); Values values() const; // V_g
   *     Values change(const Edges &u) const;          // grad V_g . u
   *     Places gradient(const Values &s) const;       // sum_g s_g grad V_g
   *     Places product(const Values &w, const Values &s, const Edges &u) const;
   *                        // sum_g (w_g grad V_g + s_g Hess V_g u)
   */
  template <template <typename> class Coordinates, typename Law, typename T>
  class VolumeKernel
  {
  public:
    using Volumes                  = Coordinates<T>;
    static constexpr int n_volumes = Volumes::n_volumes;
    using Places                   = typename Volumes::Places;
    using Values                   = typename Volumes::Values;
    using Edges                    = typename Volumes::Edges;

    explicit VolumeKernel(const Members &members) : law_(members)
    {}

    // Of the members in the lanes, of which @p m is the first.

    Places
    gradient(const std::size_t m, const Places &x) const
    {
      const Volumes volumes{Edges(x)};
      return volumes.gradient(slopes(m, volumes.values()));
    }

    Places
    product(const std::size_t m, const Places &x, const Places &u) const
    {
      const Volumes volumes{Edges(x)};
      const Edges moved(u);
      const Values V = volumes.values();
      return volumes.product(times_curvatures(m, V, volumes.change(moved)),
                             slopes(m, V),
                             moved);
    }

  private:
    Values
    slopes(const std::size_t m, const Values &V) const
    {
      Values s;
      for (int g = 0; g < n_volumes; ++g)
        for (std::size_t l = 0; l < sizeof(T) / sizeof(double); ++l)
          set_lane(s[g], l, law_.slope(n_volumes * (m + l) + g, lane(V[g], l)));
      return s;
    }

    Values
    times_curvatures(const std::size_t m,
                     const Values &V,
                     const Values &change) const
    {
      Values c;
      for (int g = 0; g < n_volumes; ++g)
        for (std::size_t l = 0; l < sizeof(T) / sizeof(double); ++l)
          set_lane(c[g],
                   l,
                   law_.curvature(n_volumes * (m + l) + g, lane(V[g], l)));
      for (int g = 0; g < n_volumes; ++g)
        c[g] *= change[g];
      return c;
    }

    const Law law_;
  };


  /** The kernel of single members as KernelKind wants it. */
  template <template <typename> class Coordinates, typename Law>
  class SingleVolumeKernel
  {
  public:
    using Volumes                  = Coordinates<double>;
    static constexpr int dim       = Volumes::dim;
    static constexpr int n_nodes   = Volumes::n_nodes;
    static constexpr int n_volumes = Volumes::n_volumes;
    using Places                   = Eigen::Matrix<double, dim, n_nodes>;

    explicit SingleVolumeKernel(const Members &members)
      : law_(members), kernel_(members)
    {}

    bool
    is_smooth(const std::size_t m, const Places &x) const
    {
      if constexpr (Law::is_smooth_everywhere)
        return true;
      const auto V = values(x);
      for (int g = 0; g < n_volumes; ++g)
        if (!law_.is_smooth(n_volumes * m + g, V[g]))
          return false;
      return true;
    }

    double
    energy(const std::size_t m, const Places &x) const
    {
      if (!is_smooth(m, x))
        return std::numeric_limits<double>::infinity();
      const auto V = values(x);
      double sum   = 0.;
      for (int g = 0; g < n_volumes; ++g)
        sum += law_.energy(n_volumes * m + g, V[g]);
      return sum;
    }

    Places
    gradient(const std::size_t m, const Places &x) const
    {
      return matrix(kernel_.gradient(m, vectors(x)));
    }

    Places
    product(const std::size_t m, const Places &x, const Places &u) const
    {
      return matrix(kernel_.product(m, vectors(x), vectors(u)));
    }

  private:
    static typename Volumes::Values
    values(const Places &x)
    {
      return Volumes{typename Volumes::Edges(vectors(x))}.values();
    }

    static typename Volumes::Places
    vectors(const Places &x)
    {
      typename Volumes::Places places;
      for (int a = 0; a < n_nodes; ++a)
        for (int d = 0; d < dim; ++d)
          places[a].c[d] = x(d, a);
      return places;
    }

    static Places
    matrix(const typename Volumes::Places &places)
    {
      Places x;
      for (int a = 0; a < n_nodes; ++a)
        for (int d = 0; d < dim; ++d)
          x(d, a) = places[a].c[d];
      return x;
    }

    const Law law_;
    const VolumeKernel<Coordinates, Law, double> kernel_;
  };


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
             vertex_names(kind),
             Law::columns(dim, n_volumes))
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

  private:
    /** How vectors of members that follow each other get into lanes. */
    template <typename T>
    struct Transfer
    {
      static constexpr std::size_t width = sizeof(T) / sizeof(double);
      using Places                       = NodeVectors<dim, n_nodes, T>;

      static Places
      gather(const unsigned int *nodes, const Eigen::MatrixXd &x)
      {
        Places places;
        for (int a = 0; a < n_nodes; ++a)
          for (std::size_t l = 0; l < width; ++l)
            {
              const double *place = x.data() + dim * nodes[n_nodes * l + a];
              for (int d = 0; d < dim; ++d)
                set_lane(places[a].c[d], l, place[d]);
            }
        return places;
      }

      static void
      scatter(const unsigned int *nodes,
              const Places &of_members,
              Eigen::MatrixXd &f)
      {
        for (std::size_t l = 0; l < width; ++l)
          for (int a = 0; a < n_nodes; ++a)
            {
              double *of_node = f.data() + dim * nodes[n_nodes * l + a];
              for (int d = 0; d < dim; ++d)
                of_node[d] += lane(of_members[a].c[d], l);
            }
      }
    };

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
        f(wide, m, nodes + n_nodes * m, Transfer<Lanes>());
      for (; m < size; ++m)
        f(narrow, m, nodes + n_nodes * m, Transfer<double>());
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
