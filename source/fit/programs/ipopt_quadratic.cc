#include <springfit/core/error.h>
#include <springfit/fit/programs/ipopt_application.h>
#include <springfit/fit/programs/ipopt_quadratic.h>

#include <IpTNLP.hpp>

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

    /** A quadratic program with bounds only, as Ipopt asks for it. */
    class QuadraticProgram : public Ipopt::TNLP
    {
    public:
      QuadraticProgram(const Eigen::SparseMatrix<double> &G,
                       const Eigen::VectorXd &g,
                       const std::vector<bool> &nonnegative,
                       const Eigen::VectorXd &start)
        : G_(G)
        , lower_(G.triangularView<Eigen::Lower>())
        , g_(g)
        , nonnegative_(nonnegative)
        , start_(start)
      {}

      /** Empty before the end. */
      Eigen::VectorXd x;

      bool
      get_nlp_info(Index &n,
                   Index &m,
                   Index &n_jacobian,
                   Index &n_hessian,
                   IndexStyleEnum &index_style) override
      {
        n           = g_.size();
        m           = 0;
        n_jacobian  = 0;
        n_hessian   = lower_.nonZeros();
        index_style = C_STYLE;
        return true;
      }

      bool
      get_bounds_info(Index n,
                      Number *x_lower,
                      Number *x_upper,
                      Index,
                      Number *,
                      Number *) override
      {
        for (Index s = 0; s < n; ++s)
          x_lower[s] = nonnegative_[s] ? 0. : -unbounded;
        VectorView(x_upper, n).setConstant(unbounded);
        return true;
      }

      bool
      get_starting_point(Index n,
                         bool,
                         Number *x_start,
                         bool,
                         Number *,
                         Number *,
                         Index,
                         bool,
                         Number *) override
      {
        VectorView(x_start, n) = start_;
        return true;
      }

      bool
      eval_f(Index n, const Number *x_now, bool, Number &objective) override
      {
        const ConstVectorView x_view(x_now, n);
        objective = x_view.dot(0.5 * (G_ * x_view) - g_);
        return true;
      }

      bool
      eval_grad_f(Index n, const Number *x_now, bool, Number *gradient) override
      {
        VectorView(gradient, n) = G_ * ConstVectorView(x_now, n) - g_;
        return true;
      }

      bool
      eval_g(Index, const Number *, bool, Index, Number *) override
      {
        return true;
      }

      bool
      eval_jac_g(Index,
                 const Number *,
                 bool,
                 Index,
                 Index,
                 Index *,
                 Index *,
                 Number *) override
      {
        return true;
      }

      bool
      eval_h(Index,
             const Number *,
             bool,
             Number factor,
             Index,
             const Number *,
             bool,
             Index,
             Index *rows,
             Index *columns,
             Number *values) override
      {
        Index entry = 0;
        for (Index s = 0; s < lower_.outerSize(); ++s)
          for (Eigen::SparseMatrix<double>::InnerIterator it(lower_, s); it;
               ++it, ++entry)
            if (values != nullptr)
              values[entry] = factor * it.value();
            else
              {
                rows[entry]    = it.row();
                columns[entry] = it.col();
              }
        return true;
      }

      void
      finalize_solution(Ipopt::SolverReturn,
                        Index n,
                        const Number *x_end,
                        const Number *,
                        const Number *,
                        Index,
                        const Number *,
                        const Number *,
                        Number,
                        const Ipopt::IpoptData *,
                        Ipopt::IpoptCalculatedQuantities *) override
      {
        x = ConstVectorView(x_end, n);
      }

    private:
      const Eigen::SparseMatrix<double> &G_;
      const Eigen::SparseMatrix<double> lower_;
      const Eigen::VectorXd &g_;
      const std::vector<bool> &nonnegative_;
      const Eigen::VectorXd &start_;
    };
  } // namespace

  Eigen::VectorXd
  minimise_by_ipopt(const Eigen::SparseMatrix<double> &G,
                    const Eigen::VectorXd &g,
                    const std::vector<bool> &nonnegative,
                    const Eigen::VectorXd &start)
  {
    const auto application = make_ipopt_application();
    auto &options          = *application->Options();
    options.SetStringValue("mehrotra_algorithm", "yes");
    options.SetStringValue("hessian_constant", "yes");
    options.SetNumericValue("tol", 1e-10);
    options.SetIntegerValue("max_iter", 200);
    application->Initialize("");

    Ipopt::SmartPtr<QuadraticProgram> program =
      new QuadraticProgram(G, g, nonnegative, start);
    application->OptimizeTNLP(program);
    if (program->x.size() == 0 || !program->x.allFinite())
      throw RunError("Ipopt found no point of a least squares fit with k >= 0.",
                     "Fit without k >= 0, or improve the mesh.");
    return program->x;
  }
} // namespace springfit
