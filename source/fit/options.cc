#include <springfit/fit/options.h>

namespace springfit
{
  const WordTable<Engine> &
  engine_words()
  {
    static const WordTable<Engine> table = {{Engine::ipopt, "ipopt"},
                                            {Engine::barrier, "barrier"}};
    return table;
  }


  const WordTable<Norm> &
  norm_words()
  {
    static const WordTable<Norm> table = {{Norm::frobenius, "frobenius"},
                                          {Norm::spectral, "spectral"}};
    return table;
  }
} // namespace springfit
