#ifndef springfit_output_sweep_table_h
#define springfit_output_sweep_table_h

#include <springfit/comparison/homogenised_tensor.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** A row of sweep.csv: one cell, one material, one model of it. */
  struct SweepRow
  {
    std::string fit; // "fem" is the reference itself
    std::string enrichment;
    YoungPoisson in;
    std::optional<YoungPoisson> out; // of a tensile test
    YoungPoisson homogenised;        // under affine deformation
    unsigned int n_negative;
  };

  /** sweep.csv; moduli in Pa. */
  void
  write_sweep(const std::filesystem::path &folder,
              const std::vector<SweepRow> &rows);
} // namespace springfit

#endif
