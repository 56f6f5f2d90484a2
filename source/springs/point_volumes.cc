#include <springfit/springs/lanes.h>
#include <springfit/springs/point_volumes.h>
#include <springfit/springs/volume_kind.h>
#include <springfit/springs/volume_laws.h>

#include <array>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    // A derivative of the Q1 map along a direction is interpolated between the
    // edges that run in this direction. Gauss' points lie symmetrically, at
    // 1/2 (1 +- slope), so that an interpolation from two ends to two points is
    // its own transpose. It is left without the factor of 1/2.

    constexpr double slope = 0.57735026918962576; // 1 / sqrt 3

    template <typename T>
    void
    interpolate(T &a, T &b)
    {
      const T sum = a + b, difference = (b - a) * slope;
      a = sum - difference;
      b = sum + difference;
    }


    /** The area of a quadrilateral at its points. */
    template <typename T>
    class QuadrilateralPoints
    {
    public:
      static constexpr CellKind kind    = CellKind::quadrilateral;
      static constexpr int dim          = 2;
      static constexpr int n_nodes      = 4;
      static constexpr int n_volumes    = 4;
      static constexpr bool has_hessian = false;
      using Vector                      = SmallVector<2, T>;
      using Places                      = NodeVectors<2, 4, T>;
      using Values                      = std::array<T, 4>;

      /** The derivatives along the first direction by the point's number in the
       * second one, and the other way round. */
      struct Edges
      {
        explicit Edges(const Places &x)
          : along{x[1] - x[0], x[3] - x[2]}, across{x[2] - x[0], x[3] - x[1]}
        {
          for (int c = 0; c < 2; ++c)
            {
              interpolate(along[0].c[c], along[1].c[c]);
              interpolate(across[0].c[c], across[1].c[c]);
            }
        }

        std::array<Vector, 2> along, across;
      };

      explicit QuadrilateralPoints(const Edges &x) : x_(x)
      {}

      Values
      values() const
      {
        Values V;
        for (int g = 0; g < 4; ++g)
          V[g] = weight * cross(x_.along[g >> 1], x_.across[g & 1]);
        return V;
      }

      Values
      change(const Edges &u) const
      {
        Values V;
        for (int g = 0; g < 4; ++g)
          V[g] = weight * (cross(u.along[g >> 1], x_.across[g & 1]) +
                           cross(x_.along[g >> 1], u.across[g & 1]));
        return V;
      }

      Places
      gradient(const Values &s) const
      {
        Sums sums{};
        sums.add(s, x_);
        return sums.on_vertices();
      }

      Places
      product(const Values &w, const Values &s, const Edges &u) const
      {
        Sums sums{};
        sums.add(w, x_);
        sums.add(s, u);
        return sums.on_vertices();
      }

    private:
      /** Of the map, of which both derivatives lack a factor of 1/2. */
      static constexpr double weight = 0.25 * 0.25;

      /** Sums over the points of weighted cofactors of the derivatives. */
      struct Sums
      {
        void
        add(const Values &s, const Edges &x)
        {
          for (int g = 0; g < 2; ++g)
            {
              along[g] = along[g] + turned(x.across[0]) * s[2 * g] +
                         turned(x.across[1]) * s[2 * g + 1];
              across[g] = across[g] - turned(x.along[0]) * s[g] -
                          turned(x.along[1]) * s[2 + g];
            }
        }

        Places
        on_vertices()
        {
          for (int g = 0; g < 2; ++g)
            {
              along[g]  = along[g] * (T() + weight);
              across[g] = across[g] * (T() + weight);
            }
          for (int c = 0; c < 2; ++c)
            {
              interpolate(along[0].c[c], along[1].c[c]);
              interpolate(across[0].c[c], across[1].c[c]);
            }
          return {-(along[0] + across[0]),
                  along[0] - across[1],
                  across[0] - along[1],
                  along[1] + across[1]};
        }

        std::array<Vector, 2> along, across;
      };

      const Edges x_;
    };


    /** The volume of a hexahedron at its points. */
    template <typename T>
    class HexahedronPoints
    {
    public:
      static constexpr CellKind kind    = CellKind::hexahedron;
      static constexpr int dim          = 3;
      static constexpr int n_nodes      = 8;
      static constexpr int n_volumes    = 8;
      static constexpr bool has_hessian = false;
      using Vector                      = SmallVector<3, T>;
      using Places                      = NodeVectors<3, 8, T>;
      using Values                      = std::array<T, 8>;

      /** The derivatives in each direction, by the point's number in the other
       * two. */
      struct Edges
      {
        explicit Edges(const Places &x)
        {
          for (int d = 0; d < 3; ++d)
            {
              for (int k = 0; k < 4; ++k)
                along[d][k] = x[lower[d][k] + (1 << d)] - x[lower[d][k]];
              interpolate_across(along[d]);
            }
        }

        std::array<std::array<Vector, 4>, 3> along;
      };

      explicit HexahedronPoints(const Edges &x) : x_(x)
      {}

      Values
      values() const
      {
        Values V;
        for (int g = 0; g < 8; ++g)
          V[g] = weight * dot(at<0>(x_, g), cross(at<1>(x_, g), at<2>(x_, g)));
        return V;
      }

      Values
      change(const Edges &u) const
      {
        Values V;
        for (int g = 0; g < 8; ++g)
          {
            const Vector &a = at<0>(x_, g), &b = at<1>(x_, g),
                         &c = at<2>(x_, g);
            V[g]            = weight * (dot(at<0>(u, g), cross(b, c)) +
                             dot(at<1>(u, g), cross(c, a)) +
                             dot(at<2>(u, g), cross(a, b)));
          }
        return V;
      }

      Places
      gradient(const Values &s) const
      {
        Sums sums{};
        for (int g = 0; g < 8; ++g)
          {
            const Vector a = at<0>(x_, g) * s[g];
            const Vector b = at<1>(x_, g), c = at<2>(x_, g);
            sums.add(g, cross(b, c) * s[g], cross(c, a), cross(a, b));
          }
        return sums.on_vertices();
      }

      Places
      product(const Values &w, const Values &s, const Edges &u) const
      {
        Sums sums{};
        for (int g = 0; g < 8; ++g)
          {
            // The change of s b x c, with w b x c, is
            // (s e + w b) x c + b x s f; and so on around.
            const Vector &a = at<0>(x_, g), &b = at<1>(x_, g),
                         &c = at<2>(x_, g);
            const Vector d = at<0>(u, g) * s[g], e = at<1>(u, g) * s[g],
                         f = at<2>(u, g) * s[g];
            const Vector p = d + a * w[g], q = e + b * w[g], r = f + c * w[g];
            sums.add(g,
                     cross(q, c) + cross(b, f),
                     cross(r, a) + cross(c, d),
                     cross(p, b) + cross(a, e));
          }
        return sums.on_vertices();
      }

    private:
      /** Of the map, of which each derivative lacks a factor of 1/4. */
      static constexpr double weight = 0.125 / 64.;

      /** The lower vertices of the edges in direction d; the upper ones are 2^d
       * on. */
      static constexpr int lower[3][4] = {{0, 2, 4, 6},
                                          {0, 1, 4, 5},
                                          {0, 1, 2, 3}};

      /** The number of point g in the directions other than d. */
      template <int d>
      static constexpr int
      across(const int g)
      {
        return d == 0 ? g >> 1 : d == 1 ? (g & 1) + 2 * (g >> 2) : g & 3;
      }

      static void
      interpolate_across(std::array<Vector, 4> &e)
      {
        for (int c = 0; c < 3; ++c)
          {
            interpolate(e[0].c[c], e[1].c[c]);
            interpolate(e[2].c[c], e[3].c[c]);
            interpolate(e[0].c[c], e[2].c[c]);
            interpolate(e[1].c[c], e[3].c[c]);
          }
      }

      template <int d>
      static const Vector &
      at(const Edges &x, const int g)
      {
        return x.along[d][across<d>(g)];
      }

      /** Sums over the points of weighted cofactors of the derivatives. */
      struct Sums
      {
        void
        add(const int g,
            const Vector &of_0,
            const Vector &of_1,
            const Vector &of_2)
        {
          along[0][across<0>(g)] = along[0][across<0>(g)] + of_0;
          along[1][across<1>(g)] = along[1][across<1>(g)] + of_1;
          along[2][across<2>(g)] = along[2][across<2>(g)] + of_2;
        }

        Places
        on_vertices()
        {
          Places g{};
          for (int d = 0; d < 3; ++d)
            {
              interpolate_across(along[d]);
              for (int k = 0; k < 4; ++k)
                {
                  const Vector f = along[d][k] * (T() + weight);
                  const int from = lower[d][k], to = from + (1 << d);
                  g[to]   = g[to] + f;
                  g[from] = g[from] - f;
                }
            }
          return g;
        }

        std::array<std::array<Vector, 4>, 3> along;
      };

      const Edges x_;
    };


    template <typename Law>
    const SpringKind &
    point_volumes_with(const CellKind kind)
    {
      static const VolumeKind<QuadrilateralPoints, Law> quadrilaterals(
        "point_volumes");
      static const VolumeKind<HexahedronPoints, Law> hexahedra("point_volumes");
      if (is_simplex(kind))
        throw std::logic_error("a simplex has a single volume");
      if (kind == CellKind::quadrilateral)
        return quadrilaterals;
      return hexahedra;
    }
  } // namespace

  const SpringKind &
  point_volumes(const CellKind kind)
  {
    return point_volumes_with<QuadraticVolumeLaw>(kind);
  }

  std::vector<double>
  spring_point_volumes(const Eigen::MatrixXd &points, const CellKind kind)
  {
    if (is_simplex(kind))
      throw std::logic_error("a simplex has a single volume");
    return kind == CellKind::quadrilateral
             ? volumes_at<QuadrilateralPoints>(points)
             : volumes_at<HexahedronPoints>(points);
  }

  const SpringKind &
  logarithmic_point_volumes(const CellKind kind)
  {
    return point_volumes_with<LogarithmicVolumeLaw>(kind);
  }

  const SpringKind &
  logarithmic_point_areas_in_plane_stress(const CellKind kind)
  {
    if (dimension(kind) != 2)
      throw std::logic_error("only cells in the plane are in plane stress");
    return point_volumes_with<PlaneStressVolumeLaw>(kind);
  }
} // namespace springfit
