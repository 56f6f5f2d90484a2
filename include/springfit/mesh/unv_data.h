#ifndef springfit_mesh_unv_data_h
#define springfit_mesh_unv_data_h

#include <springfit/mesh/mesh_description.h>
#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace springfit
{
  /** A node or an element. */
  struct UnvMember
  {
    bool is_node;
    std::size_t number;
  };

  /** A named set of nodes and elements. */
  struct UnvGroup
  {
    std::string name;
    unsigned int number;
    std::vector<UnvMember> members;
  };

  /** An element with a shape. */
  struct UnvElement
  {
    std::size_t number, type;
    int dim; // of its shape, 1 to 3
    long property, material;
    std::vector<std::size_t> nodes;
    TextPlace place;
  };

  struct UnvNode
  {
    std::size_t number;
    MeshPoint point; // in the file's units
    TextPlace place;
  };

  /** What an I-deas universal file holds, in its order. */
  struct UnvData
  {
    std::vector<UnvNode> nodes;
    std::vector<UnvElement> elements;
    std::vector<UnvGroup> groups;

    /** How many springs, masses, links and gaps there are, by their type. */
    std::map<std::size_t, std::size_t> n_shapeless;

    /** The length of the file's unit in m, if the file states one. */
    std::optional<double> unit;

    /** The numbers of data sets that are passed over. */
    std::set<std::string> ignored;
  };

  /**
   * Read the data sets of nodes (2411, 781 and 15), elements (2412 and 780),
   * groups (2417, 2429, 2430, 2432, 2435, 2452, 2467 and 2477) and units (164);
   * others are passed over.
   *
   * @throws InputError with the line of what cannot be understood, of nodes in
   * other coordinate systems (2420) than the basic one, and when the file ends
   * within a data set.
   */
  UnvData
  read_unv_data(const std::filesystem::path &file);
} // namespace springfit

#endif
