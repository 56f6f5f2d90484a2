#include <springfit/core/atomic_file.h>
#include <springfit/core/parameter_text.h>
#include <springfit/fit/methods.h>
#include <springfit/studies/recommended_scene.h>

#include <fstream>
#include <map>
#include <ostream>
#include <sstream>
#include <string>

namespace springfit
{
  void
  write_recommended_scene(const std::filesystem::path &folder,
                          const TradeoffRow &row,
                          const Demand &demand)
  {
    std::map<std::string, std::string> entries;
    entries["Study"] =
      demand.purpose == Purpose::statics ? "compare" : "dynamics";
    entries["Output directory"]     = "output/recommended";
    entries["Geometry/Cells"]       = row.cells;
    entries["Geometry/Refinements"] = std::to_string(row.n_refinements);
    entries["Geometry/Cell size"]   = row.cell_size_entry;
    entries["Response/Kinematics"]  = row.kinematics;
    if (row.model == "fem")
      {
        // Something is fitted all the same.
        entries["Response/Material law"] = row.fit;
        entries["Fit/Methods"]           = "frobenius";
        entries["Fit/Enrichment"]        = "none";
      }
    else
      {
        // By the words of parameter files, which are not those of tables.
        for (const auto &[method, word] : method_words())
          if (name_of(*method) == row.fit)
            entries["Fit/Methods"] = word;
        for (const auto &[enrichment, word] : enrichment_words())
          if (name_of(enrichment) == row.enrichment)
            entries["Fit/Enrichment"] = word;
      }
    if (demand.purpose != Purpose::statics)
      {
        entries["Dynamics/Integrator"] =
          demand.purpose == Purpose::explicit_motion ? "symplectic euler"
                                                     : "implicit euler";
        entries["Dynamics/Linearisations"] = "1";
        entries["Dynamics/Mass"]           = "lumped";
        entries["Dynamics/Finite elements"] =
          row.model == "fem" ? "true" : "false";
        if (demand.purpose == Purpose::explicit_motion)
          entries["Dynamics/Time step"] = "0";
      }
    std::ifstream used(folder / "used.prm");
    std::stringstream text;
    text << used.rdbuf();
    write_file(folder / "recommended.prm", [&](std::ostream &file) {
      file << with_entries(text.str(), entries);
    });
  }
} // namespace springfit
