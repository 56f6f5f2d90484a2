#include <springfit/core/error.h>
#include <springfit/core/incomplete_error.h>
#include <springfit/core/interruption.h>
#include <springfit/output/motion_table.h>
#include <springfit/studies/calibrated_scene.h>
#include <springfit/studies/case_in_motion.h>
#include <springfit/studies/network_exports.h>
#include <springfit/studies/responses.h>
#include <springfit/studies/scene_checkpoint.h>
#include <springfit/studies/study.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    const std::string checkpoint_name = "checkpoint.bin";

    /** What a run has done when it makes a checkpoint, but for the case in
     * hand.
     */
    struct Progressed
    {
      std::uint64_t n_cases = 0;
      std::vector<MotionSummary> summaries;
      std::vector<std::string> files;
    };

    void
    write(const Progressed &done, CheckpointWriter &checkpoint)
    {
      checkpoint << done.n_cases << std::uint64_t(done.summaries.size());
      for (const auto &row : done.summaries)
        {
          checkpoint << row.load_case << row.fit << row.enrichment
                     << row.kinematics << row.n_steps << row.step
                     << row.critical_step.value_or(0.) << row.seconds_of_step
                     << row.iterations.value_or(-1.) << row.peak
                     << std::uint64_t(row.errors ? 1 : 0);
          const ErrorNorms errors = row.errors.value_or(ErrorNorms{});
          checkpoint << errors.e_rms_percent << errors.e_max_percent;
        }
      checkpoint << std::uint64_t(done.files.size());
      for (const auto &file : done.files)
        checkpoint << file;
    }

    Progressed
    read_progressed(CheckpointReader &checkpoint)
    {
      Progressed done;
      std::uint64_t n;
      checkpoint >> done.n_cases >> n;
      for (std::uint64_t i = 0; i < n; ++i)
        {
          MotionSummary row;
          double critical_step, iterations;
          std::uint64_t has_errors;
          ErrorNorms errors;
          checkpoint >> row.load_case >> row.fit >> row.enrichment >>
            row.kinematics >> row.n_steps >> row.step >> critical_step >>
            row.seconds_of_step >> iterations >> row.peak >> has_errors >>
            errors.e_rms_percent >> errors.e_max_percent;
          if (critical_step > 0.)
            row.critical_step = critical_step;
          if (iterations >= 0.)
            row.iterations = iterations;
          if (has_errors)
            row.errors = errors;
          done.summaries.push_back(row);
        }
      checkpoint >> n;
      for (std::uint64_t i = 0; i < n; ++i)
        {
          std::string file;
          checkpoint >> file;
          done.files.push_back(file);
        }
      return done;
    }

    /** What the canned cases are scaled by, and every other one as it is. */
    template <int dim, int spacedim>
    Loading
    loading_of(const Scene<spacedim> &scene,
               const CalibratedScene<dim, spacedim> &calibrated,
               Session &session)
    {
      Loading loading = scene.loads.resolve(*calibrated.mesh,
                                            calibrated.element,
                                            calibrated.materials);
      if (loading.pull)
        {
          scene.loads.check_supports(*calibrated.mesh, loading);
          scale_canned_cases(scene, calibrated, session, loading);
        }
      return loading;
    }

    std::string
    summary_line(const MotionSummary &row)
    {
      char text[240];
      std::snprintf(text,
                    sizeof(text),
                    "%-12s %-32s %-10s %9llu %11.3g %11.4g",
                    row.load_case.c_str(),
                    name_of(row.fit, row.enrichment).c_str(),
                    row.kinematics.c_str(),
                    static_cast<unsigned long long>(row.n_steps),
                    1e3 * row.seconds_of_step,
                    row.peak);
      std::string line = text;
      if (row.errors)
        {
          std::snprintf(text,
                        sizeof(text),
                        " %8.3g %8.3g",
                        row.errors->e_rms_percent,
                        row.errors->e_max_percent);
          line += text;
        }
      return line;
    }

    /** Bring the files that a checkpoint goes on with into this run's folder.
     */
    void
    take_over(const std::vector<std::string> &files,
              const std::filesystem::path &folder,
              const std::filesystem::path &draft)
    {
      for (const auto &file : files)
        {
          std::error_code error;
          std::filesystem::copy_file(folder / file, draft / file, error);
          if (error)
            throw InputError("The checkpoint '" +
                               (folder / checkpoint_name).string() +
                               "' goes on with '" + file +
                               "', which cannot be read: " + error.message() +
                               '.',
                             "Remove the checkpoint to begin anew.");
        }
    }

    void
    check_ranks(Session &session)
    {
      if (dealii::Utilities::MPI::n_mpi_processes(session.communicator()) > 1)
        throw EntryError("Study",
                         "dynamics run on one rank.",
                         "Start springfit without mpirun.");
    }
  } // namespace

  template <int dim, int spacedim>
  void
  dynamics(const Scene<spacedim> &scene, Session &session)
  {
    const auto begin = std::chrono::steady_clock::now();
    check_ranks(session);
    auto calibrated    = make_scene<dim, spacedim>(scene, session);
    const auto loading = loading_of(scene, calibrated, session);
    calibrate_scene(scene, calibrated, loading.held, {}, session);
    check_moving_exports(scene, calibrated, loading.held);
    write_moving_exports(scene, calibrated, loading, session);
    const Interruption interruption;
    const auto identity =
      identity_of_scene(session.draft(), calibrated.networks);

    Progressed done;
    std::optional<CheckpointReader> earlier;
    const auto old_file = session.output_directory() / checkpoint_name;
    if (std::filesystem::exists(old_file))
      {
        earlier.emplace(old_file);
        check_identity(identity, old_file, *earlier);
        done = read_progressed(*earlier);
        done.files.push_back(checkpoint_name);
        take_over(done.files, session.output_directory(), session.draft());
      }

    dealii::TimerOutput::Scope scope(session.timer(), "Motion");
    while (done.n_cases < loading.cases.size())
      {
        CaseInMotion<dim, spacedim> motion(
          scene, calibrated, loading, loading.cases[done.n_cases], session);
        if (!session.is_published())
          session.publish();
        if (earlier)
          motion.resume(*earlier);
        else
          motion.begin();
        earlier.reset();
        motion.run({interruption, begin}, [&]() {
          Progressed with_case = done;
          for (const auto &file : motion.files())
            with_case.files.push_back(file);
          CheckpointWriter checkpoint;
          write_identity(identity, checkpoint);
          write(with_case, checkpoint);
          motion.save(checkpoint);
          checkpoint.write(session.draft() / checkpoint_name);
        });
        for (const auto &row : motion.summary())
          done.summaries.push_back(row);
        for (const auto &file : motion.files())
          done.files.push_back(file);
        ++done.n_cases;
      }
    if (!scene.dynamics.settings().has_finite_elements)
      session.skip("Motion of the finite elements",
                   "'Finite elements = false' in section Dynamics");
    if (!(scene.dynamics.settings().frame_interval > 0.))
      session.skip("Pictures for ParaView",
                   "'Frame interval = 0' in section Dynamics");
    write_motion_summaries(session.draft(), done.summaries);
    std::filesystem::remove(session.draft() / checkpoint_name);

    session.print(
      "\nMotions (errors in % of the largest displacement of the "
      "finite elements):\n"
      "case         fit                              kinematics     "
      "steps  ms per step      peak m    e_rms    e_max");
    for (const auto &row : done.summaries)
      session.print(summary_line(row));
    session.say_at_the_end("dynamics.csv is the table above, *_motion.csv are "
                           "the motions; open the .pvd files in ParaView and "
                           "apply Warp By Vector.");
  }

  template void
  dynamics<2, 2>(const Scene<2> &, Session &);
  template void
  dynamics<2, 3>(const Scene<3> &, Session &);
  template void
  dynamics<3, 3>(const Scene<3> &, Session &);
} // namespace springfit
