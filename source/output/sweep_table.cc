#include <springfit/output/csv.h>
#include <springfit/output/sweep_table.h>

namespace springfit
{
  void
  write_sweep(const std::filesystem::path &folder,
              const std::vector<SweepRow> &rows)
  {
    CsvTable table("fit,enrichment,E_in,nu_in,E_out,nu_out,E_homogenised,"
                   "nu_homogenised,n_negative");
    for (const auto &row : rows)
      {
        std::optional<double> youngs_modulus, poissons_ratio;
        if (row.out)
          {
            youngs_modulus = row.out->youngs_modulus;
            poissons_ratio = row.out->poissons_ratio;
          }
        table.new_row();
        table << row.fit << row.enrichment << row.in.youngs_modulus
              << row.in.poissons_ratio << youngs_modulus << poissons_ratio
              << row.homogenised.youngs_modulus
              << row.homogenised.poissons_ratio << row.n_negative;
      }
    table.write(folder / "sweep.csv");
  }
} // namespace springfit
