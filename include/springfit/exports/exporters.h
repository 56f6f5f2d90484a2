#ifndef springfit_exports_exporters_h
#define springfit_exports_exporters_h

#include <springfit/exports/exported_scene.h>
#include <springfit/exports/formats.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace springfit
{
  /** A format: what it holds, and how it is written. */
  struct Exporter
  {
    ExportFormat format;

    /** What a network may have: part of a sentence. */
    std::string holds;

    /** The entries of section Fit by which it comes closest: the same. */
    std::string best;

    /** Whether a program knows small displacements besides true forces. */
    bool knows_small_displacements;

    /** What of a scene it cannot hold, as parts of a sentence. */
    std::function<std::vector<std::string>(const ExportedScene &)> missing;

    /** What of a scene it leaves out, the same. */
    std::function<std::vector<std::string>(const ExportedScene &)> left_out;

    /** @throws RunError when a file cannot be written. */
    std::function<void(const std::filesystem::path &folder,
                       const ExportedScene &)>
      write;
  };

  Exporter
  exporter_of(ExportFormat format, SofaVersion sofa_version);
} // namespace springfit

#endif
