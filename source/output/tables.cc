#include <springfit/output/csv.h>
#include <springfit/output/tables.h>
#include <springfit/springs/by_table.h>

#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>

namespace springfit
{
  namespace
  {
    /** A name that may hold commas and quotes, as tables have it. */
    std::string
    quoted(const std::string &name)
    {
      if (name.find_first_of(",\"") == std::string::npos)
        return name;
      std::string result = "\"";
      for (const char c : name)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
      return result + '"';
    }
  } // namespace

  void
  write_comparison(const std::filesystem::path &folder,
                   const std::vector<ComparisonRow> &rows)
  {
    CsvTable table("case,fit,enrichment,kinematics,e_rms_percent,e_max_percent,"
                   "E_out,nu_out,n_nodes,n_cells,n_springs,n_negative,"
                   "calibrate_s,fem_s,lem_s,e_rms_loaded_percent,"
                   "e_max_loaded_percent,trained");
    for (const auto &row : rows)
      {
        std::optional<double> youngs_modulus, poissons_ratio;
        if (row.delivered)
          {
            youngs_modulus = row.delivered->youngs_modulus;
            poissons_ratio = row.delivered->poissons_ratio;
          }
        std::optional<double> e_rms_loaded, e_max_loaded;
        if (row.errors_where_loaded)
          {
            e_rms_loaded = row.errors_where_loaded->e_rms_percent;
            e_max_loaded = row.errors_where_loaded->e_max_percent;
          }
        table.new_row();
        table << row.load_case << row.fit << row.enrichment << row.kinematics
              << row.errors.e_rms_percent << row.errors.e_max_percent
              << youngs_modulus << poissons_ratio << row.n_nodes << row.n_cells
              << row.n_springs << row.n_negative << row.calibrate_seconds
              << row.fem_seconds << row.lem_seconds << e_rms_loaded
              << e_max_loaded << (row.is_trained ? "yes" : "no");
      }
    table.write(folder / "comparison.csv");
  }

  void
  write_reactions(const std::filesystem::path &folder,
                  const std::vector<ComparisonRow> &rows)
  {
    CsvTable table(
      "case,fit,enrichment,kinematics,support,force_x,force_y,force_z");
    for (const auto &row : rows)
      for (const auto &[support, force] : row.reactions)
        {
          table.new_row();
          table << row.load_case << row.fit << row.enrichment << row.kinematics
                << quoted(support);
          for (Eigen::Index d = 0; d < 3; ++d)
            table << (d < force.size() ? force[d] : 0.);
        }
    table.write(folder / "reactions.csv");
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

  namespace
  {
    std::string
    between_blanks(const std::set<unsigned int> &ids)
    {
      std::string text;
      for (const unsigned int id : ids)
        text += (text.empty() ? "" : " ") + std::to_string(id);
      return text;
    }
  } // namespace

  void
  write_nodes(const std::filesystem::path &folder,
              const SpringNetwork &network,
              const std::vector<bool> &held,
              const NodeSets &sets)
  {
    CsvTable table("x,y,z,mass,held_x,held_y,held_z,part,materials,boundaries");
    const Eigen::Index dim = network.nodes.rows();
    for (Eigen::Index node = 0; node < network.nodes.cols(); ++node)
      {
        table.new_row();
        for (Eigen::Index d = 0; d < 3; ++d)
          table.exactly(d < dim ? network.nodes(d, node) : 0.);
        table.exactly(network.mass[node]);
        for (Eigen::Index d = 0; d < 3; ++d)
          table << (d < dim && held[dim * node + d] ? 1u : 0u);
        table << sets.parts[node] << between_blanks(sets.materials[node])
              << between_blanks(sets.boundaries[node]);
      }
    table.write(folder / "nodes.csv");
  }

  void
  write_sets(const std::filesystem::path &folder,
             const std::vector<SetRow> &rows)
  {
    CsvTable table("kind,id,name,n_members");
    for (const auto &row : rows)
      {
        table.new_row();
        table << row.kind << row.id << quoted(row.name) << row.n_members;
      }
    table.write(folder / "sets.csv");
  }

  namespace
  {
    /** A column for each node and number of a member. */
    std::string
    header(const SpringKind &kind)
    {
      std::string names;
      for (const auto &name : kind.node_names())
        names += name + ',';
      for (const auto &column : kind.columns())
        for (unsigned int w = 0; w < column.width; ++w)
          names += column.name +
                   (column.width > 1 ? std::to_string(w) : std::string()) + ',';
      names.pop_back();
      return names;
    }

    std::string
    file_of(const Family &family, const std::string &network)
    {
      return family.kind->word() + '_' + network + ".csv";
    }

    std::string
    word_of_role(const Column::Role role)
    {
      switch (role)
        {
          case Column::Role::stiffness:
            return "stiffness";
          case Column::Role::rest_value:
            return "rest value";
          case Column::Role::parameter:
            return "parameter";
        }
      throw std::logic_error("a role without a word");
    }

    CsvTable
    table_of(const Family &family)
    {
      CsvTable table(header(*family.kind));
      for (std::size_t m = 0; m < family.size(); ++m)
        {
          table.new_row();
          for (unsigned int a = 0; a < family.kind->n_nodes(); ++a)
            table << family.nodes(m)[a];
          for (const auto &column : family.numbers(m))
            for (const double number : column)
              table.exactly(number);
        }
      return table;
    }
  } // namespace

  void
  write_network(const std::filesystem::path &folder,
                const std::string &name,
                const SpringNetwork &network)
  {
    for (const auto &family : by_table(network.families))
      table_of(family).write(folder / file_of(family, name));
  }

  void
  write_families(const std::filesystem::path &folder,
                 const std::vector<NamedNetwork> &networks)
  {
    CsvTable table("fit,file,family,law,n_members,n_nodes_of_member,column,"
                   "meaning,unit,numbers_of_member");
    for (const auto &[name, network] : networks)
      for (const auto &family : by_table(network->families))
        for (const auto &column : family.kind->columns())
          {
            table.new_row();
            table << name << file_of(family, name) << family.kind->word()
                  << family.kind->law()
                  << static_cast<unsigned int>(family.size())
                  << family.kind->n_nodes() << column.name
                  << word_of_role(column.role) << column.unit << column.width;
          }
    table.write(folder / "families.csv");
  }
} // namespace springfit
