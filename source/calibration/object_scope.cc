#include <springfit/calibration/object_scope.h>
#include <springfit/core/error.h>
#include <springfit/fit/displacement_fields.h>
#include <springfit/fit/object/free_body.h>
#include <springfit/reference/cell_matrices.h>
#include <springfit/springs/network.h>

#include <cmath>
#include <vector>

namespace springfit
{
  namespace
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;

    /**
     * The largest |eigenvalue| of a symmetric matrix by the power method, from
     * below: to some digits, which is enough to judge a fit by.
     */
    double
    spectral_norm(const SparseMatrix &A)
    {
      // Of no symmetry that the matrix may have.
      Eigen::VectorXd x(A.cols());
      for (Eigen::Index i = 0; i < x.size(); ++i)
        x[i] = std::sin(1. + i * std::sqrt(2.));
      x.normalize();
      double norm = 0.;
      for (int step = 0; step < 1000; ++step)
        {
          const Eigen::VectorXd y = A * (A * x);
          const double size       = y.norm();
          const double previous   = norm;
          norm                    = std::sqrt(size);
          if (!(size > 0.) || norm - previous < 1e-7 * norm)
            break;
          x = y / size;
        }
      return norm;
    }
  } // namespace

  const WordTable<Scope> &
  scope_words()
  {
    static const WordTable<Scope> table = {{Scope::cell, "cell"},
                                           {Scope::object, "object"}};
    return table;
  }

  const WordTable<Field> &
  field_words()
  {
    static const WordTable<Field> table = {{Field::affine, "affine"},
                                           {Field::quadratic, "quadratic"},
                                           {Field::responses, "responses"}};
    return table;
  }

  Eigen::MatrixXd
  displacement_fields(const std::vector<Field> &fields,
                      const ObjectProblem &problem,
                      const Eigen::MatrixXd &responses)
  {
    const auto respond = [&problem](const Eigen::MatrixXd &forces) {
      return FreeBody(problem.stiffness, problem.nodes).respond(forces);
    };
    Eigen::MatrixXd all(problem.nodes.size(), 0);
    const auto append = [&all](const Eigen::MatrixXd &columns) {
      all.conservativeResize(Eigen::NoChange, all.cols() + columns.cols());
      all.rightCols(columns.cols()) = columns;
    };
    for (const Field field : fields)
      switch (field)
        {
          case Field::affine:
            append(respond(affine_fields(problem.nodes)));
            break;
          case Field::quadratic:
            append(respond(quadratic_fields(problem.nodes)));
            break;
          case Field::responses:
            append(responses);
            break;
        }
    return all;
  }

  template <int dim>
  Eigen::SparseMatrix<double>
  object_stiffness(const Mesh<dim> &mesh,
                   const Element<dim> &element,
                   const MaterialTable &materials)
  {
    CellMatrices<dim> cell_matrices(element);
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const Eigen::MatrixXd R =
          cell_matrices.stiffness(cell, materials.at(cell->material_id()));
        const auto dof = [&cell](const Eigen::Index local) {
          return dim * cell->vertex_index(local / dim) + local % dim;
        };
        for (Eigen::Index b = 0; b < R.cols(); ++b)
          for (Eigen::Index a = 0; a < R.rows(); ++a)
            entries.emplace_back(dof(a), dof(b), R(a, b));
      }
    const Eigen::Index n = dim * mesh.triangulation.n_vertices();
    Eigen::SparseMatrix<double> stiffness(n, n);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    return stiffness;
  }

  ObjectProblem
  make_object_problem(const SpringNetwork &network,
                      const Eigen::SparseMatrix<double> &stiffness,
                      const bool nonnegative)
  {
    const Families unit =
      with_constants(network.families,
                     Eigen::VectorXd::Ones(
                       constants_of(network.families).size()));
    if (!std::isfinite(energy(unit, network.nodes)))
      throw RunError("A term of the springs has no tangent at rest.",
                     "Improve the mesh: a cell may be flat.");

    ObjectProblem problem{network.nodes, stiffness, {}, {}};
    for (const auto &family : unit)
      for (std::size_t m = 0; m < family.size(); ++m)
        {
          const unsigned int n      = family.kind->n_nodes();
          const unsigned int *nodes = family.nodes(m);
          problem.terms.push_back(
            {{nodes, nodes + n},
             0.,
             {},
             family.kind->hessian(family.members, m, network.nodes)});
          problem.nonnegative.push_back(nonnegative && n == 2);
        }
    return problem;
  }

  ObjectFit
  fit_object(const ObjectProblem &problem,
             const Method &method,
             const Eigen::MatrixXd &fields,
             const Eigen::VectorXd &prior)
  {
    const Eigen::VectorXd constants = method.fit_object(problem, fields, prior);
    if (!constants.allFinite())
      throw RunError("The fit of the whole object gave constants that are not "
                     "finite.",
                     "Improve the mesh.");
    return judge_object(problem, constants);
  }

  ObjectFit
  judge_object(const ObjectProblem &problem, const Eigen::VectorXd &constants)
  {
    const auto &R        = problem.stiffness;
    const SparseMatrix K = fitted_stiffness(problem, constants);
    const SparseMatrix E = R - K;
    return {constants,
            E.norm() / R.norm(),
            spectral_norm(E) / spectral_norm(R),
            FreeBody(K, problem.nodes).n_unstable()};
  }

  template Eigen::SparseMatrix<double>
  object_stiffness<2>(const Mesh<2> &,
                      const Element<2> &,
                      const MaterialTable &);
  template Eigen::SparseMatrix<double>
  object_stiffness<3>(const Mesh<3> &,
                      const Element<3> &,
                      const MaterialTable &);
} // namespace springfit
