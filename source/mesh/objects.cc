#include <springfit/core/words.h>
#include <springfit/mesh/objects.h>

namespace springfit
{
  const std::vector<Object> &
  objects()
  {
    static const std::vector<Object> table = {
      {"box",
       "from the origin to Size; boundaries 0 'x min', 1 'x max', 2 'y min', "
       "3 'y max', 4 'z min', 5 'z max'; of triangles in 3-d a sheet in the "
       "plane z = 0 with two extents",
       {{2, {0.02, 0.02}}, {3, {0.02, 0.02, 0.02}}},
       &check_box,
       nullptr,
       &describe_box},
      {"cylinder",
       "in 3-d, its axis from the origin along x; boundaries 0 'x min', "
       "1 'x max', 2 'mantle'",
       {{3, {0.02, 0.02, 0.02}}},
       &check_cylinder,
       nullptr,
       &describe_cylinder},
      {"hollow cylinder",
       "the cylinder, of tetrahedra, with a spherical hole in its middle of "
       "0.6 times its radius; boundaries as of the cylinder, and 3 'hole'",
       {{3, {0.02, 0.02, 0.02}}},
       &check_hollow_cylinder,
       nullptr,
       &describe_hollow_cylinder},
      {"tissue",
       "in 2-d, from the origin to Size, within a smooth convex outline: with "
       "c = cos t, s = sin t, x and y are half the Size times "
       "1 + (c - 0.08 cos 3t) / 0.92 and 1 + s (1 + 0.2 c^2 + 0.25 c^3) - "
       "0.2 c^2; boundaries 0 'x min' and 1 'x max', the outline within a "
       "twentieth of the length from each end, 2 'side'",
       {{2, {0.06, 0.02}}},
       &check_tissue,
       nullptr,
       &describe_tissue},
      {"specimen",
       "the tensile specimen of Natsupakpong and Cavusoglu (2010), its axis "
       "from the origin along x: of its length of 16 B, 3 B are a grip, 4 B "
       "a transition, 2 B the straight part, where E_out and nu_out are "
       "measured, 4 B a transition, 3 B a grip; the straight part is a third "
       "as wide as the grips; the transition's contour, which was not "
       "published, is the smooth step 6 t^5 - 15 t^4 + 10 t^3 (C2); "
       "boundaries as of the box",
       {{2, {0.16, 0.03}}, {3, {0.16, 0.03, 0.01}}},
       &check_specimen,
       nullptr,
       &describe_specimen},
      {"cell",
       "one regular cell (equilateral triangle, square, regular tetrahedron, "
       "cube) with an edge from the origin along x; boundary 0",
       {{2, {0.02}}, {3, {0.02}}},
       &check_single_cell,
       nullptr,
       &describe_single_cell},
      {"ventricle floor",
       "in 3-d, of triangles: the membrane of Natsupakpong and Cavusoglu's "
       "(2010) simulation of neurosurgery, 558 nodes and 1050 triangles in a "
       "bowl z = - depth (1 - rho^2) over an ellipse about the origin, with "
       "rho = 1 on the rim, boundary 0 'rim'; its Size is its extents along x "
       "and y and its depth",
       {{2, {0.02, 0.014, 0.003}}},
       &check_ventricle_floor,
       nullptr,
       &describe_ventricle_floor},
      {"file",
       "the mesh or the geometry in File; its physical groups are its "
       "boundaries and materials",
       {},
       &check_file,
       &check_file_is_readable,
       &describe_file}};
    return table;
  }


  const Object &
  find_object(const std::string &name)
  {
    WordTable<const Object *> table;
    for (const Object &object : objects())
      table.emplace_back(&object, object.name);
    return *value_of(table, name, "Geometry/Object");
  }
} // namespace springfit
