#ifndef springfit_output_network_vtu_h
#define springfit_output_network_vtu_h

#include <springfit/output/node_grid.h>
#include <springfit/springs/network.h>

#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /**
   * A network for ParaView, in a file for each kind of its parts beside their
   * table (write_network()): springs_<name>.vtu and, where there are any,
   * couplings_, angles_, volumes_<name>.vtu ... Point p is node p; cell c is
   * row c of the table, whose columns are its data: "k", "rest_length", ..., of
   * several numbers where a member has several volumes.
   *
   * Springs are lines and volumes the cells that they are of. Angles are lines
   * through their three nodes; couplings through i_a, j_a, i_b, j_b, so that
   * the middle stretch joins the two lengths.
   *
   * @throws RunError as write_vtu() does.
   */
  void
  write_network_vtu(const std::filesystem::path &folder,
                    const std::string &name,
                    const SpringNetwork &network,
                    const std::vector<NodalField> &fields);
} // namespace springfit

#endif
