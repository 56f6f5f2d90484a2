#include <springfit/output/csv.h>
#include <springfit/output/tables.h>

namespace springfit
{
  void
  write_comparison(const std::filesystem::path &folder,
                   const std::vector<ComparisonRow> &rows)
  {
    CsvTable table("case,fit,enrichment,kinematics,e_rms_percent,e_max_percent,"
                   "E_out,nu_out,n_nodes,n_cells,n_springs,n_negative,"
                   "calibrate_s,fem_s,lem_s");
    for (const auto &row : rows)
      {
        std::optional<double> youngs_modulus, poissons_ratio;
        if (row.delivered)
          {
            youngs_modulus = row.delivered->youngs_modulus;
            poissons_ratio = row.delivered->poissons_ratio;
          }
        table.new_row();
        table << row.load_case << row.fit << row.enrichment << row.kinematics
              << row.errors.e_rms_percent << row.errors.e_max_percent
              << youngs_modulus << poissons_ratio << row.n_nodes << row.n_cells
              << row.n_springs << row.n_negative << row.calibrate_seconds
              << row.fem_seconds << row.lem_seconds;
      }
    table.write(folder / "comparison.csv");
  }

  void
  write_fits(const std::filesystem::path &folder,
             const std::vector<FitRow> &rows)
  {
    CsvTable table("fit,cell,multiplicity,frobenius_residual,spectral_residual,"
                   "duality_gap,n_negative,seconds,smallest_eigenvalue,"
                   "states_residual");
    for (const auto &row : rows)
      {
        table.new_row();
        table << row.fit << row.cell << row.multiplicity
              << row.frobenius_residual << row.spectral_residual
              << row.duality_gap << row.n_negative << row.seconds
              << row.smallest_eigenvalue << row.states_residual;
      }
    table.write(folder / "fit.csv");
  }

  void
  write_nodes(const std::filesystem::path &folder, const SpringNetwork &network)
  {
    CsvTable table("x,y,z,mass");
    for (Eigen::Index node = 0; node < network.nodes.cols(); ++node)
      {
        table.new_row();
        for (Eigen::Index d = 0; d < 3; ++d)
          table.exactly(d < network.nodes.rows() ? network.nodes(d, node) : 0.);
        table.exactly(network.mass[node]);
      }
    table.write(folder / "nodes.csv");
  }

  namespace
  {
    CsvTable
    springs_table(const SpringNetwork &network)
    {
      CsvTable table("i,j,k,rest_length");
      for (std::size_t s = 0; s < network.stiffness.size(); ++s)
        {
          table.new_row();
          table << network.i[s] << network.j[s];
          table.exactly(network.stiffness[s]).exactly(network.rest_length[s]);
        }
      return table;
    }

    CsvTable
    couplings_table(const SpringNetwork &network)
    {
      CsvTable table("a,b,stiffness");
      for (const auto &[a, b, stiffness] : network.couplings)
        {
          table.new_row();
          table << a << b;
          table.exactly(stiffness);
        }
      return table;
    }

    CsvTable
    angles_table(const SpringNetwork &network)
    {
      CsvTable table("a,middle,c,k,rest_angle");
      for (const auto &[nodes, stiffness, rest_angle] : network.angles)
        {
          table.new_row();
          for (const unsigned int node : nodes)
            table << node;
          table.exactly(stiffness).exactly(rest_angle);
        }
      return table;
    }

    /** The cells of a mesh are of one kind: all rows are of the same length. */
    CsvTable
    volumes_table(const SpringNetwork &network)
    {
      std::string header;
      for (std::size_t v = 0; v < network.volumes.front().nodes.size(); ++v)
        header += 'n' + std::to_string(v) + ',';
      CsvTable table(header + "k,rest_volume");
      for (const auto &[nodes, stiffness, rest_volume] : network.volumes)
        {
          table.new_row();
          for (const unsigned int node : nodes)
            table << node;
          table.exactly(stiffness).exactly(rest_volume);
        }
      return table;
    }
  } // namespace

  void
  write_network(const std::filesystem::path &folder,
                const std::string &name,
                const SpringNetwork &network)
  {
    springs_table(network).write(folder / ("springs_" + name + ".csv"));
    if (!network.couplings.empty())
      couplings_table(network).write(folder / ("couplings_" + name + ".csv"));
    if (!network.angles.empty())
      angles_table(network).write(folder / ("angles_" + name + ".csv"));
    if (!network.volumes.empty())
      volumes_table(network).write(folder / ("volumes_" + name + ".csv"));
  }
} // namespace springfit
