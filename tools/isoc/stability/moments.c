#include "tools/isoc/stability/stability.h"

#include <stdio.h>

void pace_check(source *s, const graph *g, const plant *p)
{
    const moment start = {"at the start", mechanism_start(p->m, s->memory), 0.0};
    if (!ISO_IS_VARYING(p->m->method.recipe)) {
        turns_check(s, g, p, &start);
    }
    sums_check(s, g, p, &start);
}

/* Reads `ticks N` and `state X...`, as many as there are. */
static bool read_end(const char *path, const mechanism *m, double *ticks, double *x)
{
    FILE *from = fopen(path, "r");
    bool good = from != NULL && fscanf(from, "ticks %lf state", ticks) == 1;
    for (int i = 0; i < state_count(m) && good; i++) {
        good = fscanf(from, "%lf", &x[i]) == 1;
    }
    if (from != NULL) {
        fclose(from);
    }
    return good;
}

bool ended_check(source *s, graph *g, const plant *p, const char *path)
{
    double *x = arena_take(s->memory, (size_t)state_count(p->m) + 1, sizeof *x);
    moment end = {"at the end of the run", x, 0.0};
    if (!read_end(path, p->m, &end.ticks, x)) {
        fprintf(stderr, "isoc: error: %s is no end of a run of %s\n", path, p->m->name);
        return false;
    }
    s->is_silent = false;
    if (!ISO_IS_VARYING(p->m->method.recipe)) {
        turns_check(s, g, p, &end);
    }
    sums_check(s, g, p, &end);
    energy_check(s, g, p, &end);
    return true;
}
