#ifndef springfit_tests_extremes_checks_h
#define springfit_tests_extremes_checks_h

// What a fit claims of a cell, by arithmetic of its own.

#include <springfit/fit/fit.h>
#include <springfit/springs/negative.h>

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <vector>

#include "../unit/cells.h"

namespace springfit::oracle
{
  /** The gradient of the distance of two nodes. */
  inline Eigen::VectorXd
  distance_gradient(const Eigen::MatrixXd &x, const int i, const int j)
  {
    const Eigen::VectorXd n = (x.col(j) - x.col(i)).normalized();
    Eigen::MatrixXd b       = 0. * x;
    b.col(i)                = -n;
    b.col(j)                = n;
    return b.reshaped();
  }

  /** That of the angle at @p j. */
  inline Eigen::VectorXd
  angle_gradient(const Eigen::MatrixXd &x,
                 const int i,
                 const int j,
                 const int k)
  {
    const Eigen::VectorXd u = x.col(i) - x.col(j), v = x.col(k) - x.col(j);
    const double product = u.dot(v);
    // Perpendicular to u in the plane of both, away from v.
    const Eigen::VectorXd p = (product / u.squaredNorm() * u - v).normalized();
    const Eigen::VectorXd q = (product / v.squaredNorm() * v - u).normalized();
    Eigen::MatrixXd b       = 0. * x;
    b.col(i)                = p / u.norm();
    b.col(k)                = q / v.norm();
    b.col(j)                = -b.col(i) - b.col(k);
    return b.reshaped();
  }

  /** That of the volume of the P1 or Q1 mapping, as a sum over its quadrature.
   */
  inline Eigen::VectorXd
  volume_gradient_of(const Eigen::MatrixXd &x, const CellKind kind)
  {
    const int dim          = x.rows();
    Eigen::MatrixXd result = 0. * x;
    const auto add         = [&](const Eigen::MatrixXd &reference,
                         const double weight) {
      const Eigen::MatrixXd J = x * reference.transpose();
      // Cofactors rather than an inverse: J may be all but singular.
      Eigen::MatrixXd cofactors(dim, dim);
      if (dim == 2)
        cofactors << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
      else
        for (int c = 0; c < 3; ++c)
          {
            const Eigen::Vector3d a = J.col((c + 1) % 3),
                                  b = J.col((c + 2) % 3);
            cofactors.col(c)        = a.cross(b);
          }
      result += weight * cofactors * reference;
    };
    if (is_simplex(kind))
      {
        Eigen::MatrixXd reference(dim, dim + 1);
        reference.rightCols(dim).setIdentity();
        reference.col(0).setConstant(-1.);
        add(reference, dim == 2 ? 0.5 : 1. / 6.);
      }
    else
      for (int q = 0; q < 1 << dim; ++q)
        {
          Eigen::MatrixXd reference(dim, 1 << dim);
          for (int v = 0; v < 1 << dim; ++v)
            for (int d = 0; d < dim; ++d)
              {
                double product = 1.;
                for (int e = 0; e < dim; ++e)
                  {
                    const double xi =
                      0.5 + (q >> e & 1 ? 0.5 : -0.5) / std::sqrt(3.);
                    product *= e == d ? (v >> e & 1 ? 1. : -1.)
                                      : (v >> e & 1 ? xi : 1. - xi);
                  }
                reference(d, v) = product;
              }
          add(reference, 1. / (1 << dim));
        }
    return result.reshaped();
  }

  /**
   * The stiffness at rest of springs, couplings, angles and volumes that are
   * not under tension; of others as the network has it.
   */
  inline Eigen::MatrixXd
  stiffness_of(const CellModel &model, const FitProblem &problem)
  {
    const auto &x     = problem.points;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(x.size(), x.size());
    for (const auto &family : model.families)
      {
        const std::string word = family.kind->word();
        const bool is_known =
          !are_under_tension(model.families) &&
          (word == "springs" || word == "couplings" || word == "angles" ||
           (word == "volumes" && family.kind->columns().size() == 2));
        if (!is_known)
          {
            K += Eigen::MatrixXd(tangent({family}, x));
            continue;
          }
        for (std::size_t m = 0; m < family.size(); ++m)
          {
            const double k    = family.members.columns[0][m];
            const auto *nodes = family.nodes(m);
            Eigen::VectorXd b;
            if (word == "springs")
              b = distance_gradient(x, nodes[0], nodes[1]);
            else if (word == "angles")
              b = angle_gradient(x, nodes[0], nodes[1], nodes[2]);
            else if (word == "volumes")
              b = volume_gradient_of(x, problem.kind);
            else
              {
                b = distance_gradient(x, nodes[0], nodes[1]);
                const Eigen::VectorXd c =
                  distance_gradient(x, nodes[2], nodes[3]);
                K += k * (b * c.transpose() + c * b.transpose());
                continue;
              }
            K += k * b * b.transpose();
          }
      }
    return K;
  }

  /** An orthonormal basis of what is no rigid motion. */
  inline Eigen::MatrixXd
  deformations_of(const Eigen::MatrixXd &points)
  {
    const int dim = points.rows();
    const Eigen::MatrixXd x =
      (points.colwise() - points.rowwise().mean()) /
      (points.colwise() - points.rowwise().mean()).norm();
    std::vector<Eigen::VectorXd> rigid;
    for (int d = 0; d < dim; ++d)
      {
        Eigen::MatrixXd u = 0. * x;
        u.row(d).setOnes();
        rigid.push_back(u.reshaped());
        for (int e = 0; e < d; ++e)
          {
            Eigen::MatrixXd w = 0. * x;
            w.row(d)          = x.row(e);
            w.row(e)          = -x.row(d);
            rigid.push_back(w.reshaped());
          }
      }
    Eigen::MatrixXd all(x.size(), rigid.size());
    for (std::size_t i = 0; i < rigid.size(); ++i)
      all.col(i) = rigid[i].normalized();
    const Eigen::MatrixXd Q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(all).householderQ();
    return Q.rightCols(x.size() - rigid.size());
  }

  inline double
  norm_of(const Eigen::MatrixXd &symmetric)
  {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
             symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
  }

  /** The gradients of a cell's springs and of its volume or its angles. */
  inline Eigen::MatrixXd
  gradients_of(const FitProblem &problem, const CellModel &model)
  {
    std::vector<Eigen::VectorXd> columns;
    for (const auto &family : model.families)
      for (std::size_t m = 0; m < family.size(); ++m)
        {
          const auto *nodes      = family.nodes(m);
          const std::string word = family.kind->word();
          columns.push_back(
            word == "springs"
              ? distance_gradient(problem.points, nodes[0], nodes[1])
            : word == "angles"
              ? angle_gradient(problem.points, nodes[0], nodes[1], nodes[2])
              : volume_gradient_of(problem.points, problem.kind));
        }
    Eigen::MatrixXd B(problem.points.size(), columns.size());
    for (std::size_t s = 0; s < columns.size(); ++s)
      B.col(s) = columns[s].normalized();
    return B;
  }

  /**
   * A lower bound of ||R - B diag(k) B^T||_2 over all k, from the eigenvectors
   * of E whose eigenvalues are within a @p share of the norm: M of their span
   * that is orthogonal to all b b^T as near as can be, and then made so. R and
   * B as the deformations see them, ||R||_2 = 1.
   */
  inline double
  bound_of(const Eigen::MatrixXd &R,
           const Eigen::MatrixXd &E,
           const Eigen::MatrixXd &B,
           const double share)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(E);
    const double t = eigen.eigenvalues().cwiseAbs().maxCoeff();
    std::vector<Eigen::MatrixXd> parts;
    std::vector<double> traces;
    for (const double sign : {1., -1.})
      for (Eigen::Index a = 0; a < E.rows(); ++a)
        for (Eigen::Index b = 0; b <= a; ++b)
          if (std::min(sign * eigen.eigenvalues()[a],
                       sign * eigen.eigenvalues()[b]) > (1. - share) * t)
            {
              const Eigen::MatrixXd product =
                sign * eigen.eigenvectors().col(a) *
                eigen.eigenvectors().col(b).transpose();
              parts.push_back(product + product.transpose());
              traces.push_back(a == b ? 2. : 0.);
            }
    Eigen::MatrixXd conditions(B.cols() + 1, parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      {
        for (Eigen::Index s = 0; s < B.cols(); ++s)
          conditions(s, p) = B.col(s).dot(parts[p] * B.col(s));
        conditions(B.cols(), p) = traces[p];
      }
    const Eigen::VectorXd weights =
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(conditions)
        .solve(Eigen::VectorXd::Unit(B.cols() + 1, B.cols()));
    Eigen::MatrixXd M = 0. * E;
    for (std::size_t p = 0; p < parts.size(); ++p)
      M += weights[p] * parts[p];

    Eigen::MatrixXd tangents(R.size(), B.cols());
    for (Eigen::Index s = 0; s < B.cols(); ++s)
      tangents.col(s) = (B.col(s) * B.col(s).transpose()).reshaped();
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> basis(
      tangents);
    for (unsigned int time = 0; time < 2; ++time)
      M -= Eigen::MatrixXd(
        (tangents * basis.solve(M.reshaped())).reshaped(M.rows(), M.cols()));
    const double size =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(M, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseAbs()
        .sum();
    return R.cwiseProduct(M).sum() / size;
  }

  /**
   * Whether some other constants are better by more than the gap allows, or a
   * free fit is far above a bound of its own.
   */
  inline std::string
  objection_to_certificate(const FitResult &result,
                           const FitProblem &problem,
                           const FitOptions &options,
                           const Eigen::MatrixXd &K,
                           const Eigen::MatrixXd &Q,
                           const double size)
  {
    const double gap   = *result.duality_gap;
    const double value = result.spectral_residual;
    const Eigen::MatrixXd E =
      Q.transpose() * (problem.stiffness - K) * Q / size;
    const Eigen::MatrixXd R = Q.transpose() * problem.stiffness * Q / size;
    const Eigen::MatrixXd B = Q.transpose() * gradients_of(problem, result);
    if (!options.nonnegative && value > 1e-3)
      {
        double best = 0.;
        for (const double share : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
          best = std::max(best, bound_of(R, E, B, share));
        if (best > value + 1e-6)
          return "it is below a bound";
        if (best < 0.95 * value)
          return "it is far above the best bound";
      }
    Random random(3);
    for (const double step : {1e-6, 1e-4, 1e-2})
      for (unsigned int trial = 0; trial < 4; ++trial)
        {
          Eigen::VectorXd change = step * random.matrix(B.cols(), 1);
          // More of what is there is always allowed.
          if (options.nonnegative)
            change = change.cwiseAbs();
          const double other =
            norm_of(E - B * change.asDiagonal() * B.transpose());
          if (other < value - gap - 1e-7)
            return "a change of the constants beats the certificate";
        }
    return "";
  }

  /** What is wrong with a result that was not refused; empty if nothing is. */
  inline std::string
  objection_to(const FitResult &result,
               const FitProblem &problem,
               const Method &method,
               const FitOptions &options)
  {
    const auto far = [](const double a, const double b) {
      return !(std::abs(a - b) <= 1e-5 * std::max(1., std::abs(b)));
    };
    const auto complain =
      [](const std::string &what, const double claimed, const double found) {
        char text[100];
        std::snprintf(text,
                      sizeof(text),
                      "%s %.8g, found %.8g",
                      what.c_str(),
                      claimed,
                      found);
        return std::string(text);
      };
    const Eigen::MatrixXd &R = problem.stiffness;
    const Eigen::MatrixXd K  = stiffness_of(result, problem);
    const Eigen::MatrixXd E  = R - K;
    if (!K.allFinite())
      return "constants are not finite";
    const double frobenius = E.norm() / R.norm();
    if (far(result.frobenius_residual, frobenius))
      return complain("Frobenius residual",
                      result.frobenius_residual,
                      frobenius);
    const double size     = norm_of(R);
    const double spectral = norm_of(E) / size;
    if (far(result.spectral_residual, spectral))
      return complain("spectral residual", result.spectral_residual, spectral);

    const Eigen::MatrixXd Q = deformations_of(problem.points);
    const double smallest =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Q.transpose() * K * Q,
                                                     Eigen::EigenvaluesOnly)
        .eigenvalues()[0] /
      size;
    if (result.smallest_eigenvalue &&
        far(*result.smallest_eigenvalue, smallest))
      return complain("smallest eigenvalue",
                      *result.smallest_eigenvalue,
                      smallest);

    const bool is_bounded = options.nonnegative &&
                            options.enrichment != Enrichment::coupling &&
                            !has(method, Feature::formulas);
    if (is_bounded)
      {
        if (result.n_negative > 0)
          return "springs are negative";
        const double of_cell =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Q.transpose() * R * Q,
                                                         Eigen::EigenvaluesOnly)
            .eigenvalues()[0] /
          size;
        // A mechanism is one where the cell itself is not as soft.
        if (smallest < 0.02 * of_cell - 1e-10)
          return complain("it is a mechanism, the cell's smallest eigenvalue",
                          of_cell,
                          smallest);
      }
    if (result.duality_gap)
      {
        if (!(*result.duality_gap > -1e-9))
          return complain("a bound above the value by",
                          *result.duality_gap,
                          0.);
        const bool is_exact = options.enrichment == Enrichment::coupling;
        if (method.word == "spectral" && !is_exact)
          {
            const auto objection =
              objection_to_certificate(result, problem, options, K, Q, size);
            if (!objection.empty())
              return objection;
          }
      }
    constexpr double no_result = 100.;
    if (spectral > no_result)
      return complain("a residual that is no result", spectral, no_result);
    return "";
  }
} // namespace springfit::oracle

#endif
