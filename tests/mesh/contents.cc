// Formats told by how their files begin.

#include <springfit/mesh/file_contents.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

using namespace springfit;

TEST(Contents, tell_the_format)
{
  using namespace std::string_literals;
  const std::vector<std::pair<std::string, std::string>> cases = {
    {".msh", "$MeshFormat\n2.2 0 8\n"},
    {".msh", "$NOD\n1\n"},
    {".msh", "$Comments\nby hand\n$EndComments\n$MeshFormat\n"},
    {"", "\xEF\xBB\xBF$MeshFormat\n2.2 0 8\n"},
    {"", " $MeshFormat\n2.2 0 8\n"},
    {".vtk", "# vtk DataFile Version 3.0\ntitle\nASCII\n"},
    {".inp", "** a comment\n*Heading\n"},
    {".inp", "\r\n*NODE\r\n1, 0, 0\r\n"},
    {".k", "$ a comment\n*KEYWORD\n*NODE\n"},
    {".mesh", "# a comment\nMeshVersionFormatted 2\n"},
    {".unv", "    -1\n  2411\n"},
    {".bdf", "$ a comment\nGRID           1              0.      0.      0.\n"},
    {".bdf", "grid,1,,0.,0.,0.\n"},
    {".bdf", "SOL 101\nCEND\n"},
    {".geo", "// a comment\nPoint(1) = {0, 0, 0};\n"},
    {".step", "ISO-10303-21;\nHEADER;\n"},
    {".brep", "\nCASCADE Topology V1, (c) Matra-Datavision\n"},
    {".igs", std::string(72, ' ') + "S      1\n"},
    {".stl", "solid a\nfacet normal 0 0 1\n"},
    {".vtu", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n"},
    {".su2", "% a comment\nNDIME= 2\n"},
    {".cas", "(0 \"written by hand\")\n"},
    {".gz", "\x1f\x8b\x08\x00"s},
    {".zip", "PK\x03\x04"},
    {".h5", "\x89HDF\r\n\x1a\n"},
    {".e", "CDF\x01"},
    {"git-lfs", "version https://git-lfs.github.com/spec/v1\n"},
    {"", "nothing\n"},
    {"", ""}};
  const auto file =
    std::filesystem::temp_directory_path() / "springfit_contents";
  for (const auto &[ending, text] : cases)
    {
      std::ofstream(file, std::ios::binary) << text;
      EXPECT_EQ(ending_by_content(file), ending) << text;
    }
  std::filesystem::remove(file);
}
