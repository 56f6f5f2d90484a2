#ifndef springfit_mesh_known_numbers_h
#define springfit_mesh_known_numbers_h

#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <string>
#include <unordered_map>

namespace springfit
{
  /** The numbers of the nodes or elements of a file, each of which is there
   * once. */
  class KnownNumbers
  {
  public:
    /** @p what is numbered: "node". */
    explicit KnownNumbers(const std::string &what);

    /** @throws InputError when it is there already. */
    void
    add(std::size_t number, const TextPlace &place);

    /** @p user is what needs it: "element 7". @throws InputError when absent.
     */
    void
    check(std::size_t number,
          const std::string &user,
          const TextPlace &place) const;

    std::size_t
    size() const;

  private:
    std::string what_;
    std::unordered_map<std::size_t, unsigned int> line_of_;
  };
} // namespace springfit

#endif
