#ifndef springfit_output_tables_h
#define springfit_output_tables_h

#include <springfit/comparison/errors.h>
#include <springfit/comparison/homogenised_tensor.h>
#include <springfit/mesh/node_sets.h>
#include <springfit/response/load_case.h>
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
    std::optional<ErrorNorms> errors_where_loaded; // if nodes are loaded

    /** Whether the fit was made with the response to this load. */
    bool is_trained;
    std::optional<YoungPoisson> delivered; // of the tension case
    std::vector<ForceOfSupport> reactions;
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

  /** reactions.csv: a row per support of each row of comparison.csv. */
  void
  write_reactions(const std::filesystem::path &folder,
                  const std::vector<ComparisonRow> &rows);

  /** fit.csv */
  void
  write_fits(const std::filesystem::path &folder,
             const std::vector<FitRow> &rows);

  /**
   * nodes.csv: rest positions in m (z = 0 in 2-d), masses in kg, whether each
   * component is held (0 or 1), the number of the connected part, and the ids
   * of materials and boundaries, between blanks.
   *
   * @param held a flag per unknown, see Loading
   */
  void
  write_nodes(const std::filesystem::path &folder,
              const SpringNetwork &network,
              const std::vector<bool> &held,
              const NodeSets &sets);

  /** A name of a mesh. */
  struct SetRow
  {
    std::string kind; // "boundary", "material"
    unsigned int id;
    std::string name;       // between commas if it has several, empty if none
    unsigned int n_members; // faces, cells
  };

  /** sets.csv: what the ids of nodes.csv are called. */
  void
  write_sets(const std::filesystem::path &folder,
             const std::vector<SetRow> &rows);

  /** A network and what files call it. */
  struct NamedNetwork
  {
    std::string name;
    const SpringNetwork *network;
  };

  /**
   * families.csv: the law of each family of each network, the file that has
   * its members, and the unit of each of its columns.
   */
  void
  write_families(const std::filesystem::path &folder,
                 const std::vector<NamedNetwork> &networks);

  /**
   * The families of a network called @p name, each in <word>_<name>.csv with
   * the word of its kind: the nodes of a member from 0 on, then its columns,
   * which are as many as they are wide. Headers of the kinds describe them.
   */
  void
  write_network(const std::filesystem::path &folder,
                const std::string &name,
                const SpringNetwork &network);
} // namespace springfit

#endif
