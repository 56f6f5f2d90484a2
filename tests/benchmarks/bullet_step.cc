// The pulled cube (pulled_cube.h) by Bullet's deformable bodies: all springs of
// one stiffness, implicit Euler with one step of Newton's method, conjugate
// gradients to the same relative residual, nothing to collide with.
//
//   bullet_step n n_steps     prints: bullet n n_steps, the median of
//                             milliseconds of CPU time per step, the last
//                             displacement of the loaded face in m

#include <springfit/springs/network.h>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "pulled_cube.h"

using namespace springfit;

namespace
{
  static_assert(sizeof(btScalar) == sizeof(double), "not in double precision");

  /** Conjugate gradients that end at a relative residual of 1e-6. */
  class BodySolver : public btDeformableBodySolver
  {
  public:
    BodySolver()
    {
      m_cg.m_tolerance     = 1e-12; // of its square
      m_cg.m_maxIterations = 10000;
    }
  };

  /** The traction on the loaded face. */
  class Pull : public btDeformableLagrangianForce
  {
  public:
    explicit Pull(const pulled_cube::Cube &cube) : cube_(cube)
    {}

    double time = 0.;

    void
    addScaledForces(const btScalar scale, TVStack &force) override
    {
      const double traction = scale * pulled_cube::traction(time);
      for (int v = 0; v < cube_.face_share.size(); ++v)
        force[v][2] += traction * cube_.face_share[v];
    }

    void
    addScaledExplicitForce(const btScalar scale, TVStack &force) override
    {
      addScaledForces(scale, force);
    }

    void
    addScaledDampingForce(btScalar, TVStack &) override
    {}

    void
    addScaledElasticForceDifferential(btScalar,
                                      const TVStack &,
                                      TVStack &) override
    {}

    void
    addScaledDampingForceDifferential(btScalar,
                                      const TVStack &,
                                      TVStack &) override
    {}

    void
    buildDampingForceDifferentialDiagonal(btScalar, TVStack &) override
    {}

    btDeformableLagrangianForceType
    getForceType() override
    {
      return BT_GRAVITY_FORCE;
    }

  private:
    const pulled_cube::Cube &cube_;
  };

  /** What a world consists of; without gravity. */
  struct World
  {
    World()
      : world(&dispatcher, &broadphase, &constraints, &configuration, &solver)
    {
      constraints.setDeformableSolver(&solver);
      world.setGravity({0., 0., 0.});
      world.getWorldInfo().m_gravity.setZero();
      world.setImplicit(true);
      world.setLineSearch(false);
      world.setUseProjection(true);
    }

    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    BodySolver solver;
    btDeformableMultiBodyConstraintSolver constraints;
    btDeformableMultiBodyDynamicsWorld world;
  };

  btSoftBody *
  make_body(const pulled_cube::Cube &cube, btSoftBodyWorldInfo &info)
  {
    btAlignedObjectArray<btVector3> places;
    btAlignedObjectArray<btScalar> masses;
    for (int v = 0; v < cube.network.nodes.cols(); ++v)
      {
        const Eigen::Vector3d x = cube.network.nodes.col(v);
        places.push_back({x[0], x[1], x[2]});
        masses.push_back(cube.held[3 * v] ? 0. : cube.network.mass[v]);
      }
    auto *body = new btSoftBody(&info, places.size(), &places[0], &masses[0]);
    const Family &springs = cube.network.families.front();
    for (std::size_t s = 0; s < springs.size(); ++s)
      body->appendLink(springs.nodes(s)[0], springs.nodes(s)[1]);
    body->m_cfg.collisions = 0;
    body->m_cfg.kDP        = 0.;
    body->setActivationState(DISABLE_DEACTIVATION);
    return body;
  }

  double
  face_displacement(const pulled_cube::Cube &cube, const btSoftBody &body)
  {
    Eigen::MatrixXd displacement = -cube.network.nodes;
    for (int v = 0; v < body.m_nodes.size(); ++v)
      for (int d = 0; d < 3; ++d)
        displacement(d, v) += body.m_nodes[v].m_x[d];
    return pulled_cube::face_displacement(cube, displacement);
  }
} // namespace

int
main(int argc, char *argv[])
{
  if (argc != 3)
    {
      std::fprintf(stderr, "Usage: bullet_step n n_steps\n");
      return 2;
    }
  const unsigned int n = std::atoi(argv[1]), n_steps = std::atoi(argv[2]);
  const auto cube = pulled_cube::make(n, pulled_cube::plain_springs);
  World all;
  btSoftBody *body = make_body(cube, all.world.getWorldInfo());
  all.world.addSoftBody(body);
  btDeformableMassSpringForce springs(pulled_cube::stiffness_of_peers(n), 0.);
  Pull pull(cube);
  all.world.addForce(body, &springs);
  all.world.addForce(body, &pull);

  std::vector<double> times;
  for (unsigned int i = 0; i < n_steps; ++i)
    {
      pull.time                = (i + 1) * pulled_cube::step;
      const std::clock_t begin = std::clock();
      all.world.stepSimulation(pulled_cube::step, 1, pulled_cube::step);
      times.push_back(1e3 * (std::clock() - begin) / CLOCKS_PER_SEC);
    }
  std::sort(times.begin() + 1, times.end());
  std::printf("bullet %u %u %.9g %.9g\n",
              n,
              n_steps,
              times[times.size() / 2],
              face_displacement(cube, *body));
  all.world.removeSoftBody(body);
  delete body;
}
