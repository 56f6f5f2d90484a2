#ifndef springfit_comparison_tradeoff_h
#define springfit_comparison_tradeoff_h

#include <springfit/core/words.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace springfit
{
  /** What a user pays for. */
  enum class Purpose
  {
    statics,
    implicit_motion,
    explicit_motion
  };

  const WordTable<Purpose> &
  purpose_words();


  /**
   * A model on a mesh: how far it is from a reference, the worst of all load
   * cases, and what it costs. What could not be measured has no value.
   */
  struct TradeoffRow
  {
    std::string model;      // "springs" or "fem"
    std::string fit;        // of springs; the material law of finite elements
    std::string enrichment; // "none" of finite elements
    std::string kinematics;
    std::string cells;
    double cell_size; // m

    // How its mesh is made: the entries 'Cell size', which a mesh file has
    // not, and 'Refinements'.
    std::string cell_size_entry;
    unsigned int n_refinements;

    unsigned int n_dofs;
    std::optional<unsigned int> n_springs;

    // In per cent: of the largest displacement, of the largest force of a
    // support, of the energy, of the named quantity.
    std::optional<double> e_rms, e_max, force_error, energy_error,
      quantity_error;

    // s, medians; of one load case, of one step
    std::optional<double> calibrate, setup, solve, implicit_step, explicit_step;

    std::optional<double> stable_step; // s, of explicit steps
    std::optional<double> memory;      // MiB, of an implicit motion

    /** Largest half width of the middle half of the times, in per cent. */
    std::optional<double> spread;

    bool is_on_front = false; // no other is both cheaper and more accurate

    /** Why something has no value; a sentence, or empty. */
    std::string failure;
  };

  /**
   * The same model on the next smaller cells of the kind, if it is farther from
   * the reference there by a tenth and more: its errors cancel on its own.
   */
  std::optional<std::size_t>
  finer_and_worse(const std::vector<TradeoffRow> &rows, std::size_t row);

  /**
   * What a row costs, s: a solution of statics; an implicit step; the explicit
   * steps that @p time_step (s) takes, at nine tenths of the stable one.
   */
  std::optional<double>
  cost(const TradeoffRow &row, Purpose purpose, double time_step);

  /** Mark the rows that no other beats in both e_rms and cost. */
  void
  mark_front(Purpose purpose, double time_step, std::vector<TradeoffRow> &rows);


  /** What a user wants of a model. */
  struct Demand
  {
    double accuracy; // largest e_rms, per cent
    double budget;   // largest cost, s; 0: any
    Purpose purpose;
    double time_step; // s
  };

  /** Which rows answer a demand; positions in the table. */
  struct Advice
  {
    /** The cheapest that meets both. */
    std::optional<std::size_t> chosen;

    /** Without such a one: the cheapest that is accurate enough, ... */
    std::optional<std::size_t> cheapest_accurate;

    /** ... the most accurate within the budget, ... */
    std::optional<std::size_t> most_accurate_affordable;

    /** ... and the most accurate of all. */
    std::optional<std::size_t> most_accurate;
  };

  Advice
  advise(const std::vector<TradeoffRow> &rows, const Demand &demand);
} // namespace springfit

#endif
