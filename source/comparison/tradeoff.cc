#include <springfit/comparison/tradeoff.h>

#include <algorithm>
#include <cmath>

namespace springfit
{
  const WordTable<Purpose> &
  purpose_words()
  {
    static const WordTable<Purpose> table = {
      {Purpose::statics, "statics"},
      {Purpose::implicit_motion, "implicit motion"},
      {Purpose::explicit_motion, "explicit motion"}};
    return table;
  }

  std::optional<std::size_t>
  finer_and_worse(const std::vector<TradeoffRow> &rows, const std::size_t row)
  {
    const auto &coarse = rows[row];
    std::optional<std::size_t> finer;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].model == coarse.model && rows[i].fit == coarse.fit &&
          rows[i].enrichment == coarse.enrichment &&
          rows[i].kinematics == coarse.kinematics &&
          rows[i].cells == coarse.cells && rows[i].e_rms &&
          rows[i].cell_size < coarse.cell_size &&
          (!finer || rows[i].cell_size > rows[*finer].cell_size))
        finer = i;
    if (finer && coarse.e_rms && *rows[*finer].e_rms > 1.1 * *coarse.e_rms)
      return finer;
    return {};
  }

  std::optional<double>
  cost(const TradeoffRow &row, const Purpose purpose, const double time_step)
  {
    switch (purpose)
      {
        case Purpose::statics:
          return row.solve;
        case Purpose::implicit_motion:
          return row.implicit_step;
        case Purpose::explicit_motion:
          if (row.explicit_step && row.stable_step)
            return *row.explicit_step *
                   std::max(1.,
                            std::ceil(time_step / (0.9 * *row.stable_step)));
      }
    return {};
  }

  void
  mark_front(const Purpose purpose,
             const double time_step,
             std::vector<TradeoffRow> &rows)
  {
    for (auto &row : rows)
      {
        const auto own  = cost(row, purpose, time_step);
        row.is_on_front = row.e_rms && own;
        if (row.is_on_front)
          row.is_on_front =
            std::none_of(rows.begin(), rows.end(), [&](const auto &other) {
              const auto of_other = cost(other, purpose, time_step);
              return other.e_rms && of_other && *other.e_rms <= *row.e_rms &&
                     *of_other <= *own &&
                     (*other.e_rms < *row.e_rms || *of_other < *own);
            });
      }
  }

  Advice
  advise(const std::vector<TradeoffRow> &rows, const Demand &demand)
  {
    Advice advice;
    const auto costs = [&](const std::size_t i) {
      return *cost(rows[i], demand.purpose, demand.time_step);
    };
    const auto keep_cheaper = [&](const std::size_t i, auto &kept) {
      if (!kept || costs(i) < costs(*kept))
        kept = i;
    };
    const auto keep_more_accurate = [&](const std::size_t i, auto &kept) {
      if (!kept || *rows[i].e_rms < *rows[*kept].e_rms)
        kept = i;
    };
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].e_rms && cost(rows[i], demand.purpose, demand.time_step))
        {
          const bool is_accurate = *rows[i].e_rms <= demand.accuracy;
          const bool is_affordable =
            demand.budget == 0. || costs(i) <= demand.budget;
          if (is_accurate && is_affordable)
            keep_cheaper(i, advice.chosen);
          if (is_accurate)
            keep_cheaper(i, advice.cheapest_accurate);
          if (is_affordable)
            keep_more_accurate(i, advice.most_accurate_affordable);
          keep_more_accurate(i, advice.most_accurate);
        }
    return advice;
  }
} // namespace springfit
