#include "tools/isoc/plant/plant.h"

/* The scene, in which the first drops of the ladder are done. */
static scene *scene_with_drops(const scene *written, const policies *how, int drops, arena *memory)
{
    scene *whole = list_copy(memory, written, 1, sizeof *written);
    whole->effects.all = list_copy(memory, written->effects.all, written->effects.count, sizeof *written->effects.all);
    for (int i = 0; i < drops; i++) {
        whole->effects.all[how->drops[i]].dropped = true;
    }
    return whole;
}

static reduced_plant build(source *s, const scene *written, const plant *p, build_options wanted, int drops)
{
    arena *memory = s->memory;
    const policies *how = &p->m->policies;
    mechanism *m = arena_take(memory, 1, sizeof *m);
    plant *without = arena_take(memory, 1, sizeof *without);
    reduced_plant result = {.p = without, .g = arena_take(memory, 1, sizeof *result.g)};
    graph_start(result.g, memory, "Constants of the scene");
    *m = mechanism_build(s, result.g, scene_with_drops(written, how, drops, memory), p->is_double, p->m);
    assemble(s, result.g, m);
    point_queries_resolve(result.g, m);
    *without = plant_build(result.g, m, p->is_double, wanted);
    rows_build(s, result.g, without, p);
    result.suffix = "_without";
    for (int i = 0; i < drops; i++) {
        result.suffix = arena_format(memory, "%s_%s", result.suffix, m->effects.names[how->drops[i]].text);
    }
    return result;
}

void reduced_plants_build(source *s, const scene *written, plant *p, build_options wanted)
{
    p->reduced_plant_count = p->m->policies.drop_count;
    p->reduced_plants = arena_take(s->memory, (size_t)p->reduced_plant_count + 1, sizeof *p->reduced_plants);
    for (int i = 0; i < p->reduced_plant_count; i++) {
        p->reduced_plants[i] = build(s, written, p, wanted, i + 1);
    }
}

const reduced_plant *reduced_plant_on_rung(const plant *p, int rung)
{
    const int dropped = p->m->policies.dropped[rung];
    return dropped > 0 ? &p->reduced_plants[dropped - 1] : NULL;
}

unsigned rung_recipe(const plant *p, int rung)
{
    return p->m->policies.rungs[rung] | (p->m->method.recipe & ~(unsigned)ISO_METHOD_BITS);
}

/* The method is in the name where it is not that of the scene, and where the rung is there for it: so no two rungs are
 * called alike. */
const char *rung_suffix(const plant *p, int rung, arena *memory)
{
    const policies *how = &p->m->policies;
    const unsigned method = how->rungs[rung];
    const reduced_plant *left = reduced_plant_on_rung(p, rung);
    const bool drops = how->dropped[rung] > (rung > 0 ? how->dropped[rung - 1] : 0);
    const char *called =
        drops && method == ISO_METHOD_OF(p->m->method.recipe) ? "" : arena_format(memory, "_%s", method_names[method]);
    return arena_format(memory, "%s%s", called, left == NULL ? "" : left->suffix);
}
