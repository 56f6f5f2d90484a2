#include <springfit/core/atomic_file.h>
#include <springfit/core/collective.h>
#include <springfit/core/error.h>
#include <springfit/core/example_scene.h>
#include <springfit/core/incomplete_error.h>
#include <springfit/core/lone_process.h>
#include <springfit/core/long_values.h>
#include <springfit/core/parameters.h>
#include <springfit/core/session.h>
#include <springfit/core/unexpected.h>
#include <springfit/core/version.h>
#include <springfit/core/words.h>
#include <springfit/fit/methods.h>
#include <springfit/output/result_names.h>
#include <springfit/studies/study.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_acceptor.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  using namespace springfit;

  /** Exit codes. */
  enum class Status : int
  {
    done        = 0,
    run_failed  = 1,
    wrong_input = 2
  };

  struct CommandLine
  {
    ParameterSource source;
    bool validate_only = false;
    std::string defaults; // "2" or "3", or empty
  };

  /** The entries that belong to no section. */
  struct TopLevel
  {
    unsigned int dimension;
    std::string study_word       = "compare";
    std::string output_directory = "output/springfit";

    void
    declare(dealii::ParameterHandler &prm)
    {
      prm.add_parameter("Dimension",
                        dimension,
                        "Dimension of space, 2 or 3 (no unit).");
      prm.add_parameter("Study",
                        study_word,
                        "What to do: " + join(words_of(study_words()), " or ") +
                          " (no unit).");
      prm.add_parameter("Output directory",
                        output_directory,
                        "Folder for the results, made if need be (no unit); a "
                        "relative one starts in the working directory.");
    }

    void
    check() const
    {
      if (output_directory.empty())
        throw EntryError("Output directory",
                         "no folder is given.",
                         "Name a folder for the results, such as "
                         "output/cube.");
    }
  };

  /** @throws EntryError when it is neither 2 nor 3. */
  unsigned int
  parse_dimension(const std::string &text)
  {
    if (text != "2" && text != "3")
      throw EntryError("Dimension",
                       text.empty() ? "it is not given."
                                    : "'" + text + "' is neither 2 nor 3.",
                       "Write \"set Dimension = 2\" or \"set Dimension = 3\" "
                       "at the top of the parameter file.");
    return text == "2" ? 2 : 3;
  }

  /** Every entry with its text and value, as a parameter file. */
  void
  print_parameters(const dealii::ParameterHandler &prm, std::ostream &file)
  {
    prm.print_parameters(file,
                         dealii::ParameterHandler::PRM |
                           dealii::ParameterHandler::KeepDeclarationOrder);
  }

  /**
   * The entry "File" as used.prm has it, which stands in another folder than
   * the file that it comes from.
   */
  std::string
  stored_mesh_name(const ParameterSource &source, const std::string &mesh)
  {
    return mesh.empty()
             ? ""
             : std::filesystem::absolute(source.file.parent_path() / mesh)
                 .lexically_normal()
                 .string();
  }

  void
  write_record(const ParameterSource &source, Session &session)
  {
    auto &prm = dealii::ParameterAcceptor::prm;
    prm.enter_subsection("Geometry");
    const std::string mesh = prm.get("File");
    prm.set("File", stored_mesh_name(source, mesh));
    prm.leave_subsection();

    run_on_root(session.communicator(), [&]() {
      const auto &folder = session.draft();
      write_file(folder / "original.prm", [&](std::ostream &file) {
        file << std::ifstream(source.file).rdbuf();
      });
      write_file(folder / "used.prm",
                 [&](std::ostream &file) { print_parameters(prm, file); });
    });
    prm.enter_subsection("Geometry");
    prm.set("File", mesh);
    prm.leave_subsection();

    session.print(version() + ", " + source.file.string() + ", ranks: " +
                  std::to_string(dealii::Utilities::MPI::n_mpi_processes(
                    session.communicator())));
    session.log(library_versions());
    for (const auto &text : source.overrides)
      session.log("--set \"" + text + "\"");
  }

  /** How names of files call the models that studies run. */
  std::vector<std::string>
  names_of_models()
  {
    std::vector<std::string> names = {"fem"};
    for (const auto &[method, word] : method_words())
      names.push_back(name_of(*method));
    return names;
  }

  template <int dim>
  void
  run(const CommandLine &command_line)
  {
    const MPI_Comm communicator = MPI_COMM_WORLD;
    auto &prm                   = dealii::ParameterAcceptor::prm;
    TopLevel top_level{dim};
    top_level.declare(prm);
    Scene<dim> scene;
    scene.folder = command_line.source.file.parent_path();
    dealii::ParameterAcceptor::declare_all_parameters();

    if (!command_line.defaults.empty())
      {
        run_on_root(communicator, [&]() {
          std::ostringstream text;
          print_parameters(prm, text);
          if (!(std::cout << text.str() << std::flush))
            throw RunError("The parameter file could not be written to the "
                           "standard output.",
                           "Free space on the disk.");
        });
        return;
      }

    read_parameters(prm, command_line.source);
    dealii::ParameterAcceptor::parse_all_parameters();
    top_level.check();
    check_can_be_stored("Output directory", top_level.output_directory);
    prm.enter_subsection("Geometry");
    check_can_be_stored("Geometry/File",
                        stored_mesh_name(command_line.source, prm.get("File")));
    prm.leave_subsection();
    const auto study = value_of(study_words(), top_level.study_word, "Study");
    complete_study(study, scene);
    check_study(study, scene);
    run_collectively(communicator,
                     [&]() { scene.geometry.check_files(scene.folder); });
    if (command_line.validate_only)
      {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          std::cout << command_line.source.file.string() << " is valid."
                    << std::endl;
        return;
      }

    Session session(communicator,
                    top_level.output_directory,
                    [models = names_of_models()](const std::string &name) {
                      return is_result(name, models);
                    });
    try
      {
        write_record(command_line.source, session);
        std::optional<IncompleteError> incomplete;
        try
          {
            run_study(study, scene, session);
          }
        catch (const IncompleteError &error)
          {
            incomplete = error;
            session.log(std::string("The run ended with an error. ") +
                        error.what());
          }
        session.finish();
        if (incomplete)
          throw *incomplete;
      }
    catch (const InputError &error)
      {
        session.give_up(error.what());
        throw;
      }
    catch (const std::exception &error)
      {
        throw RunError(session.give_up(as_run_error(error).what()));
      }
  }

  /**
   * Say what went wrong, once, and how the program ends. A rank that fails
   * alone must stop the others, who wait for it.
   */
  Status
  report(const std::string &whole_message,
         const Status status,
         const ParameterSource &source = {})
  {
    const std::string message = without_long_values(whole_message, source);
    if (!all_ranks_arrive(MPI_COMM_WORLD, 5.))
      {
        std::cerr << "Error: " << message << std::endl;
        expect_end();
        MPI_Abort(MPI_COMM_WORLD, static_cast<int>(status));
      }
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cerr << "Error: " << message << std::endl;
    return status;
  }

  Status
  run(const CommandLine &command_line)
  {
    try
      {
        std::string dimension = command_line.defaults;
        if (dimension.empty())
          {
            check_parameter_file(command_line.source.file);
            dimension = read_top_level_entry(command_line.source, "Dimension");
          }
        parse_dimension(dimension) == 2 ? run<2>(command_line)
                                        : run<3>(command_line);
        return Status::done;
      }
    catch (const EntryError &error)
      {
        return report(locate(error, command_line.source),
                      Status::wrong_input,
                      command_line.source);
      }
    catch (const InputError &error)
      {
        return report(error.what(), Status::wrong_input, command_line.source);
      }
    catch (const std::exception &error)
      {
        return report(as_run_error(error).what(),
                      Status::run_failed,
                      command_line.source);
      }
  }

  /** What main() does once MPI has begun. */
  Status
  run(int argc, char *argv[])
  {
    const bool is_root =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

    CommandLine command_line;
    std::string file;
    CLI::App app("springfit turns a mesh into springs that come as close as "
                 "they can to its finite elements, and measures how close.\n"
                 "Example: springfit " +
                 example_scene());
    app.add_option("file", file, "parameter file (.prm)");
    app
      .add_option("--set",
                  command_line.source.overrides,
                  "\"Section/Entry=value\" takes precedence over the file; may "
                  "be repeated")
      ->type_name("TEXT")
      ->allow_extra_args(false);
    app.add_flag("--validate",
                 command_line.validate_only,
                 "check the parameters and stop");
    app
      .add_option("--defaults",
                  command_line.defaults,
                  "print a commented parameter file for 2 or 3 dimensions")
      ->check(CLI::IsMember({"2", "3"}));
    app.set_version_flag("--version", version() + '\n' + library_versions());

    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::Success &success)
      {
        // Help and version are the success of the command line.
        if (is_root)
          app.exit(success);
        return Status::done;
      }
    catch (const CLI::ParseError &error)
      {
        return report(
          std::string(error.what()) +
            ". 'springfit --help' lists the options; try springfit " +
            example_scene() + '.',
          Status::wrong_input);
      }

    if (file.empty() && command_line.defaults.empty())
      return report("No parameter file is given. Try springfit " +
                      example_scene() + ", or springfit --help.",
                    Status::wrong_input);
    command_line.source.file = file;
    return run(command_line);
  }
} // namespace

int
main(int argc, char *argv[])
{
  try
    {
      check_surroundings();
    }
  catch (const InputError &error)
    {
      std::cerr << "Error: " << error.what() << std::endl;
      return static_cast<int>(Status::wrong_input);
    }
  catch (const RunError &error)
    {
      std::cerr << "Error: " << error.what() << std::endl;
      return static_cast<int>(Status::run_failed);
    }

  prepare_for_lone_process();
  Status status;
  {
    dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    report_unexpected_ends();
    status = run(argc, argv);
  }
  expect_end();
  return static_cast<int>(status);
}
