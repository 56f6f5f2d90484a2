#include <springfit/response/load_case.h>

#include <cstddef>

namespace springfit
{
  const WordTable<Load> &
  load_words()
  {
    static const WordTable<Load> table = {{Load::tension, "tension"},
                                          {Load::compression, "compression"},
                                          {Load::shear, "shear"},
                                          {Load::torsion, "torsion"}};
    return table;
  }

  NodalLoad
  load_of_forces(const Eigen::MatrixXd &forces)
  {
    return {forces, Eigen::MatrixXd::Zero(forces.rows(), forces.cols())};
  }

  std::vector<ForceOfSupport>
  forces_of_supports(const Loading &loading, const Eigen::MatrixXd &reactions)
  {
    const auto force_of = [&](const std::vector<bool> &held) {
      const Eigen::Index dim = reactions.rows();
      Eigen::VectorXd force  = Eigen::VectorXd::Zero(dim);
      for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i])
          force[i % dim] += reactions.reshaped()[i];
      return force;
    };
    std::vector<ForceOfSupport> forces;
    for (const auto &support : loading.supports)
      forces.push_back({support.name, force_of(support.held)});
    forces.push_back({"all", force_of(loading.held)});
    return forces;
  }
} // namespace springfit
