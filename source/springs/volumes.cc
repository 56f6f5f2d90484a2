#include <springfit/springs/lanes.h>
#include <springfit/springs/volume_kind.h>
#include <springfit/springs/volume_laws.h>
#include <springfit/springs/volumes.h>

#include <array>
#include <stdexcept>
#include <string>

namespace springfit
{
  namespace
  {
    template <CellKind kind_, int dim_, int n_nodes_, typename T>
    struct SingleVolume
    {
      static constexpr CellKind kind    = kind_;
      static constexpr int dim          = dim_;
      static constexpr int n_nodes      = n_nodes_;
      static constexpr int n_volumes    = 1;
      static constexpr bool has_hessian = false;
      using Vector                      = SmallVector<dim_, T>;
      using Places                      = NodeVectors<dim_, n_nodes_, T>;
      using Values                      = std::array<T, 1>;
    };


    /** a x b / 2 of two vectors a and b in the plane. */
    template <typename T>
    T
    half_cross(const SmallVector<2, T> &a, const SmallVector<2, T> &b)
    {
      return 0.5 * cross(a, b);
    }


    /** The edges a and b from vertex 0. */
    template <typename T>
    struct SidesOfTriangle : SingleVolume<CellKind::triangle, 2, 3, T>
    {
      using typename SidesOfTriangle::SingleVolume::Places;
      using typename SidesOfTriangle::SingleVolume::Vector;

      struct Edges
      {
        explicit Edges(const Places &x) : a(x[1] - x[0]), b(x[2] - x[0])
        {}

        Vector a, b;
      };

      static Places
      on_vertices(const Vector &a, const Vector &b)
      {
        const Vector of_1 = turned(b) * (T() + 0.5);
        const Vector of_2 = turned(a) * (T() - 0.5);
        return {-(of_1 + of_2), of_1, of_2};
      }
    };


    /** The diagonals, a from vertex 0 to 3, b from 1 to 2. */
    template <typename T>
    struct SidesOfQuadrilateral : SingleVolume<CellKind::quadrilateral, 2, 4, T>
    {
      using typename SidesOfQuadrilateral::SingleVolume::Places;
      using typename SidesOfQuadrilateral::SingleVolume::Vector;

      struct Edges
      {
        explicit Edges(const Places &x) : a(x[3] - x[0]), b(x[2] - x[1])
        {}

        Vector a, b;
      };

      static Places
      on_vertices(const Vector &a, const Vector &b)
      {
        const Vector of_3 = turned(b) * (T() + 0.5);
        const Vector of_1 = turned(a) * (T() + 0.5);
        return {-of_3, of_1, -of_1, of_3};
      }
    };


    /**
     * a x b / 2 of two vectors of a cell. on_vertices() is the derivative of a
     * and b by the vertices, transposed, applied to the derivative of a x b / 2
     * by them.
     */
    template <typename Sides>
    class Area : public Sides
    {
    public:
      using typename Sides::Edges;
      using typename Sides::Places;
      using typename Sides::Values;

      explicit Area(const Edges &x) : x_(x)
      {}

      Values
      values() const
      {
        return {half_cross(x_.a, x_.b)};
      }

      Values
      change(const Edges &u) const
      {
        return {half_cross(u.a, x_.b) + half_cross(x_.a, u.b)};
      }

      Places
      gradient(const Values &s) const
      {
        return Sides::on_vertices(x_.a * s[0], x_.b * s[0]);
      }

      Places
      product(const Values &w, const Values &s, const Edges &u) const
      {
        return Sides::on_vertices(x_.a * w[0] + u.a * s[0],
                                  x_.b * w[0] + u.b * s[0]);
      }

    private:
      const Edges x_;
    };

    template <typename T>
    using Triangle = Area<SidesOfTriangle<T>>;

    template <typename T>
    using Quadrilateral = Area<SidesOfQuadrilateral<T>>;


    /** det (a, b, c) / 6 of the edges from vertex 0. */
    template <typename T>
    class Tetrahedron : public SingleVolume<CellKind::tetrahedron, 3, 4, T>
    {
    public:
      static constexpr bool has_hessian = true;
      using typename Tetrahedron::SingleVolume::Places;
      using typename Tetrahedron::SingleVolume::Values;
      using typename Tetrahedron::SingleVolume::Vector;

      struct Edges
      {
        explicit Edges(const Places &x)
          : a(x[1] - x[0]), b(x[2] - x[0]), c(x[3] - x[0])
        {}

        Vector a, b, c;
      };

      explicit Tetrahedron(const Edges &x)
        : x_(x)
        , bc_(cross(x.b, x.c))
        , ca_(cross(x.c, x.a))
        , ab_(cross(x.a, x.b))
      {}

      Values
      values() const
      {
        return {dot(x_.a, bc_) * (1. / 6.)};
      }

      Values
      change(const Edges &u) const
      {
        return {(dot(u.a, bc_) + dot(u.b, ca_) + dot(u.c, ab_)) * (1. / 6.)};
      }

      Places
      gradient(const Values &s) const
      {
        const T t = s[0] * (1. / 6.);
        return on_vertices(bc_ * t, ca_ * t, ab_ * t);
      }

      Places
      product(const Values &w, const Values &s, const Edges &u) const
      {
        // The cofactors are quadratic: their change with u is that with
        // s u, and w times them is added in the same way.
        const T t = s[0] * (1. / 6.), r = w[0] * (1. / 6.);
        const Vector a = u.a * t, b = u.b * t, c = u.c * t;
        return on_vertices(bc_ * r + cross(b, x_.c) + cross(x_.b, c),
                           ca_ * r + cross(c, x_.a) + cross(x_.c, a),
                           ab_ * r + cross(a, x_.b) + cross(x_.a, b));
      }

      Eigen::Matrix<double, 12, 12>
      hessian(const Values &c, const Values &s) const
      {
        // Of the edges first: (d/da)(d/db) V is - 1/6 of the matrix of a
        // product with c from the left, and so in turns.
        const double r = c[0] * (1. / 36.), t = s[0] * (1. / 6.);
        Eigen::Matrix<double, 9, 1> areas;
        for (int d = 0; d < 3; ++d)
          {
            areas[d]     = bc_.c[d];
            areas[3 + d] = ca_.c[d];
            areas[6 + d] = ab_.c[d];
          }
        Eigen::Matrix<double, 12, 12> H;
        auto of_edges = H.template bottomRightCorner<9, 9>();
        of_edges      = (r * areas) * areas.transpose();
        add_turned(x_.c, -t, of_edges.template block<3, 3>(0, 3));
        add_turned(x_.c, t, of_edges.template block<3, 3>(3, 0));
        add_turned(x_.b, t, of_edges.template block<3, 3>(0, 6));
        add_turned(x_.b, -t, of_edges.template block<3, 3>(6, 0));
        add_turned(x_.a, -t, of_edges.template block<3, 3>(3, 6));
        add_turned(x_.a, t, of_edges.template block<3, 3>(6, 3));
        H.template topRightCorner<3, 9>() = -(
          of_edges.template topRows<3>() + of_edges.template middleRows<3>(3) +
          of_edges.template bottomRows<3>());
        H.template leftCols<3>() =
          -(H.template middleCols<3>(3) + H.template middleCols<3>(6) +
            H.template rightCols<3>());
        return H;
      }

    private:
      /** Adds the matrix of a x . times @p t to @p block. */
      template <typename Block>
      static void
      add_turned(const Vector &a, const double t, Block &&block)
      {
        block(0, 1) -= t * a.c[2];
        block(1, 0) += t * a.c[2];
        block(0, 2) += t * a.c[1];
        block(2, 0) -= t * a.c[1];
        block(1, 2) -= t * a.c[0];
        block(2, 1) += t * a.c[0];
      }

      static Places
      on_vertices(const Vector &of_1, const Vector &of_2, const Vector &of_3)
      {
        return {-(of_1 + of_2 + of_3), of_1, of_2, of_3};
      }

      const Edges x_;
      const Vector bc_, ca_, ab_;
    };


    /**
     * The volume of the trilinear map as the sum of three determinants of
     * differences of vertices, divided by 12 (Grandy, "Efficient computation of
     * volume of hexahedral cells", LLNL report UCRL-ID-128886 (1997)).
     */
    template <typename T>
    class Hexahedron : public SingleVolume<CellKind::hexahedron, 3, 8, T>
    {
    public:
      using typename Hexahedron::SingleVolume::Places;
      using typename Hexahedron::SingleVolume::Values;
      using typename Hexahedron::SingleVolume::Vector;

      struct Edges
      {
        explicit Edges(const Places &x)
          : A(x[7] - x[1])
          , B(x[6] - x[0])
          , C(x[7] - x[2])
          , D(x[3] - x[0])
          , E(x[5] - x[0])
          , F(x[7] - x[4])
          , AB(A + B)
          , CE(C + E)
          , FD(F + D)
        {}

        Vector A, B, C, D, E, F, AB, CE, FD;
      };

      explicit Hexahedron(const Edges &x) : x_(x), gradients_(gradients(x))
      {}

      Values
      values() const
      {
        // The volume is homogeneous, of the third degree.
        return {change(x_)[0] * (1. / 3.)};
      }

      Values
      change(const Edges &u) const
      {
        const auto &[A, B, C, D, E, F] = gradients_;
        return {(dot(A, u.A) + dot(B, u.B) + dot(C, u.C) + dot(D, u.D) +
                 dot(E, u.E) + dot(F, u.F)) *
                (1. / 12.)};
      }

      Places
      gradient(const Values &s) const
      {
        return on_vertices(gradients_, s[0] * (1. / 12.));
      }

      Places
      product(const Values &w, const Values &s, const Edges &u) const
      {
        Places sum = on_vertices(gradients_, w[0] * (1. / 12.));
        const Places changes =
          on_vertices(gradient_changes(u), s[0] * (1. / 12.));
        for (int a = 0; a < 8; ++a)
          sum[a] = sum[a] + changes[a];
        return sum;
      }

    private:
      /** 12 times the derivatives of the volume by the differences. */
      struct Gradients
      {
        Vector A, B, C, D, E, F;
      };

      static Gradients
      gradients(const Edges &x)
      {
        const Vector p = cross(x.C, x.D);
        return {p + cross(x.E, x.FD),
                p + cross(x.CE, x.F),
                cross(x.D, x.AB) + cross(x.F, x.B),
                cross(x.AB, x.C) + cross(x.A, x.E),
                cross(x.F, x.B) + cross(x.FD, x.A),
                cross(x.B, x.CE) + cross(x.A, x.E)};
      }

      Gradients
      gradient_changes(const Edges &u) const
      {
        const Edges &x  = x_;
        const Vector p  = cross(u.C, x.D) + cross(x.C, u.D);
        const Vector q2 = cross(u.F, x.B) + cross(x.F, u.B);
        const Vector r3 = cross(u.A, x.E) + cross(x.A, u.E);
        return {p + cross(u.E, x.FD) + cross(x.E, u.FD),
                p + cross(u.CE, x.F) + cross(x.CE, u.F),
                q2 + cross(u.D, x.AB) + cross(x.D, u.AB),
                r3 + cross(u.AB, x.C) + cross(x.AB, u.C),
                q2 + cross(u.FD, x.A) + cross(x.FD, u.A),
                r3 + cross(u.B, x.CE) + cross(x.B, u.CE)};
      }

      static Places
      on_vertices(const Gradients &g, const T &w)
      {
        const Vector A = g.A * w, B = g.B * w, C = g.C * w, D = g.D * w,
                     E = g.E * w, F = g.F * w;
        return {-(B + D + E), -A, -C, D, -F, E, B, A + C + F};
      }

      const Edges x_;
      const Gradients gradients_;
    };


    template <typename Law>
    const SpringKind &
    volumes_with(const CellKind kind, const std::string &word)
    {
      static const VolumeKind<Triangle, Law> triangles(word);
      static const VolumeKind<Quadrilateral, Law> quadrilaterals(word);
      static const VolumeKind<Tetrahedron, Law> tetrahedra(word);
      static const VolumeKind<Hexahedron, Law> hexahedra(word);
      switch (kind)
        {
          case CellKind::triangle:
            return triangles;
          case CellKind::quadrilateral:
            return quadrilaterals;
          case CellKind::tetrahedron:
            return tetrahedra;
          case CellKind::hexahedron:
            return hexahedra;
        }
      throw std::logic_error("a cell has no volume");
    }
  } // namespace

  const SpringKind &
  volumes(const CellKind kind)
  {
    return volumes_with<QuadraticVolumeLaw>(kind, "volumes");
  }

  double
  spring_volume(const Eigen::MatrixXd &points, const CellKind kind)
  {
    switch (kind)
      {
        case CellKind::triangle:
          return volumes_at<Triangle>(points).front();
        case CellKind::quadrilateral:
          return volumes_at<Quadrilateral>(points).front();
        case CellKind::tetrahedron:
          return volumes_at<Tetrahedron>(points).front();
        case CellKind::hexahedron:
          return volumes_at<Hexahedron>(points).front();
      }
    throw std::logic_error("a cell has no volume");
  }

  const SpringKind &
  logarithmic_volumes(const CellKind kind)
  {
    return volumes_with<LogarithmicVolumeLaw>(kind, "volumes");
  }

  const SpringKind &
  logarithmic_areas_in_plane_stress(const CellKind kind)
  {
    if (dimension(kind) != 2)
      throw std::logic_error("only cells in the plane are in plane stress");
    return volumes_with<PlaneStressVolumeLaw>(kind, "volumes");
  }
} // namespace springfit
