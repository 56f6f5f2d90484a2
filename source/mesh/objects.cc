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
       "3 'y max', 4 'z min', 5 'z max'",
       &check_box,
       nullptr,
       &describe_box},
      {"cylinder",
       "in 3-d, its axis from the origin along x; boundaries 0 'x min', "
       "1 'x max', 2 'mantle'",
       &check_cylinder,
       nullptr,
       &describe_cylinder},
      {"file",
       "the mesh or the geometry in File; its physical groups are its "
       "boundaries and materials",
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
