/* Runs a model of MuJoCo for some seconds of the machine with its own library, and prints its steps per second and the
 * library's version: with RK4, without contact, from the model's first keyframe if it has one. The library is not a
 * part of Isochron. */
#include <mujoco/mujoco.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static void run(const mjModel *m, mjData *d, const uint64_t steps)
{
    if (m->nkey > 0) {
        mj_resetDataKeyframe(m, d, 0);
    } else {
        mj_resetData(m, d);
    }
    for (uint64_t step = 0; step < steps; step++) {
        mj_step(m, d);
    }
}

int main(const int count, char **const arguments)
{
    enum { FEW = 1000 };
    char error[500] = "";
    const double seconds = count > 2 ? strtod(arguments[2], NULL) : 1.0;
    mjModel *const m = count > 1 ? mj_loadXML(arguments[1], NULL, error, sizeof error) : NULL;
    if (m == NULL) {
        (void)fprintf(stderr, "%s\n", error);
        return 1;
    }
    m->opt.integrator = mjINT_RK4;
    m->opt.disableflags |= mjDSBL_CONTACT;
    mjData *const d = mj_makeData(m);
    double took = 0.0;
    uint64_t steps = FEW;
    run(m, d, steps);
    while (took < seconds) {
        const clock_t begin = clock();
        steps *= 2;
        run(m, d, steps);
        took = (double)(clock() - begin) / CLOCKS_PER_SEC;
    }
    (void)printf("mujoco %.4g %s\n", (double)steps / took, mj_versionString());
    mj_deleteData(d);
    mj_deleteModel(m);
    return 0;
}
