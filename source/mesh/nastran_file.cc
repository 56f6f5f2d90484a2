#include <springfit/mesh/mesh_text.h>
#include <springfit/mesh/nastran_cards.h>
#include <springfit/mesh/nastran_file.h>
#include <springfit/mesh/numbered_elements.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace springfit
{
  namespace
  {
    struct ElementType
    {
      FileElements shape;
      unsigned int n_nodes_of_second_order;
    };

    const std::map<std::string, ElementType> &
    element_types()
    {
      const auto type = [](const std::string &name,
                           const int dim,
                           const unsigned int n_nodes,
                           const std::optional<CellKind> kind,
                           const unsigned int n_nodes_of_second_order) {
        return std::make_pair(
          name,
          ElementType{{name, dim, n_nodes, kind, {}, {}, {}},
                      n_nodes_of_second_order});
      };
      static const std::map<std::string, ElementType> types = {
        type("CTRIA3", 2, 3, CellKind::triangle, 3),
        type("CTRIAR", 2, 3, CellKind::triangle, 3),
        type("CTRIA6", 2, 6, {}, 6),
        type("CQUAD4", 2, 4, CellKind::quadrilateral, 4),
        type("CQUADR", 2, 4, CellKind::quadrilateral, 4),
        type("CSHEAR", 2, 4, CellKind::quadrilateral, 4),
        type("CQUAD8", 2, 8, {}, 8),
        type("CTETRA", 3, 4, CellKind::tetrahedron, 10),
        type("CPYRAM", 3, 5, {}, 13),
        type("CPYRA", 3, 5, {}, 13),
        type("CPENTA", 3, 6, {}, 15),
        type("CHEXA", 3, 8, CellKind::hexahedron, 20)};
      return types;
    }

    // Elements of no area and no volume, what draws lines, and what conducts
    // heat on the sides of others.
    bool
    is_shapeless(const std::string &name)
    {
      static const std::set<std::string> names = {
        "CBAR",   "CBARAO", "CBEAM",  "CBEAM3", "CBEND",   "CBUSH",  "CBUSH1D",
        "CDAMP1", "CDAMP2", "CDAMP3", "CDAMP4", "CDAMP5",  "CELAS1", "CELAS2",
        "CELAS3", "CELAS4", "CFAST",  "CGAP",   "CBUSH2D", "CHBDYE", "CHBDYG",
        "CHBDYP", "CINTC",  "CMASS1", "CMASS2", "CMASS3",  "CMASS4", "CONM1",
        "CONM2",  "CONROD", "CROD",   "CSEAM",  "CTUBE",   "CVISC",  "CWELD",
        "GENEL",  "PLOTEL", "RBAR",   "RBE1",   "RBE2",    "RBE3",   "RJOINT",
        "RROD",   "RSPLINE"};
      return names.count(name) > 0;
    }

    // Names of elements begin with a C, as these do.
    bool
    is_element(const std::string &name)
    {
      static const std::set<std::string> others = {
        "CAERO1",  "CAERO2",  "CAERO3", "CAERO4", "CAERO5",  "CAERO7", "CLOAD",
        "CMETHOD", "CONTRLT", "CONV",   "CONVM",  "CORD1C",  "CORD1R", "CORD1S",
        "CORD2C",  "CORD2R",  "CORD2S", "CORD3G", "CORD3R",  "CREEP",  "CSCHD",
        "CSET",    "CSET1",   "CSSCHD", "CSUPER", "CSUPEXT", "CYAX",   "CYJOIN",
        "CYSUP",   "CYSYM",   "CNGRNT", "CSPOT",  "CAMPBLL"};
      return name[0] == 'C' && others.count(name) == 0;
    }

    bool
    is_include(const std::string &name)
    {
      return name == "INCLUDE" || name.rfind("INCLUDE ", 0) == 0 ||
             name.rfind("INCLUDE'", 0) == 0;
    }

    class Reader
    {
    public:
      void
      read(const NastranBulk &bulk)
      {
        for (const NastranCard &card : bulk.cards)
          {
            if (is_include(card.name))
              throw text_error(card.place,
                               "springfit does not follow INCLUDE",
                               "Put the file in its place.");
            if (card.name[0] == '=')
              throw text_error(card.place,
                               "springfit does not repeat cards ('=')",
                               "Write each card out.");
            if (card.name == "GRDSET")
              default_system_ = card.field(1);
          }
        for (const NastranCard &card : bulk.cards)
          if (card.name == "GRID")
            add_node(card);
          else if (const auto type = element_types().find(card.name);
                   type != element_types().end())
            add_element(card, type->second);
          else if (is_shapeless(card.name))
            ++n_shapeless[card.name];
          else if (is_element(card.name))
            throw text_error(card.place,
                             "the element type '" + card.name +
                               "' is not known",
                             "Cells may be CTRIA3, CTRIAR, CQUAD4, CQUADR, "
                             "CSHEAR, CTETRA or CHEXA; remove what is no part "
                             "of the mesh.");
          else if (card.name != "GRDSET")
            ignored.insert(card.name);
      }

      NumberedElements numbered;
      std::map<std::string, std::size_t> n_shapeless;
      std::set<std::string> ignored;

    private:
      void
      add_node(const NastranCard &card)
      {
        const std::string system =
          card.field(1).empty() ? default_system_ : card.field(1);
        if (!system.empty() && system != "0")
          throw text_error(card.place,
                           "the node " + card.field(0) +
                             " is given in the coordinate system " + system +
                             ", which springfit does not know",
                           "Write all nodes in the basic system (0), or "
                           "convert the mesh to .msh.");
        MeshPoint point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = read_nastran_real(card.field(2 + d), card.place);
        numbered.add_node(read_label(card.field(0), card.place),
                          point,
                          card.place);
      }

      void
      add_element(const NastranCard &card, const ElementType &type)
      {
        const auto number       = read_label(card.field(0), card.place);
        const std::string which = "element " + card.field(0);
        std::vector<std::size_t> nodes;
        while (nodes.size() < type.n_nodes_of_second_order &&
               !card.field(nodes.size() + 2).empty())
          nodes.push_back(read_label(card.field(nodes.size() + 2), card.place));
        FileElements shape = type.shape;
        if (nodes.size() < shape.n_nodes)
          throw text_error(card.place,
                           which + ", a " + card.name + ", has " +
                             std::to_string(nodes.size()) +
                             " nodes instead of " +
                             std::to_string(shape.n_nodes),
                           "The file may be cut short: write it anew.");
        if (nodes.size() > shape.n_nodes)
          {
            shape.n_nodes = nodes.size();
            shape.type += " with " + std::to_string(nodes.size()) + " nodes";
            shape.cell_kind.reset();
          }
        numbered.add_element(shape, number, property(card), nodes, card.place);
      }

      static unsigned int
      property(const NastranCard &card)
      {
        const std::string text = card.field(1);
        if (text.empty() || text == "0")
          return 0;
        return checked_id(read_label(text, card.place),
                          "the property",
                          card.place);
      }

      std::string default_system_;
    };
  } // namespace


  MeshDescription
  read_nastran_file(const std::filesystem::path &file,
                    const std::string &name,
                    const int dim)
  {
    const NastranBulk bulk = read_nastran_bulk(file);
    Reader reader;
    reader.read(bulk);
    reader.numbered.make_mesh(name, dim);
    reader.numbered.label_sides_by_ids();
    MeshDescription &mesh = reader.numbered.mesh();
    if (!bulk.has_end)
      mesh.warnings.push_back(name + " has no ENDDATA: it may be cut short.");
    std::vector<std::string> counts;
    for (const auto &[type, n] : reader.n_shapeless)
      counts.push_back(std::to_string(n) + ' ' + type);
    if (!counts.empty())
      mesh.warnings.push_back(
        name + ": elements without area and volume are left out: " +
        join_some(counts) + '.');
    if (!reader.ignored.empty())
      mesh.warnings.push_back(
        name + ": of no meaning to springfit and passed over: " +
        join_some({reader.ignored.begin(), reader.ignored.end()}) + '.');
    return std::move(mesh);
  }
} // namespace springfit
