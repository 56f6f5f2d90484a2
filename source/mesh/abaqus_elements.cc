#include <springfit/mesh/abaqus_elements.h>
#include <springfit/mesh/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace springfit
{
  namespace
  {
    using Type = AbaqusElementType;

    const Type line{1, 2, {}, {{0}, {1}}};
    const Type curved_line{1, 3, {}, {}};
    const Type triangle{2, 3, CellKind::triangle, {{0, 1}, {1, 2}, {2, 0}}};
    const Type quadrilateral{2,
                             4,
                             CellKind::quadrilateral,
                             {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
    const Type triangle_6{2, 6, {}, {}};
    const Type quadrilateral_8{2, 8, {}, {}};
    const Type quadrilateral_9{2, 9, {}, {}};
    const Type tetrahedron{3,
                           4,
                           CellKind::tetrahedron,
                           {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    const Type hexahedron{3,
                          8,
                          CellKind::hexahedron,
                          {{0, 1, 2, 3},
                           {4, 7, 6, 5},
                           {0, 4, 5, 1},
                           {1, 5, 6, 2},
                           {2, 6, 7, 3},
                           {3, 7, 4, 0}}};
    const Type pyramid{3, 5, {}, {}};
    const Type wedge{3, 6, {}, {}};
    const Type tetrahedron_10{3, 10, {}, {}};
    const Type wedge_15{3, 15, {}, {}};
    const Type hexahedron_20{3, 20, {}, {}};
    const Type hexahedron_27{3, 27, {}, {}};

    const std::map<std::string, const Type *> &
    types()
    {
      static const std::map<std::string, const Type *> known = {
        {"T2D2", &line},
        {"T3D2", &line},
        {"B21", &line},
        {"B23", &line},
        {"B31", &line},
        {"B33", &line},
        {"PIPE21", &line},
        {"PIPE31", &line},
        {"R2D2", &line},
        {"RB2D2", &line},
        {"RB3D2", &line},
        {"SAX1", &line},
        {"T2D3", &curved_line},
        {"T3D3", &curved_line},
        {"B22", &curved_line},
        {"B32", &curved_line},
        {"CPS3", &triangle},
        {"CPE3", &triangle},
        {"S3", &triangle},
        {"STRI3", &triangle},
        {"M3D3", &triangle},
        {"R3D3", &triangle},
        {"SFM3D3", &triangle},
        {"DS3", &triangle},
        {"DC2D3", &triangle},
        {"CPS4", &quadrilateral},
        {"CPE4", &quadrilateral},
        {"S4", &quadrilateral},
        {"S4R5", &quadrilateral},
        {"M3D4", &quadrilateral},
        {"R3D4", &quadrilateral},
        {"SFM3D4", &quadrilateral},
        {"DS4", &quadrilateral},
        {"DC2D4", &quadrilateral},
        {"CPS6", &triangle_6},
        {"CPE6", &triangle_6},
        {"S6", &triangle_6},
        {"M3D6", &triangle_6},
        {"STRI65", &triangle_6},
        {"SFM3D6", &triangle_6},
        {"CPS8", &quadrilateral_8},
        {"CPE8", &quadrilateral_8},
        {"S8", &quadrilateral_8},
        {"S8R5", &quadrilateral_8},
        {"M3D8", &quadrilateral_8},
        {"SFM3D8", &quadrilateral_8},
        {"S9R5", &quadrilateral_9},
        {"M3D9", &quadrilateral_9},
        {"C3D4", &tetrahedron},
        {"DC3D4", &tetrahedron},
        {"AC3D4", &tetrahedron},
        {"F3D4", &tetrahedron},
        {"C3D5", &pyramid},
        {"C3D6", &wedge},
        {"DC3D6", &wedge},
        {"C3D8", &hexahedron},
        {"DC3D8", &hexahedron},
        {"AC3D8", &hexahedron},
        {"F3D8", &hexahedron},
        {"C3D10", &tetrahedron_10},
        {"DC3D10", &tetrahedron_10},
        {"C3D15", &wedge_15},
        {"DC3D15", &wedge_15},
        {"C3D20", &hexahedron_20},
        {"DC3D20", &hexahedron_20},
        {"C3D27", &hexahedron_27}};
      return known;
    }
  } // namespace


  const AbaqusElementType *
  find_abaqus_element_type(const std::string &name)
  {
    std::string base = in_capitals(name);
    while (!base.empty() && types().count(base) == 0 &&
           std::isalpha(static_cast<unsigned char>(base.back())))
      base.pop_back();
    const auto type = types().find(base);
    return type == types().end() ? nullptr : type->second;
  }


  bool
  is_shapeless_abaqus_element(const std::string &name)
  {
    static const std::vector<std::string> beginnings = {"SPRING",
                                                        "MASS",
                                                        "ROTARYI",
                                                        "HEATCAP",
                                                        "DASHPOT",
                                                        "GAP",
                                                        "CONN",
                                                        "JOINT",
                                                        "ITS",
                                                        "COMBIN",
                                                        "DCOUP",
                                                        "DGAP",
                                                        "PSI",
                                                        "DRAG",
                                                        "TUBE",
                                                        "INTER",
                                                        "GK"};
    const std::string capitals                       = in_capitals(name);
    return std::any_of(beginnings.begin(),
                       beginnings.end(),
                       [&](const std::string &beginning) {
                         return capitals.rfind(beginning, 0) == 0;
                       });
  }
} // namespace springfit
