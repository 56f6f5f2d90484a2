#include <springfit/mesh/msh_head.h>

#include <fstream>

namespace springfit
{
  MshHead
  read_msh_head(const std::filesystem::path &file)
  {
    std::ifstream stream(file, std::ios::binary);
    for (std::string line; std::getline(stream, line);)
      {
        if (line.rfind("$NOD", 0) == 0)
          return {"1", false};
        if (line.rfind("$MeshFormat", 0) == 0)
          {
            std::string version, is_binary;
            stream >> version >> is_binary;
            return {version, is_binary == "1"};
          }
      }
    return {"", false};
  }
} // namespace springfit
