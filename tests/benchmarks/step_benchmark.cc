// The price of an implicit step in time: a pulled cube (pulled_cube.h) by
// implicit Euler's method with one linearisation per step, for models of
// springs and of springs with volumes, on one core.
//
//   step_benchmark times [n ...]          milliseconds per step, CPU time
//   step_benchmark systems [n ...]        the same with every preconditioner
//   step_benchmark errors [n ...]         of the peak displacement
//   step_benchmark forces [n]             of explicit steps, beside a triad
//   step_benchmark peer n n_steps         springs of one stiffness: for
//   bullet_step

#include <springfit/motion/integrators.h>
#include <springfit/motion/iterative_step_system.h>
#include <springfit/motion/step_preconditioner.h>
#include <springfit/motion/step_systems.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pulled_cube.h"

using namespace springfit;

namespace
{
  /** Of this program: others on the machine do not count. */
  double
  milliseconds_since(const std::clock_t begin)
  {
    return 1e3 * (std::clock() - begin) / CLOCKS_PER_SEC;
  }

  /** The cube as a body; stays where it is. */
  struct Example
  {
    Example(const unsigned int n, const pulled_cube::CellModel &model)
      : cube(pulled_cube::make(n, model)), network(cube.network)
    {
      body.elastic = &network;
      body.mass    = Eigen::Map<const Eigen::VectorXd>(cube.network.mass.data(),
                                                    cube.network.mass.size());
      body.held    = cube.held;
      body.loads   = [this](const MotionState &state, Eigen::MatrixXd &forces) {
        forces.row(2) +=
          pulled_cube::traction(state.time) * cube.face_share.transpose();
      };
      state.displacement = state.velocity =
        Eigen::MatrixXd::Zero(cube.network.nodes.rows(),
                              cube.network.nodes.cols());
    }

    Example(const Example &) = delete;

    pulled_cube::Cube cube;
    NetworkBody network;
    MovingBody body;
    MotionState state;
  };

  /** What some steps were like. */
  struct Record
  {
    std::vector<double> times;        // ms
    std::vector<double> displacement; // of the loaded face after each, m
  };

  /** Appends to @p record. */
  void
  run(Example &example,
      StepSystem &system,
      const unsigned int n_steps,
      Record &record,
      const double step          = pulled_cube::step,
      const NewtonLimits &limits = {1., 1})
  {
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        const auto begin = std::clock();
        implicit_euler_step(example.body, system, limits, step, example.state);
        record.times.push_back(milliseconds_since(begin));
        record.displacement.push_back(
          pulled_cube::face_displacement(example.cube,
                                         example.state.displacement));
      }
  }

  double
  quantile(std::vector<double> values, const double share)
  {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * (values.size() - 1) + 0.5)];
  }

  double
  mean(const std::vector<unsigned int> &values)
  {
    double sum = 0.;
    for (const unsigned int value : values)
      sum += value;
    return sum / values.size();
  }

  double
  peak(const Record &record)
  {
    return *std::max_element(record.displacement.begin(),
                             record.displacement.end());
  }

  const std::vector<std::pair<std::string, pulled_cube::CellModel>> models = {
    {"plain springs", pulled_cube::plain_springs},
    {"stable neo-hookean", pulled_cube::stable_neo_hookean}};

  constexpr unsigned int steps_of_a_period = 50;

  void
  print_times(const std::string &name,
              const unsigned int n,
              const Record &record,
              const StepSystem &system)
  {
    // The first step builds the preconditioner.
    const std::vector<double> later(record.times.begin() + 1,
                                    record.times.end());
    std::printf("| %s | %u | %.2f | %.2f .. %.2f | %.1f | %.0f | %.4f |\n",
                name.c_str(),
                n,
                quantile(later, 0.5),
                quantile(later, 0.1),
                quantile(later, 0.9),
                mean(system.n_iterations()),
                record.times.front(),
                1e3 * peak(record));
  }

  void
  print_head()
  {
    std::printf(
      "| model | n | ms per step, median | 10 %% .. 90 %% | iterations "
      "| first step, ms | peak, mm |\n|---|---|---|---|---|---|---|\n");
  }

  /** The models take turns, step by step, so that they meet the same machine.
   */
  void
  time_steps(const std::vector<unsigned int> &sizes)
  {
    print_head();
    std::string reasons;
    for (const unsigned int n : sizes)
      {
        std::vector<std::unique_ptr<Example>> examples;
        std::vector<ChosenStepSystem> chosen;
        for (const auto &named : models)
          {
            examples.push_back(std::make_unique<Example>(n, named.second));
            chosen.push_back(make_step_system(3, examples.back()->body));
          }
        std::vector<Record> records(models.size());
        for (unsigned int i = 0; i < steps_of_a_period; ++i)
          for (std::size_t m = 0; m < models.size(); ++m)
            run(*examples[m], *chosen[m].system, 1, records[m]);
        for (std::size_t m = 0; m < models.size(); ++m)
          {
            print_times(models[m].first, n, records[m], *chosen[m].system);
            reasons += models[m].first + ", n = " + std::to_string(n) + ": " +
                       chosen[m].reason + '\n';
          }
      }
    std::printf("\n%s", reasons.c_str());
  }

  void
  time_systems(const std::vector<unsigned int> &sizes)
  {
    print_head();
    for (const auto &[name, model] : models)
      for (const unsigned int n : sizes)
        for (const bool has_factors : {false, true})
          {
            Example example(n, model);
            IterativeStepSystem system(
              3,
              example.body,
              has_factors ? factor_preconditioner(3, example.body)
                          : multigrid_preconditioner(3, example.body));
            Record record;
            run(example, system, steps_of_a_period, record);
            print_times(name + (has_factors ? ", factors" : ", multigrid"),
                        n,
                        record,
                        system);
          }
  }

  /** Of a period's peak with steps of a @p part of the usual, m. */
  double
  peak_with(const unsigned int n,
            const pulled_cube::CellModel &model,
            const unsigned int part,
            const double tolerance,
            const NewtonLimits &limits)
  {
    Example example(n, model);
    const auto chosen = make_step_system(3, example.body, tolerance);
    Record record;
    run(example,
        *chosen.system,
        part * steps_of_a_period,
        record,
        pulled_cube::step / part,
        limits);
    return peak(record);
  }

  void
  print_errors(const std::vector<unsigned int> &sizes)
  {
    std::printf(
      "| model | n | peak, mm | of tight solves, mm | and steps / 16, "
      "mm | and steps / 32, mm | solver error | one linearisation | "
      "steps' error |\n|---|---|---|---|---|---|---|---|---|\n");
    const NewtonLimits once = {1., 1}, all = {1e-9, 30};
    for (const auto &[name, model] : models)
      for (const unsigned int n : sizes)
        {
          const double usual  = peak_with(n, model, 1, 1e-6, once);
          const double solved = peak_with(n, model, 1, 1e-11, once);
          const double newton = peak_with(n, model, 1, 1e-11, all);
          const double fine   = peak_with(n, model, 16, 1e-11, all);
          const double finer  = peak_with(n, model, 32, 1e-11, all);
          std::printf("| %s | %u | %.5f | %.5f | %.5f | %.5f | %.1e | %.1e | "
                      "%.1e |\n",
                      name.c_str(),
                      n,
                      1e3 * usual,
                      1e3 * newton,
                      1e3 * fine,
                      1e3 * finer,
                      usual / solved - 1.,
                      solved / newton - 1.,
                      newton / (2. * finer - fine) - 1.);
        }
  }

  /** GB/s of a = b + 3 c on vectors that no cache holds (McCalpin's STREAM). */
  double
  triad()
  {
    const Eigen::Index n = 20000000;
    Eigen::VectorXd a = Eigen::VectorXd::Ones(n), b = a, c = a;
    double least = 1e300;
    for (unsigned int time = 0; time < 10; ++time)
      {
        const auto begin = std::clock();
        a                = b + 3. * c;
        b[time]          = a[n - 1 - time];
        least            = std::min(least, milliseconds_since(begin));
      }
    return 3e-6 * n * sizeof(double) / least;
  }

  void
  time_forces(const unsigned int n)
  {
    Example example(n, pulled_cube::plain_springs);
    const auto chosen = make_step_system(3, example.body);
    const double limit =
      spring_bound_of_step(example.cube.network,
                           std::vector<bool>(example.body.mass.size()));
    std::vector<double> times;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const auto begin = std::clock();
        symplectic_euler_step(example.body,
                              *chosen.system,
                              0.5 * limit,
                              example.state);
        times.push_back(milliseconds_since(begin));
      }
    const double time  = quantile(times, 0.5);
    const Members &all = example.cube.network.families[0].members;
    const double n_all = all.nodes.size() / 2.;
    const double bytes = n_all * (2. * sizeof(int) + 2. * sizeof(double)) +
                         3. * sizeof(double) * example.state.velocity.size();
    std::printf("Symplectic Euler, n = %u: %.2f ms per step, %.0f million "
                "spring forces per second (of the fastest step %.0f), %.1f "
                "GB/s; triad %.1f GB/s.\n",
                n,
                time,
                1e-3 * n_all / time,
                1e-3 * n_all / quantile(times, 0.),
                1e-6 * bytes / time,
                triad());
  }

  /** All springs of a cell of the stiffness that its neighbours share. */
  void
  run_as_peer(const unsigned int n, const unsigned int n_steps)
  {
    Example example(n, pulled_cube::plain_springs);
    SpringNetwork alike = example.cube.network;
    std::fill(alike.families[0].members.columns[0].begin(),
              alike.families[0].members.columns[0].end(),
              pulled_cube::stiffness_of_peers(n));
    const NetworkBody network(alike);
    example.body.elastic = &network;
    const auto chosen    = make_step_system(3, example.body);
    Record record;
    run(example, *chosen.system, n_steps, record);
    std::printf("springfit %u %u %.9g %.9g\n",
                n,
                n_steps,
                quantile({record.times.begin() + 1, record.times.end()}, 0.5),
                record.displacement.back());
  }
} // namespace

int
main(int argc, char *argv[])
{
  const std::string what = argc > 1 ? argv[1] : "times";
  std::vector<unsigned int> numbers;
  for (int i = 2; i < argc; ++i)
    numbers.push_back(std::atoi(argv[i]));
  const auto sizes =
    numbers.empty() ? std::vector<unsigned int>{8, 16, 32} : numbers;
  if (what == "times")
    time_steps(sizes);
  else if (what == "systems")
    time_systems(sizes);
  else if (what == "errors")
    print_errors(sizes);
  else if (what == "forces")
    time_forces(sizes.back());
  else if (what == "peer" && numbers.size() == 2)
    run_as_peer(numbers[0], numbers[1]);
  else
    {
      std::fprintf(stderr,
                   "The head of step_benchmark.cc says how to run it.\n");
      return 2;
    }
}
