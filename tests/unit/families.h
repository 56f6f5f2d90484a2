#ifndef springfit_tests_unit_families_h
#define springfit_tests_unit_families_h

// What the tests of families of springs have in common.

#include <springfit/springs/network.h>
#include <springfit/springs/spring_kinds.h>
#include <springfit/springs/spring_law.h>

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "cells.h"

namespace springfit::oracle
{
  using Nodes   = std::vector<unsigned int>;
  using Numbers = std::vector<std::vector<double>>;

  inline constexpr SpringLaw laws[] = {SpringLaw::quadratic,
                                       SpringLaw::biquadratic};

  inline Nodes
  first_nodes(const unsigned int n)
  {
    Nodes nodes(n);
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }

  /**
   * Stiffness of either sign; rest values near one, of several coordinates of a
   * member that sum to near one; other numbers positive and of a similar size.
   */
  inline Numbers
  random_numbers(const SpringKind &kind, Random &random)
  {
    Numbers numbers;
    for (const auto &column : kind.columns())
      {
        numbers.emplace_back(column.width);
        for (double &number : numbers.back())
          switch (column.role)
            {
              case Column::Role::stiffness:
                number = random(-1., 1.);
                break;
              case Column::Role::rest_value:
                number = random(0.7, 1.3) / column.width;
                break;
              case Column::Role::parameter:
                number = random(0.6, 1.1);
                break;
            }
      }
    return numbers;
  }

  /** From the size of a member's Hessian. */
  inline int
  dimension_of(const SpringKind &kind)
  {
    Random random(400);
    Family family(kind);
    family.add(first_nodes(kind.n_nodes()), random_numbers(kind, random));
    const Eigen::MatrixXd x = random.matrix(3, kind.n_nodes());
    return kind.hessian(family.members, 0, x).rows() / kind.n_nodes();
  }

  inline std::string
  name_of(const SpringKind &kind)
  {
    return kind.word() + " of " + std::to_string(kind.n_nodes()) +
           " nodes in " + std::to_string(dimension_of(kind)) + "-d";
  }

  /** Places near those of a regular cell's vertices, or of some of them. */
  inline Eigen::MatrixXd
  random_places(const SpringKind &kind, Random &random)
  {
    const int dim = dimension_of(kind), n = kind.n_nodes();
    const CellKind cell =
      n == 1 << dim
        ? (dim == 2 ? CellKind::quadrilateral : CellKind::hexahedron)
        : (dim == 2 ? CellKind::triangle : CellKind::tetrahedron);
    const Eigen::MatrixXd regular = regular_cell(cell).leftCols(n);
    return regular + 0.15 * random.matrix(dim, n);
  }

  struct Sample
  {
    Family family;
    Eigen::MatrixXd x;
  };

  /** Members that share cells of nodes. */
  inline Sample
  random_sample(const SpringKind &kind,
                const unsigned int n_members,
                Random &random,
                const unsigned int n_cells = 3)
  {
    const int dim = dimension_of(kind), n = kind.n_nodes();
    Sample sample{Family(kind), Eigen::MatrixXd(dim, n * n_cells)};
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      sample.x.middleCols(n * cell, n) = random_places(kind, random);
    for (unsigned int m = 0; m < n_members; ++m)
      {
        Nodes nodes = first_nodes(n);
        for (unsigned int &node : nodes)
          node += n * (m % n_cells);
        sample.family.add(nodes, random_numbers(kind, random));
      }
    return sample;
  }

  inline Eigen::MatrixXd
  zero_like(const Eigen::MatrixXd &x)
  {
    return Eigen::MatrixXd::Zero(x.rows(), x.cols());
  }

  inline double
  energy_of(const Family &family, const Eigen::MatrixXd &x)
  {
    return family.kind->energy(family.members, x);
  }

  inline Eigen::MatrixXd
  forces_of(const Family &family, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd forces = zero_like(x);
    family.kind->add_forces(family.members, x, forces);
    return forces;
  }

  inline Eigen::MatrixXd
  product_of(const Family &family,
             const Eigen::MatrixXd &x,
             const Eigen::MatrixXd &u)
  {
    Eigen::MatrixXd product = zero_like(x);
    family.kind->add_tangent_product(family.members, x, u, product);
    return product;
  }

  /** Column by column of add_tangent_product(). */
  inline Eigen::MatrixXd
  tangent_by_products(const Family &family, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd K(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      {
        Eigen::MatrixXd u = zero_like(x);
        u.data()[i]       = 1.;
        K.col(i)          = product_of(family, x, u).reshaped();
      }
    return K;
  }

  inline TangentMatrix
  empty_tangent(const Family &family, const Eigen::MatrixXd &x)
  {
    NodePattern pattern(x.cols());
    add_to_pattern({family}, pattern);
    return TangentMatrix(x.rows(), pattern);
  }

  inline Eigen::MatrixXd
  tangent_of(const Family &family, const Eigen::MatrixXd &x)
  {
    TangentMatrix tangent = empty_tangent(family, x);
    family.kind->add_tangent(family.members, x, tangent);
    return tangent.matrix();
  }

  inline Eigen::MatrixXd
  convex_tangent_of(const Family &family, const Eigen::MatrixXd &x)
  {
    TangentMatrix tangent = empty_tangent(family, x);
    family.kind->add_convex_tangent(family.members, x, tangent);
    return tangent.matrix();
  }

  inline Eigen::MatrixXd
  diagonal_blocks_of(const Family &family, const Eigen::MatrixXd &x)
  {
    Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(x.rows(), x.size());
    family.kind->add_diagonal_blocks(family.members, x, blocks);
    return blocks;
  }

  /** The sum of matrices of members, each with respect to its own nodes. */
  template <typename OfMember>
  Eigen::MatrixXd
  assembled(const Family &family,
            const Eigen::MatrixXd &x,
            const OfMember &of_member)
  {
    const int dim     = x.rows();
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
    for (std::size_t m = 0; m < family.size(); ++m)
      {
        const Eigen::MatrixXd H = of_member(m);
        for (unsigned int a = 0; a < family.kind->n_nodes(); ++a)
          for (unsigned int b = 0; b < family.kind->n_nodes(); ++b)
            K.block(dim * family.nodes(m)[a],
                    dim * family.nodes(m)[b],
                    dim,
                    dim) += H.block(dim * a, dim * b, dim, dim);
      }
    return K;
  }

  /** The difference relative to the size of the expected one. */
  inline double
  distance(const Eigen::MatrixXd &found, const Eigen::MatrixXd &expected)
  {
    return (found - expected).norm() / (1. + expected.norm());
  }

  /** Every operation on @p family must be that on @p expected. */
  inline void
  expect_the_same(const Family &family,
                  const Family &expected,
                  const Eigen::MatrixXd &x,
                  Random &random)
  {
    const Eigen::MatrixXd u = random.matrix(x.rows(), x.cols());
    EXPECT_LT(distance(forces_of(family, x), forces_of(expected, x)), 1e-13);
    EXPECT_LT(distance(product_of(family, x, u), product_of(expected, x, u)),
              1e-13);
    EXPECT_LT(distance(tangent_of(family, x), tangent_of(expected, x)), 1e-13);
    EXPECT_LT(distance(convex_tangent_of(family, x),
                       convex_tangent_of(expected, x)),
              1e-13);
    EXPECT_LT(distance(diagonal_blocks_of(family, x),
                       diagonal_blocks_of(expected, x)),
              1e-13);
  }

  /** Runs a check on every kind that there is. */
  template <typename Check>
  void
  for_every_kind(const Check &check)
  {
    for (const SpringKind *kind : spring_kinds())
      {
        SCOPED_TRACE(name_of(*kind));
        check(*kind);
      }
  }
} // namespace springfit::oracle

#endif
