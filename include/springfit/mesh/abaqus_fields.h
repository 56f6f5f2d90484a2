#ifndef springfit_mesh_abaqus_fields_h
#define springfit_mesh_abaqus_fields_h

#include <springfit/mesh/abaqus_model.h>
#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace springfit
{
  /** The fields of a line of data, without empty ones at its end. */
  std::vector<std::string>
  abaqus_fields(const TextLine &line);

  /** @throws InputError when the field is there but no label. */
  std::size_t
  label_or(const std::vector<std::string> &fields,
           std::size_t i,
           std::size_t absent,
           const TextPlace &place);

  /** @throws InputError when the field is not there or no label. */
  std::size_t
  needed_label(const std::vector<std::string> &fields,
               std::size_t i,
               const TextPlace &place);

  /** Empty fields are 0. @throws InputError of read_real. */
  std::vector<double>
  reals_of(const TextLine &line);

  /** Consecutive labels make one range. */
  void
  add_label(AbaqusSet &set, std::size_t label);

  /** The set of that name, in any case; a new one if there is none. */
  AbaqusSet &
  set_in(std::map<std::string, AbaqusSet> &sets, const std::string &name);
} // namespace springfit

#endif
