#ifndef springfit_springs_lanes_h
#define springfit_springs_lanes_h

#include <array>
#include <cmath>
#include <cstddef>

namespace springfit
{
  // Arithmetic that is the same for one member of a family (T = double) and for
  // several at once (T = Lanes), one in each lane of a register. GCC and clang
  // have the type; the compiler's flags say how wide registers are.

#ifdef __AVX__
  constexpr std::size_t n_lanes = 4;
#else
  constexpr std::size_t n_lanes = 2;
#endif
  using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));

  inline double
  lane(const double value, std::size_t)
  {
    return value;
  }

  inline double
  lane(const Lanes &values, const std::size_t l)
  {
    return values[l];
  }

  inline void
  set_lane(double &value, std::size_t, const double number)
  {
    value = number;
  }

  inline void
  set_lane(Lanes &values, const std::size_t l, const double number)
  {
    values[l] = number;
  }


  inline double
  square_root(const double value)
  {
    return std::sqrt(value);
  }

  inline Lanes
  square_root(const Lanes &values)
  {
    Lanes roots;
    for (std::size_t l = 0; l < n_lanes; ++l)
      roots[l] = std::sqrt(values[l]);
    return roots;
  }


  /** A vector in the plane or in space. */
  template <int dim, typename T>
  struct SmallVector
  {
    T c[dim];

    SmallVector
    operator+(const SmallVector &other) const
    {
      SmallVector sum;
      for (int d = 0; d < dim; ++d)
        sum.c[d] = c[d] + other.c[d];
      return sum;
    }

    SmallVector
    operator-(const SmallVector &other) const
    {
      SmallVector difference;
      for (int d = 0; d < dim; ++d)
        difference.c[d] = c[d] - other.c[d];
      return difference;
    }

    SmallVector
    operator-() const
    {
      SmallVector opposite;
      for (int d = 0; d < dim; ++d)
        opposite.c[d] = -c[d];
      return opposite;
    }

    SmallVector
    operator*(const T &factor) const
    {
      SmallVector product;
      for (int d = 0; d < dim; ++d)
        product.c[d] = c[d] * factor;
      return product;
    }
  };

  template <int dim, typename T>
  T
  dot(const SmallVector<dim, T> &a, const SmallVector<dim, T> &b)
  {
    T sum = a.c[0] * b.c[0];
    for (int d = 1; d < dim; ++d)
      sum += a.c[d] * b.c[d];
    return sum;
  }

  template <typename T>
  SmallVector<3, T>
  cross(const SmallVector<3, T> &a, const SmallVector<3, T> &b)
  {
    return {{a.c[1] * b.c[2] - a.c[2] * b.c[1],
             a.c[2] * b.c[0] - a.c[0] * b.c[2],
             a.c[0] * b.c[1] - a.c[1] * b.c[0]}};
  }

  /** a_x b_y - a_y b_x */
  template <typename T>
  T
  cross(const SmallVector<2, T> &a, const SmallVector<2, T> &b)
  {
    return a.c[0] * b.c[1] - a.c[1] * b.c[0];
  }

  /** The derivative of cross(a, b) with respect to a. */
  template <typename T>
  SmallVector<2, T>
  turned(const SmallVector<2, T> &b)
  {
    return {{b.c[1], -b.c[0]}};
  }

  /** The vectors of n nodes. */
  template <int dim, int n, typename T>
  using NodeVectors = std::array<SmallVector<dim, T>, n>;

  template <int dim, std::size_t n, typename T>
  T
  dot(const std::array<SmallVector<dim, T>, n> &a,
      const std::array<SmallVector<dim, T>, n> &b)
  {
    T sum = dot(a[0], b[0]);
    for (std::size_t v = 1; v < n; ++v)
      sum += dot(a[v], b[v]);
    return sum;
  }
} // namespace springfit

#endif
