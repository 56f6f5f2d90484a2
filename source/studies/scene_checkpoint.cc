#include <springfit/core/error.h>
#include <springfit/studies/scene_checkpoint.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace springfit
{
  namespace
  {
    std::string
    description_of_scene(const std::filesystem::path &folder)
    {
      std::ifstream file(folder / "used.prm");
      std::string text, line;
      while (std::getline(file, line))
        if (line.find("set Output directory") == std::string::npos &&
            line.find("set Time limit") == std::string::npos &&
            line.find('#') == std::string::npos)
          text += line + '\n';
      return text;
    }

    /** The first line in which two scenes differ. */
    std::string
    difference(const std::string &old_scene, const std::string &new_scene)
    {
      std::istringstream old_lines(old_scene), new_lines(new_scene);
      std::string old_line, new_line;
      while (true)
        {
          const bool more_old = !std::getline(old_lines, old_line).fail();
          const bool more_new = !std::getline(new_lines, new_line).fail();
          if (!more_old && !more_new)
            return "";
          if (!more_old)
            old_line = "the end";
          if (!more_new)
            new_line = "the end";
          if (old_line != new_line)
            {
              const auto begin = [](const std::string &line) {
                return std::min(line.find_first_not_of(' '), line.size());
              };
              return "it has '" + old_line.substr(begin(old_line)) +
                     "' where this one has '" +
                     new_line.substr(begin(new_line)) + '\'';
            }
        }
    }

    std::uint64_t
    sum_of_networks(const std::vector<CalibratedNetwork> &networks)
    {
      CheckpointWriter numbers;
      for (const auto &network : networks)
        {
          numbers << network.network.nodes;
          for (const auto &family : network.network.families)
            for (const auto &column : family.members.columns)
              for (const double value : column)
                numbers << value;
        }
      return numbers.sum();
    }

    [[noreturn]] void
    refuse_checkpoint(const std::filesystem::path &path,
                      const std::string &reason)
    {
      throw InputError("The checkpoint '" + path.string() +
                         "' is of another scene: " + reason + '.',
                       "Remove it to begin anew, choose another 'Output "
                       "directory', or run the scene that it belongs to.");
    }
  } // namespace

  SceneIdentity
  identity_of_scene(const std::filesystem::path &folder,
                    const std::vector<CalibratedNetwork> &networks)
  {
    return {description_of_scene(folder), sum_of_networks(networks)};
  }

  void
  write_identity(const SceneIdentity &identity, CheckpointWriter &checkpoint)
  {
    checkpoint << identity.entries << identity.sum_of_networks;
  }

  void
  check_identity(const SceneIdentity &identity,
                 const std::filesystem::path &path,
                 CheckpointReader &checkpoint)
  {
    SceneIdentity other;
    checkpoint >> other.entries >> other.sum_of_networks;
    if (const auto text = difference(other.entries, identity.entries);
        !text.empty())
      refuse_checkpoint(path, text);
    if (other.sum_of_networks != identity.sum_of_networks)
      refuse_checkpoint(path, "its mesh or its springs differ");
  }
} // namespace springfit
