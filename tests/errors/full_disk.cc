// Preloaded before the program, this puts one of its files on a full disk: the
// one whose path ends in $NO_SPACE_FOR. The names and the places of a run's
// files are its own until it is done, so that no link can be put there from
// outside.

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{
  using Open = FILE *(*)(const char *, const char *);

  FILE *
  open_file(const char *name, const char *path, const char *mode)
  {
    const auto open        = reinterpret_cast<Open>(dlsym(RTLD_NEXT, name));
    const char *const full = std::getenv("NO_SPACE_FOR");
    if (full == nullptr || std::strlen(full) > std::strlen(path))
      return open(path, mode);
    const char *const end = path + std::strlen(path) - std::strlen(full);
    return open(std::strcmp(end, full) == 0 ? "/dev/full" : path, mode);
  }
} // namespace

extern "C"
{
  FILE *
  fopen(const char *path, const char *mode)
  {
    return open_file("fopen", path, mode);
  }

  FILE *
  fopen64(const char *path, const char *mode)
  {
    return open_file("fopen64", path, mode);
  }
}
