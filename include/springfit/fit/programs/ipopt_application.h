#ifndef springfit_fit_programs_ipopt_application_h
#define springfit_fit_programs_ipopt_application_h

#include <IpIpoptApplication.hpp>

namespace springfit
{
  /**
   * Ipopt without console and without an options file from the working
   * directory, with Debian's sequential MUMPS. Only files fit/ipopt_* include
   * this one.
   */
  inline Ipopt::SmartPtr<Ipopt::IpoptApplication>
  make_ipopt_application()
  {
    Ipopt::SmartPtr<Ipopt::IpoptApplication> application =
      new Ipopt::IpoptApplication(false);
    auto &options = *application->Options();
    options.SetStringValue("sb", "yes");
    options.SetStringValue("linear_solver", "mumps");
    options.SetStringValue("nlp_scaling_method", "none");
    // Bounds are meant as they are given: some functions have no value
    // beyond.
    options.SetNumericValue("bound_relax_factor", 0.);
    // No early end at an "acceptable" point.
    options.SetIntegerValue("acceptable_iter", 0);
    return application;
  }
} // namespace springfit

#endif
