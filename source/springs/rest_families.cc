#include <springfit/springs/angle.h>
#include <springfit/springs/angles.h>
#include <springfit/springs/couplings.h>
#include <springfit/springs/lengths.h>
#include <springfit/springs/rest_families.h>
#include <springfit/springs/volume.h>
#include <springfit/springs/volumes.h>

#include <numeric>
#include <stdexcept>

namespace springfit
{
  namespace
  {
    double
    distance(const Eigen::MatrixXd &points, const NodePair &pair)
    {
      return (points.col(pair[1]) - points.col(pair[0])).norm();
    }

    template <int dim>
    double
    angle_of(const Eigen::MatrixXd &points, const NodeTriple &triple)
    {
      const auto [a, m, c] = triple;
      const Vector<dim> u  = points.col(a) - points.col(m);
      const Vector<dim> v  = points.col(c) - points.col(m);
      if (is_degenerate_angle<dim>(u, v))
        throw std::logic_error("an angle of a cell is straight or folded");
      return angle<dim>(u, v);
    }
  } // namespace

  Family
  lengths_at_rest(const Eigen::MatrixXd &points,
                  const std::vector<NodePair> &pairs,
                  const Eigen::Ref<const Eigen::VectorXd> &k,
                  const SpringLaw law)
  {
    Family family(lengths(points.rows(), law));
    for (std::size_t s = 0; s < pairs.size(); ++s)
      family.add({pairs[s].begin(), pairs[s].end()},
                 {{k[s]}, {distance(points, pairs[s])}});
    return family;
  }

  Family
  angles_at_rest(const Eigen::MatrixXd &points,
                 const std::vector<NodeTriple> &triples,
                 const Eigen::Ref<const Eigen::VectorXd> &k)
  {
    Family family(angles(points.rows()));
    for (std::size_t t = 0; t < triples.size(); ++t)
      family.add({triples[t].begin(), triples[t].end()},
                 {{k[t]},
                  {points.rows() == 2 ? angle_of<2>(points, triples[t])
                                      : angle_of<3>(points, triples[t])}});
    return family;
  }

  Family
  volume_at_rest(const Eigen::MatrixXd &points,
                 const CellKind kind,
                 const double k)
  {
    std::vector<unsigned int> nodes(points.cols());
    std::iota(nodes.begin(), nodes.end(), 0);
    Family family(volumes(kind));
    family.add(nodes, {{k}, {volume(points, kind)}});
    return family;
  }

  Family
  couplings_at_rest(const Eigen::MatrixXd &points,
                    const std::vector<NodePair> &pairs,
                    const std::vector<LengthCoupling> &all,
                    const SpringLaw law)
  {
    Family family(couplings(points.rows(), law));
    for (const auto &[a, b, stiffness] : all)
      family.add({pairs[a][0], pairs[a][1], pairs[b][0], pairs[b][1]},
                 {{stiffness},
                  {distance(points, pairs[a])},
                  {distance(points, pairs[b])}});
    return family;
  }
} // namespace springfit
