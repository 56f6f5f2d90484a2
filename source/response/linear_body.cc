#include <springfit/response/linear_body.h>

#include <array>

namespace springfit
{
  namespace
  {
    template <int dim>
    void
    add_blocks(const Eigen::SparseMatrix<double> &matrix,
               TangentMatrix &tangent)
    {
      using Iterator = Eigen::SparseMatrix<double>::InnerIterator;
      for (Eigen::Index b = 0; b < matrix.cols() / dim; ++b)
        {
          // The columns of a node have their entries at the same rows.
          std::array<Iterator, dim> columns = [&]() {
            if constexpr (dim == 2)
              return std::array<Iterator, 2>{Iterator(matrix, 2 * b),
                                             Iterator(matrix, 2 * b + 1)};
            else
              return std::array<Iterator, 3>{Iterator(matrix, 3 * b),
                                             Iterator(matrix, 3 * b + 1),
                                             Iterator(matrix, 3 * b + 2)};
          }();
          while (columns[0])
            {
              const Eigen::Index a = columns[0].row() / dim;
              Eigen::Matrix<double, dim, dim> block;
              for (int d = 0; d < dim; ++d)
                for (int c = 0; c < dim; ++c, ++columns[d])
                  block(c, d) = columns[d].value();
              tangent.add(a, b, block);
            }
        }
    }

    class ConstantOperator : public TangentOperator
    {
    public:
      explicit ConstantOperator(const LinearBody &body) : body_(body)
      {}

      void
      linearise(const Eigen::MatrixXd &) override
      {}

      void
      add_product(const Eigen::MatrixXd &u,
                  Eigen::MatrixXd &product) const override
      {
        body_.add_tangent_product(u, u, product);
      }

    private:
      const LinearBody &body_;
    };
  } // namespace

  LinearBody::LinearBody(const ElasticBody &body,
                         const int dim,
                         const Eigen::Index n_nodes)
    : dim_(dim)
  {
    NodePattern pattern(n_nodes);
    body.add_to_pattern(pattern);
    TangentMatrix tangent(dim, pattern);
    body.add_tangent(Eigen::MatrixXd::Zero(dim, n_nodes), tangent);
    stiffness_ = tangent.matrix();
  }

  double
  LinearBody::energy(const Eigen::MatrixXd &displacement) const
  {
    const Eigen::VectorXd u = displacement.reshaped();
    return 0.5 * u.dot(stiffness_ * u);
  }

  void
  LinearBody::add_forces(const Eigen::MatrixXd &displacement,
                         Eigen::MatrixXd &forces) const
  {
    add_tangent_product(displacement, -displacement, forces);
  }

  void
  LinearBody::add_tangent_product(const Eigen::MatrixXd &,
                                  const Eigen::MatrixXd &u,
                                  Eigen::MatrixXd &product) const
  {
    Eigen::Map<Eigen::VectorXd>(product.data(), product.size()) +=
      stiffness_ * u.reshaped().matrix();
  }

  std::unique_ptr<TangentOperator>
  LinearBody::tangent_operator() const
  {
    return std::make_unique<ConstantOperator>(*this);
  }

  void
  LinearBody::add_tangent(const Eigen::MatrixXd &, TangentMatrix &tangent) const
  {
    if (dim_ == 2)
      add_blocks<2>(stiffness_, tangent);
    else
      add_blocks<3>(stiffness_, tangent);
  }

  void
  LinearBody::add_convex_tangent(const Eigen::MatrixXd &displacement,
                                 TangentMatrix &tangent) const
  {
    add_tangent(displacement, tangent);
  }

  void
  LinearBody::add_to_pattern(NodePattern &pattern) const
  {
    for (Eigen::Index b = 0; b < stiffness_.cols() / dim_; ++b)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness_,
                                                            dim_ * b);
           entry;
           ++entry)
        if (entry.row() % dim_ == 0)
          {
            const unsigned int pair[] = {static_cast<unsigned int>(entry.row() /
                                                                   dim_),
                                         static_cast<unsigned int>(b)};
            pattern.add_clique(pair, 2);
          }
  }

  bool
  LinearBody::has_constant_tangent() const
  {
    return true;
  }
} // namespace springfit
