#ifndef springfit_fit_cell_model_h
#define springfit_fit_cell_model_h

#include <springfit/springs/network.h>

#include <Eigen/Core>

namespace springfit
{
  /**
   * The lumped forces of one cell: what a fit makes. Nodes are the cell's
   * vertices, from 0 on.
   */
  struct CellModel
  {
    Families families;

    /** One stiffness per spring between two vertices, N/m */
    Eigen::VectorXd
    k() const;
  };

  /**
   * (1 - t) a + t b: what both have is added up by stiffness.
   *
   * @throws std::logic_error for springs without a stiffness, whose first
   * column is something else.
   */
  CellModel
  between(const CellModel &a, const CellModel &b, double t);
} // namespace springfit

#endif
