#include "tools/isoc/plant/plant.h"

/* The least rate above another; 0 where there is none. */
static double next_rate(const plant *p, double above)
{
    double least = 0.0;
    for (int i = 0; i < p->outputs.count; i++) {
        const double every = p->outputs.shows[i]->every;
        least = every > above && (least == 0.0 || every < least) ? every : least;
    }
    return least;
}

output_rates output_rates_of(const plant *p, arena *memory)
{
    const size_t room = (size_t)p->outputs.count + 1;
    output_rates result = {.all = arena_take(memory, room, sizeof *result.all)};
    for (double every = next_rate(p, 0.0); every > 0.0; every = next_rate(p, every)) {
        output_rate *to = &result.all[result.count++];
        *to = (output_rate){.every = every,
                            .which = arena_take(memory, room, sizeof *to->which),
                            .roots = arena_take(memory, room, sizeof *to->roots)};
        for (int i = 0; i < p->outputs.count; i++) {
            if (!(p->outputs.shows[i]->every < every) && !(p->outputs.shows[i]->every > every)) {
                to->which[to->count] = i;
                to->roots[to->count++] = p->outputs.roots[i];
            }
        }
    }
    return result;
}

bool has_slow_outputs(const mechanism *m)
{
    bool any = false;
    for (size_t i = 0; i < m->output_count; i++) {
        any = any || m->outputs[i].every > 1.0;
    }
    return any;
}
