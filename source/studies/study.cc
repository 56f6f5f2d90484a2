#include <springfit/studies/study.h>

namespace springfit
{
  const WordTable<StudyKind> &
  study_words()
  {
    static const WordTable<StudyKind> table = {{StudyKind::calibrate,
                                                "calibrate"},
                                               {StudyKind::compare, "compare"}};
    return table;
  }

  template <int dim>
  void
  run_study(const StudyKind study, const Scene<dim> &scene, Session &session)
  {
    switch (study)
      {
        case StudyKind::calibrate:
          return calibrate(scene, session);
        case StudyKind::compare:
          return compare(scene, session);
      }
  }

  template void
  run_study<2>(StudyKind, const Scene<2> &, Session &);
  template void
  run_study<3>(StudyKind, const Scene<3> &, Session &);
} // namespace springfit
