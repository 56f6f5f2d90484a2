#include <springfit/springs/lanes.h>
#include <springfit/springs/surface_areas.h>
#include <springfit/springs/volume_kind.h>
#include <springfit/springs/volume_laws.h>

#include <array>

namespace springfit
{
  namespace
  {
    /** |N| / 2 with N = a x b of the edges a and b from vertex 0. */
    template <typename T>
    class TriangleInSpace
    {
    public:
      static constexpr CellKind kind    = CellKind::triangle;
      static constexpr int dim          = 3;
      static constexpr int n_nodes      = 3;
      static constexpr int n_volumes    = 1;
      static constexpr bool has_hessian = false;
      using Vector                      = SmallVector<3, T>;
      using Places                      = NodeVectors<3, 3, T>;
      using Values                      = std::array<T, 1>;

      struct Edges
      {
        explicit Edges(const Places &x) : a(x[1] - x[0]), b(x[2] - x[0])
        {}

        Vector a, b;
      };

      explicit TriangleInSpace(const Edges &x)
        : x_(x)
        , normal_(cross(x.a, x.b))
        , size_(square_root(dot(normal_, normal_) + T() + tiny))
        , n_(normal_ * ((T() + 1.) / size_))
      {}

      Values
      values() const
      {
        return {dot(n_, normal_) * 0.5};
      }

      Values
      change(const Edges &u) const
      {
        return {dot(n_, change_of_normal(u)) * 0.5};
      }

      Places
      gradient(const Values &s) const
      {
        const T t = s[0] * 0.5;
        return on_vertices(cross(x_.b, n_) * t, cross(n_, x_.a) * t);
      }

      Places
      product(const Values &w, const Values &s, const Edges &u) const
      {
        const Vector dN = change_of_normal(u);
        const Vector dn = (dN - n_ * dot(n_, dN)) * ((T() + 1.) / size_);
        const T r = w[0] * 0.5, t = s[0] * 0.5;
        return on_vertices(cross(x_.b, n_) * r +
                             (cross(u.b, n_) + cross(x_.b, dn)) * t,
                           cross(n_, x_.a) * r +
                             (cross(dn, x_.a) + cross(n_, u.a)) * t);
      }

    private:
      // m^4: a triangle without area has no normal, and pulls nowhere.
      static constexpr double tiny = 1e-200;

      Vector
      change_of_normal(const Edges &u) const
      {
        return cross(u.a, x_.b) + cross(x_.a, u.b);
      }

      static Places
      on_vertices(const Vector &of_1, const Vector &of_2)
      {
        return {-(of_1 + of_2), of_1, of_2};
      }

      const Edges x_;
      const Vector normal_;
      const T size_;
      const Vector n_;
    };
  } // namespace

  const SpringKind &
  surface_areas()
  {
    static const VolumeKind<TriangleInSpace, QuadraticVolumeLaw> kind(
      "volumes");
    return kind;
  }

  const SpringKind &
  logarithmic_surface_areas()
  {
    static const VolumeKind<TriangleInSpace, LogarithmicVolumeLaw> kind(
      "volumes");
    return kind;
  }

  const SpringKind &
  logarithmic_surface_areas_in_plane_stress()
  {
    static const VolumeKind<TriangleInSpace, PlaneStressVolumeLaw> kind(
      "volumes");
    return kind;
  }
} // namespace springfit
