/* Joints that turn without limit: what rounding takes from their angles is kept as a rest, so that an angle at a
 * constant speed is as exact after a day as after a second. In a closed loop of bodies the projection sets the angles
 * anew at the end of every step, from each other; nothing that rounding took before is worth keeping. A gear or a
 * motion acts along joints: it lets them turn steadily. */
#include "tools/isoc/plant/plant.h"

static bool is_set_anew(const settled *after, int position)
{
    for (int i = 0; i < after->count; i++) {
        if (after->states[i] == position) {
            return true;
        }
    }
    return false;
}

/* Marks the segments from one to the base of its loop. */
static void mark_side(const mechanism *m, int from, int base, bool *is_looped)
{
    for (int i = from; i != base; i = m->segments[i].parent) {
        is_looped[i] = true;
    }
}

rests rests_find(const graph *g, const mechanism *m, const settled *after)
{
    bool *is_looped = arena_take(g->memory, (size_t)m->segment_count + 1, sizeof *is_looped);
    FOR_ALL (const closure, c, m->closures, m->closure_count) {
        if (!acts_along_joints(c->kind)) {
            mark_side(m, c->parent.segment, c->base, is_looped);
            mark_side(m, c->child.segment, c->base, is_looped);
        }
    }
    rests result = {.kept = arena_take(g->memory, (size_t)m->segment_count + 1, sizeof *result.kept)};
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        result.kept[i] = l->continuous && !(is_looped[i] && is_set_anew(after, l->position));
        result.count += result.kept[i];
        result.turn_count += l->continuous;
    }
    return result;
}
