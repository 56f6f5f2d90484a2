#include <springfit/core/error.h>
#include <springfit/fit/cell/ipopt_engine.h>
#include <springfit/fit/programs/ipopt_application.h>

#include <IpJournalist.hpp>
#include <IpTNLP.hpp>

#include <sstream>

namespace springfit
{
  namespace
  {
    using Ipopt::Index;
    using Ipopt::Number;

    // What Ipopt takes for infinity.
    constexpr Number unbounded = 1e20;

    using ConstVectorView = Eigen::Map<const Eigen::VectorXd>;
    using VectorView      = Eigen::Map<Eigen::VectorXd>;

    /**
     * Hands the pivots and their derivatives over to Ipopt: minimise t over
     * x = (k, t) with all pivots >= 0. An evaluation outside the cone returns
     * false, which makes Ipopt shorten the step.
     *
     * So does one that cuts a pivot to less than a tenth. Ipopt keeps its
     * slack variables from the boundary but not the pivots themselves, which
     * fall faster than their linearisation; iterates that come too close to
     * the boundary (in one hexahedron of two hundred) never get away again.
     */
    class PivotProgram : public Ipopt::TNLP
    {
    public:
      explicit PivotProgram(const SpectralProblem &problem) : problem_(problem)
      {}

      /** (k, t) and the multipliers of the pivots; empty before the end. */
      Eigen::VectorXd x;
      Eigen::VectorXd y;

      bool
      get_nlp_info(Index &n,
                   Index &m,
                   Index &n_jacobian,
                   Index &n_hessian,
                   IndexStyleEnum &index_style) override
      {
        n           = problem_.B.cols() + 1;
        m           = n_pivots(problem_);
        n_jacobian  = n * m;
        n_hessian   = n * (n + 1) / 2;
        index_style = C_STYLE;
        return true;
      }

      bool
      get_bounds_info(Index n,
                      Number *x_lower,
                      Number *x_upper,
                      Index m,
                      Number *g_lower,
                      Number *g_upper) override
      {
        VectorView(x_lower, n).setConstant(-unbounded);
        VectorView(x_lower, n).head(problem_.n_nonnegative).setZero();
        VectorView(x_upper, n).setConstant(unbounded);
        VectorView(g_lower, m).setZero();
        VectorView(g_upper, m).setConstant(unbounded);
        return true;
      }

      bool
      get_starting_point(Index n,
                         bool init_x,
                         Number *x_start,
                         bool /*init_z*/,
                         Number * /*z_lower*/,
                         Number * /*z_upper*/,
                         Index /*m*/,
                         bool /*init_lambda*/,
                         Number * /*lambda*/) override
      {
        if (init_x)
          VectorView(x_start, n) = interior_point(problem_);
        return true;
      }

      bool
      eval_f(Index n, const Number *x_now, bool, Number &objective) override
      {
        objective = x_now[n - 1];
        return true;
      }

      bool
      eval_grad_f(Index n, const Number *, bool, Number *gradient) override
      {
        VectorView(gradient, n) = Eigen::VectorXd::Unit(n, n - 1);
        return true;
      }

      bool
      eval_g(Index n, const Number *x_now, bool, Index m, Number *g) override
      {
        const auto d = pivots(problem_, ConstVectorView(x_now, n));
        if (!d || (current_pivots_.size() > 0 &&
                   (d->array() < 0.1 * current_pivots_.array()).any()))
          return false;
        VectorView(g, m) = *d;
        return true;
      }

      bool
      eval_jac_g(Index n,
                 const Number *x_now,
                 bool,
                 Index m,
                 Index,
                 Index *rows,
                 Index *columns,
                 Number *values) override
      {
        if (values == nullptr)
          {
            for (Index j = 0, entry = 0; j < n; ++j)
              for (Index i = 0; i < m; ++i, ++entry)
                {
                  rows[entry]    = i;
                  columns[entry] = j;
                }
            return true;
          }
        const auto d = pivots(problem_, ConstVectorView(x_now, n));
        const auto jacobian =
          pivot_jacobian(problem_, ConstVectorView(x_now, n));
        if (!d || !jacobian)
          return false;
        // Derivatives are asked for at accepted points only.
        current_pivots_                           = *d;
        Eigen::Map<Eigen::MatrixXd>(values, m, n) = *jacobian;
        return true;
      }

      bool
      eval_h(Index n,
             const Number *x_now,
             bool,
             Number, // t is linear
             Index m,
             const Number *lambda,
             bool,
             Index,
             Index *rows,
             Index *columns,
             Number *values) override
      {
        if (values == nullptr)
          {
            for (Index j = 0, entry = 0; j < n; ++j)
              for (Index i = j; i < n; ++i, ++entry)
                {
                  rows[entry]    = i;
                  columns[entry] = j;
                }
            return true;
          }
        const auto hessian = pivot_hessian(problem_,
                                           ConstVectorView(x_now, n),
                                           ConstVectorView(lambda, m));
        if (!hessian)
          return false;
        for (Index j = 0; j < n; ++j)
          for (Index i = j; i < n; ++i)
            *values++ = (*hessian)(i, j);
        return true;
      }

      void
      finalize_solution(Ipopt::SolverReturn,
                        Index n,
                        const Number *x_end,
                        const Number *,
                        const Number *,
                        Index m,
                        const Number *,
                        const Number *lambda,
                        Number,
                        const Ipopt::IpoptData *,
                        Ipopt::IpoptCalculatedQuantities *) override
      {
        x = ConstVectorView(x_end, n);
        // Ipopt's Lagrangian is t + lambda^T d: those of d >= 0 are <= 0.
        y = -ConstVectorView(lambda, m);
      }

    private:
      const SpectralProblem &problem_;
      Eigen::VectorXd current_pivots_;
    };


    void
    set_path(Ipopt::IpoptApplication &application, const double mu)
    {
      auto &options = *application.Options();
      options.SetStringValue("mu_strategy", "monotone");
      options.SetNumericValue("mu_init", 1e-2);
      options.SetNumericValue("mu_target", mu);
      // One step of mu at a time keeps the iterates near the central path.
      options.SetStringValue("mu_allow_fast_monotone_decrease", "no");
      options.SetNumericValue("compl_inf_tol", mu);
      // What rounding in the multipliers lets the dual infeasibility reach;
      // the certificate accounts for it.
      options.SetNumericValue("tol", 1e-8);
      // No refinement of the steps: a third of the time, and the certificate
      // tells whether they were good enough.
      options.SetStringValue("fast_step_computation", "yes");
      options.SetIntegerValue("max_iter", 200);
    }
  } // namespace


  SpectralSolution
  solve_by_ipopt(const SpectralProblem &problem, const double mu)
  {
    const auto application = make_ipopt_application();
    set_path(*application, mu);
    application->Initialize("");

    Ipopt::SmartPtr<PivotProgram> program = new PivotProgram(problem);
    // The status says little: a search direction may be "too small" at a gap
    // of 1e-9. What counts is the certificate of the point.
    application->OptimizeTNLP(program);

    const auto solution = program->x.size() == 0
                            ? std::optional<SpectralSolution>()
                            : pivot_solution(problem, program->x, program->y);
    if (!solution)
      throw RunError("Ipopt found no point of a spectral fit.",
                     "Set 'Fit/Engine' to 'barrier'.");
    return *solution;
  }


  std::string
  derivative_report(const SpectralProblem &problem)
  {
    const auto application = make_ipopt_application();
    auto &options          = *application->Options();
    options.SetStringValue("derivative_test", "second-order");
    options.SetNumericValue("point_perturbation_radius", 0.);
    options.SetIntegerValue("max_iter", 0);

    std::ostringstream report;
    Ipopt::SmartPtr<Ipopt::StreamJournal> journal =
      new Ipopt::StreamJournal("report", Ipopt::J_ITERSUMMARY);
    journal->SetOutputStream(&report);
    application->Jnlst()->AddJournal(Ipopt::GetRawPtr(journal));
    application->Initialize("");
    application->OptimizeTNLP(new PivotProgram(problem));
    application->Jnlst()->DeleteAllJournals();
    return report.str();
  }
} // namespace springfit
