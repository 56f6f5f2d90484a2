#ifndef springfit_motion_contact_section_h
#define springfit_motion_contact_section_h

#include <springfit/motion/contact.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace springfit
{
  /** The section "Contact": planes and spheres that push at nodes. */
  template <int dim>
  class Contact : public dealii::ParameterAcceptor
  {
  public:
    Contact();

    /**
     * All of them, without a stiffness where none is given. They throw
     * EntryError at a time at which a sphere's radius is negative, a plane has
     * no normal, or an expression no finite value.
     *
     * @throws EntryError when an entry cannot be understood.
     */
    std::vector<Obstacle>
    obstacles() const;

  private:
    std::string planes_;
    std::string spheres_;
    double stiffness_ = 0.;
  };
} // namespace springfit

#endif
