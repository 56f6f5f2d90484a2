#include <springfit/mesh/msh_names.h>

#include <fstream>
#include <sstream>

namespace springfit
{
  std::vector<MshName>
  names_in_msh(const std::filesystem::path &file)
  {
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    // The names stand before the nodes, which may be binary.
    while (std::getline(stream, line) && line.rfind("$PhysicalNames", 0) != 0 &&
           line.rfind("$Nodes", 0) != 0)
      ;
    std::vector<MshName> names;
    if (line.rfind("$PhysicalNames", 0) != 0)
      return names;
    while (std::getline(stream, line) && line.rfind("$End", 0) != 0)
      {
        std::istringstream words(line);
        int dim, number;
        const auto begin = line.find('"'), end = line.rfind('"');
        if (words >> dim >> number && begin < end)
          names.push_back(
            {dim, number, line.substr(begin + 1, end - begin - 1)});
      }
    return names;
  }
} // namespace springfit
