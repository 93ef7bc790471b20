/* What a plant computes at random points: rows of a word and numbers. PLANT is its plant.c, SETTLE and NEXTS are
 * the calls of its functions for the corrections and the next values of memories, where it has them. usage: values
 * POINTS SEED */
#include <stdio.h>
#include <stdlib.h>

#include PLANT

static uint64_t drawn;

/* From -1 to 1. */
static double draw(void)
{
    drawn = drawn * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(int64_t)drawn / 9223372036854775808.0;
}

static void show(const char *const word, const real *const all, const size_t count)
{
    printf("%s", word);
    for (size_t i = 0; i < count; i++) {
        printf(" %.17g", (double)all[i]);
    }
    printf("\n");
}

/* Each state and tunable beside its start, each input and memory beside what it is at the tick; what the tick sets, it
 * sets. */
static void place(const iso_plant *const p, const size_t held, const uint64_t tick)
{
    const iso_model *const model = p->model;
    for (size_t i = 0; i < model->states; i++) {
        p->x[i] += (real)(0.2 * draw() * (1.0 + (p->x[i] < 0 ? -p->x[i] : p->x[i])));
    }
    for (size_t i = 0; i < held; i++) {
        p->u[i] += (real)draw();
    }
    for (size_t i = 0; i < model->parameters; i++) {
        p->p[i] *= (real)(1.0 + 0.1 * draw());
    }
    if (model->drive != NULL) {
        model->drive(p->memory, tick);
    }
}

/* What a step keeps of a last stage that is where it ends; its derivative reads tunables, or what is held in a step. */
static const real *kept_at(const iso_plant *const p, const real *const held)
{
    static real sines[1000], dx[1000]; /* behind the sines what is kept */
    iso_find_sines(equations.angles, equations.angle_count, p->x, sines);
    equations.by_sines(dx, p->x, p->u, held, sines, sines + 2 * equations.angle_count);
    return sines;
}

int main(const int argc, char **const argv)
{
    static real u[1000], kept[1000], h[1000];
    const iso_plant *const p = &iso_the_plant;
    const iso_model *const model = p->model;
    const size_t held = (size_t)model->inputs + model->memories, points = argc > 1 ? strtoul(argv[1], NULL, 10) : 0;
    drawn = argc > 2 ? strtoull(argv[2], NULL, 10) : 0;
    for (size_t n = 0; n < points; n++) {
        const uint64_t tick = (uint64_t)(5000.0 + 4999.0 * draw());
        iso_plant_start(p);
        place(p, held, tick);
        printf("k %llu\n", (unsigned long long)tick);
        show("p", p->p, model->parameters);
        show("x", p->x, model->states);
        show("u", p->u, held);
        real dx[1000];
        iso_the_derivative(dx, p->x, p->u, p->p);
        show("der", dx, model->states);
        model->output(p->memory);
        show("y", p->y, model->outputs);
        memcpy(u, p->u, held * sizeof *u);
        NEXTS;
        show("next", p->u, held);
        memcpy(p->u, u, held * sizeof *u);
        memcpy(kept, p->x, model->states * sizeof *kept);
        SETTLE;
        show("corrected", p->x, model->states);
        (void)kept;
        (void)h;
        (void)kept_at;
    }
    return 0;
}
