#ifndef springfit_mesh_abaqus_model_h
#define springfit_mesh_abaqus_model_h

#include <springfit/mesh/abaqus_elements.h>
#include <springfit/mesh/abaqus_syntax.h>
#include <springfit/mesh/mesh_description.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace springfit
{
  struct AbaqusElement
  {
    std::size_t label;
    const AbaqusElementType *type;
    std::string type_name;
    std::vector<std::size_t> nodes; // labels
    std::size_t block;              // number of the *ELEMENT that it comes from
    std::string set;                // that *ELEMENT's, in capitals; may be ""
    TextPlace place;
  };

  /** A set of nodes or elements as the file defines it. */
  struct AbaqusSet
  {
    struct Range
    {
      std::size_t first, last, step;
    };

    struct Reference
    {
      std::string name;
      TextPlace place;
    };

    std::string name;
    bool is_internal = false; // made by Abaqus/CAE, not by the user
    std::vector<Range> ranges;
    std::vector<Reference> sets;         // of the same kind
    std::vector<Reference> element_sets; // whose nodes belong to a set of nodes
  };

  /** A *SOLID SECTION or the like. */
  struct AbaqusSection
  {
    std::string set;
    std::string material; // may be ""
    TextPlace place;
  };

  struct AbaqusSurface
  {
    struct Item
    {
      std::string what; // the name of a set, or a label
      std::string side; // "S1", ..., or "" for all sides on the boundary
      TextPlace place;
    };

    std::string name;
    bool is_internal;
    bool is_of_nodes; // else of sides of elements
    std::vector<Item> items;
  };

  /**
   * What numbers its nodes and elements by itself: an instance of a part, or
   * all that stands outside of parts. Sets are found by their names in
   * capitals.
   */
  struct AbaqusInstance
  {
    std::string name;
    std::map<std::size_t, MeshPoint> nodes; // by label
    std::vector<AbaqusElement> elements;
    std::map<std::size_t, std::size_t> index_of_element; // by label
    std::set<std::size_t> shapeless; // labels of springs, masses, ...
    std::map<std::string, AbaqusSet> node_sets, element_sets;
    std::vector<AbaqusSection> sections;
    std::vector<AbaqusSurface> surfaces;
  };

  struct AbaqusModel
  {
    /** The first holds what stands outside of parts. */
    std::vector<AbaqusInstance> instances;

    std::vector<std::string> warnings;
  };

  /**
   * Make nodes, elements and sets of the keywords of a file: *NODE, *NGEN,
   * *SYSTEM, *ELEMENT, *ELGEN, *NSET, *ELSET, *SURFACE, sections, *PART and
   * *INSTANCE with its translation and rotation. All other keywords are listed
   * in one warning. Elements without a shape are counted in another.
   *
   * @throws InputError with the line of what cannot be understood, is defined
   * twice, is cut short, or makes or moves nodes in a way that is not known.
   */
  AbaqusModel
  make_abaqus_model(const std::vector<AbaqusBlock> &blocks);
} // namespace springfit

#endif
