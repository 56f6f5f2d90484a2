#ifndef springfit_springs_volume_kernel_h
#define springfit_springs_volume_kernel_h

#include <springfit/core/cell_kind.h>
#include <springfit/springs/family.h>
#include <springfit/springs/lanes.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

namespace springfit
{
  /**
   * Springs of one or several volumes V_g of a cell under a law of volumes
   * (volume_laws.h). A class Coordinates<T>, with T as in lanes.h, has
   *
   *     static constexpr CellKind kind;
   *     static constexpr int dim, n_nodes, n_volumes;
   *     static constexpr bool has_hessian;
   *     using Places = NodeVectors<dim, n_nodes, T>;
   *     using Values = std::array<T, n_volumes>;
   *     struct Edges { explicit Edges(const Places &); }; // differences
   *     explicit Coordinates(const Edges &x); Values values() const; // V_g
   *     Values change(const Edges &u) const;          // grad V_g . u
   *     Places gradient(const Values &s) const;       // sum_g s_g grad V_g
   *     Places product(const Values &w, const Values &s, const Edges &u) const;
   *                        // sum_g (w_g grad V_g + s_g Hess V_g u)
   *
   * and, with has_hessian, of T = double,
   *
   *     // sum_g (c_g grad V_g grad V_g^T + s_g Hess V_g)
   *     Eigen::Matrix<double, dim * n_nodes, dim * n_nodes>
   *     hessian(const Values &c, const Values &s) const;
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

    /** What products need of some places; the law's slopes and curvatures. */
    using State = std::tuple<Volumes, Values, Values>;

    State
    state(const std::size_t m, const Places &x) const
    {
      const Volumes volumes{Edges(x)};
      const Values V = volumes.values();
      return {volumes, slopes(m, V), curvatures(m, V)};
    }

    static Places
    product(const State &state, const Places &u)
    {
      const auto &[volumes, slopes, curvatures] = state;
      const Edges moved(u);
      Values changes = volumes.change(moved);
      for (int g = 0; g < n_volumes; ++g)
        changes[g] *= curvatures[g];
      return volumes.product(changes, slopes, moved);
    }

    Places
    product(const std::size_t m, const Places &x, const Places &u) const
    {
      return product(state(m, x), u);
    }

    /** Of T = double, where the coordinates have one. */
    auto
    hessian(const std::size_t m, const Places &x) const
    {
      const auto [volumes, slopes, curvatures] = state(m, x);
      return volumes.hessian(curvatures, slopes);
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
    curvatures(const std::size_t m, const Values &V) const
    {
      Values c;
      for (int g = 0; g < n_volumes; ++g)
        for (std::size_t l = 0; l < sizeof(T) / sizeof(double); ++l)
          set_lane(c[g],
                   l,
                   law_.curvature(n_volumes * (m + l) + g, lane(V[g], l)));
      return c;
    }

    const Law law_;
  };


  /** The kernel of single members as KernelKind wants it. */
  template <template <typename> class Coordinates, typename Law>
  class SingleVolumeKernel
  {
  public:
    using Volumes                     = Coordinates<double>;
    static constexpr int dim          = Volumes::dim;
    static constexpr int n_nodes      = Volumes::n_nodes;
    static constexpr int n_volumes    = Volumes::n_volumes;
    static constexpr bool has_hessian = Volumes::has_hessian;
    using Places                      = Eigen::Matrix<double, dim, n_nodes>;

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

    auto
    hessian(const std::size_t m, const Places &x) const
    {
      return kernel_.hessian(m, vectors(x));
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


  /** How vectors of members that follow each other get into lanes. */
  template <template <typename> class Coordinates, typename T>
  struct VolumeLanes
  {
    static constexpr int dim           = Coordinates<double>::dim;
    static constexpr int n_nodes       = Coordinates<double>::n_nodes;
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
} // namespace springfit

#endif
