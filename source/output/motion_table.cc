#include <springfit/output/motion_table.h>

#include <algorithm>
#include <cctype>

namespace springfit
{
  std::string
  motion_header(const std::vector<std::string> &names)
  {
    std::string header =
      "time_s,kinetic_J,elastic_J,contact_J,dissipated_J,work_of_loads_J,"
      "work_of_supports_J,work_of_contact_J,momentum_x,momentum_y,momentum_z,"
      "angular_momentum_x,angular_momentum_y,angular_momentum_z";
    for (const auto &name : names)
      for (const char *component : {"_x", "_y", "_z"})
        header += ',' + name + component;
    return header;
  }

  void
  write_motion_row(const MotionRow &row, CsvTable &table)
  {
    const auto &account = row.account;
    table.exactly(row.time)
      << row.kinetic << row.elastic << row.contact << account.dissipated
      << account.work_of_loads << account.work_of_supports
      << account.work_of_contact;
    const auto add = [&](const Eigen::VectorXd &vector) {
      for (Eigen::Index d = 0; d < 3; ++d)
        table << (d < vector.size() ? vector[d] : 0.);
    };
    add(row.momentum);
    if (row.angular_momentum.size() == 1)
      add(Eigen::Vector3d(0., 0., row.angular_momentum[0]));
    else
      add(row.angular_momentum);
    for (const auto &vector : row.vectors)
      add(vector);
  }

  void
  write_motion_summaries(const std::filesystem::path &folder,
                         const std::vector<MotionSummary> &rows)
  {
    CsvTable table("case,fit,enrichment,kinematics,n_steps,step_s,"
                   "stable_step_s,ms_per_step,iterations,peak_displacement_m,"
                   "e_rms_percent,e_max_percent");
    for (const auto &row : rows)
      {
        std::optional<double> e_rms, e_max;
        if (row.errors)
          {
            e_rms = row.errors->e_rms_percent;
            e_max = row.errors->e_max_percent;
          }
        table.new_row();
        table << row.load_case << row.fit << row.enrichment << row.kinematics
              << static_cast<unsigned int>(row.n_steps) << row.step
              << row.critical_step << 1e3 * row.seconds_of_step
              << row.iterations << row.peak << e_rms << e_max;
      }
    table.write(folder / "dynamics.csv");
  }

  std::string
  column_name(const std::string &name, const std::vector<std::string> &others)
  {
    std::string plain;
    for (const unsigned char c : name)
      plain += std::isalnum(c) ? static_cast<char>(c) : '_';
    const auto is_taken = [&](const std::string &candidate) {
      return std::find(others.begin(), others.end(), candidate) != others.end();
    };
    std::string candidate = plain;
    for (unsigned int i = 2; is_taken(candidate); ++i)
      candidate = plain + '_' + std::to_string(i);
    return candidate;
  }
} // namespace springfit
