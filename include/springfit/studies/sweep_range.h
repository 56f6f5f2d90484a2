#ifndef springfit_studies_sweep_range_h
#define springfit_studies_sweep_range_h

#include <springfit/reference/material.h>

#include <deal.II/base/parameter_acceptor.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace springfit
{
  /** The section "Sweep": the materials that a sweep tries. */
  template <int dim>
  class SweepRange : public dealii::ParameterAcceptor
  {
  public:
    SweepRange();

    /**
     * Check all values; only a sweep asks for them.
     *
     * @throws EntryError when a range is empty or @p material, by its plane
     * state, allows no such ratio.
     */
    void
    check(const Material<dim> &material) const;

    /** In Pa, in the order of the table. */
    std::vector<double>
    youngs_moduli() const;

    std::vector<double>
    poissons_ratios() const;

    /** Along which the cell is pulled, of length one. */
    Eigen::VectorXd
    axis() const;

  private:
    std::string youngs_moduli_text_ = "1 to 10000 in 5";
    std::string poissons_ratios_text_ =
      dim == 2 ? "0 to 0.5 in 11" : "0 to 0.45 in 10";
    std::vector<double> axis_;
  };
} // namespace springfit

#endif
