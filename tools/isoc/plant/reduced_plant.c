#include "tools/isoc/plant/plant.h"

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
