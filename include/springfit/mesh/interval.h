#ifndef springfit_mesh_interval_h
#define springfit_mesh_interval_h

namespace springfit
{
  /** A part of an axis, in m. */
  struct Interval
  {
    double lowest  = 0.;
    double highest = 0.;

    double
    length() const
    {
      return highest - lowest;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &lowest &highest;
    }
  };
} // namespace springfit

#endif
