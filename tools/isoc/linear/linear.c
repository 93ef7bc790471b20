#include "tools/isoc/linear/linear.h"

#include <stdio.h>
#include <string.h>

/* Reads `word count number...`; the count must be that of the plant. */
static bool read_numbers(FILE *from, const char *word, int count, double *to)
{
    char found[8];
    int size = -1;
    bool good = fscanf(from, "%7s %d", found, &size) == 2 && strcmp(found, word) == 0 && size == count;
    for (int i = 0; i < count && good; i++) {
        good = fscanf(from, "%lf", &to[i]) == 1;
    }
    return good;
}

/* The point of a file: states, inputs with memories, tunables. */
static bool read_point(const char *path, const mechanism *m, const point *to)
{
    FILE *from = fopen(path, "r");
    const bool good = from != NULL && read_numbers(from, "x", state_count(m), to->x) &&
                      read_numbers(from, "u", held_count(m), to->u) &&
                      read_numbers(from, "p", m->parameters.count, to->p);
    if (!good) {
        fprintf(stderr, "isoc: error: %s is no state of %s\n", path, m->name);
    }
    if (from != NULL) {
        fclose(from);
    }
    return good;
}

bool linear_run(source *s, graph *g, const scene *written, const plant *p, const linear_request *r)
{
    const mechanism *m = p->m;
    point at = {mechanism_start(m, s->memory), inputs_at_start(g, m),
                list_copy(s->memory, m->parameters.at_start, (size_t)m->parameters.count, sizeof *at.p)};
    if (r->state != NULL && !read_point(r->state, m, &at)) {
        return false;
    }
    trim_conditions w = {0};
    if (r->trim != NULL) {
        w = trim_conditions_read(s, g, written, p, source_add(s, "TRIM", r->trim));
        if (s->problem_count > 0) {
            return source_report(s);
        }
    }
    const expansion e = expand(g, p, p->derivatives, true);
    if (r->trim != NULL && !trim(s, &e, written, &w, &at)) {
        return source_report(s);
    }
    const linear_model l = model_at(&e, written, at);
    if (l.not_finite != NULL) {
        source_problem(s, m->segments[0].at, "no linear model: %s has no finite slope at this point", l.not_finite);
        return source_report(s);
    }
    return linear_write(s, g, p, &l, r);
}
