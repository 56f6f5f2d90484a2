#include <springfit/mesh/gmsh_element_types.h>

namespace springfit
{
  const std::map<std::size_t, GmshElementType> &
  gmsh_element_types()
  {
    static const std::map<std::size_t, GmshElementType> types = {
      {1, {1, 2}},   {2, {2, 3}},   {3, {2, 4}},   {4, {3, 4}},   {5, {3, 8}},
      {6, {3, 6}},   {7, {3, 5}},   {8, {1, 3}},   {9, {2, 6}},   {10, {2, 9}},
      {11, {3, 10}}, {12, {3, 27}}, {13, {3, 18}}, {14, {3, 14}}, {15, {0, 1}},
      {16, {2, 8}},  {17, {3, 20}}, {18, {3, 15}}, {19, {3, 13}}, {20, {2, 9}},
      {21, {2, 10}}, {22, {2, 12}}, {23, {2, 15}}, {24, {2, 15}}, {25, {2, 21}},
      {26, {1, 4}},  {27, {1, 5}},  {28, {1, 6}},  {29, {3, 20}}, {30, {3, 35}},
      {31, {3, 56}}};
    return types;
  }


  const GmshElementType *
  find_gmsh_element_type(const long number,
                         const std::string &what,
                         const TextPlace &place)
  {
    constexpr long largest = 140;
    if (number < 1 || number > largest)
      throw text_error(place,
                       what + " has the type " + std::to_string(number) +
                         ", which is none",
                       "A count before it may be wrong: write the file anew.");
    const auto type = gmsh_element_types().find(number);
    return type == gmsh_element_types().end() ? nullptr : &type->second;
  }
} // namespace springfit
