#ifndef springfit_output_tables_h
#define springfit_output_tables_h

#include <springfit/comparison/errors.h>
#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/springs/network.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** A row of comparison.csv; times in s. */
  struct ComparisonRow
  {
    std::string load_case;
    std::string fit; // "fem" is the reference itself
    std::string enrichment;
    std::string kinematics;
    ErrorNorms errors;
    std::optional<YoungPoisson> delivered; // of the tension case
    unsigned int n_nodes;
    unsigned int n_cells;
    unsigned int n_springs;
    unsigned int n_negative;
    std::optional<double> calibrate_seconds;
    double fem_seconds;
    std::optional<double> lem_seconds;
  };

  /** A row of fit.csv: a fit on one distinct cell; residuals relative to R. */
  struct FitRow
  {
    std::string fit;
    std::string cell; // "hexahedron 17": the first of its kind
    unsigned int multiplicity;
    double frobenius_residual;
    double spectral_residual;
    std::optional<double> duality_gap;
    unsigned int n_negative;
    double seconds;

    /** Of the cell's forces at rest on its deformations, relative to R's. */
    std::optional<double> smallest_eigenvalue;

    /** Of a fit over several states: of all of them. */
    std::optional<double> states_residual;
  };

  /** comparison.csv */
  void
  write_comparison(const std::filesystem::path &folder,
                   const std::vector<ComparisonRow> &rows);

  /** fit.csv */
  void
  write_fits(const std::filesystem::path &folder,
             const std::vector<FitRow> &rows);

  /** nodes.csv: rest positions in m (z = 0 in 2-d) and masses in kg. */
  void
  write_nodes(const std::filesystem::path &folder,
              const SpringNetwork &network);

  /**
   * The constants of a network called @p name:
   *
   * springs_<name>.csv `i,j,k,rest_length`: node numbers from 0, N/m, m;
   *
   * couplings_<name>.csv `a,b,stiffness`, if it has any: rows of the springs'
   * table from 0, N/m;
   *
   * angles_<name>.csv `a,middle,c,k,rest_angle`, if it has any: node numbers,
   * N m (per rad^2), rad;
   *
   * volumes_<name>.csv `n0,n1,...,k,rest_volume`, if it has any: the nodes of
   * each cell in deal.II's numbering, N/m^5 (2-d N/m^3), m^3 (2-d m^2).
   */
  void
  write_network(const std::filesystem::path &folder,
                const std::string &name,
                const SpringNetwork &network);
} // namespace springfit

#endif
