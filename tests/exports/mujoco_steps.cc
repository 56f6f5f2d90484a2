// Steps an exported scene by MuJoCo: where a node is after each step, in m.
//
//     mujoco_steps SCENE.xml STEPS NODE

#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>

int
main(int argc, char *argv[])
{
  if (argc != 4)
    return 2;
  char error[1000] = "";
  mjModel *model   = mj_loadXML(argv[1], nullptr, error, sizeof(error));
  if (!model)
    {
      std::fprintf(stderr, "%s\n", error);
      return 1;
    }
  mjData *data   = mj_makeData(model);
  const int site = mj_name2id(model, mjOBJ_SITE, argv[3]);
  if (site < 0)
    return 2;
  for (int i = 0; i < std::atoi(argv[2]); ++i)
    {
      mj_step(model, data);
      // A step leaves the places where it began.
      mj_kinematics(model, data);
      const mjtNum *x = data->site_xpos + 3 * site;
      std::printf("%.17g %.17g %.17g %.17g\n", data->time, x[0], x[1], x[2]);
    }
  mj_deleteData(data);
  mj_deleteModel(model);
  return 0;
}
