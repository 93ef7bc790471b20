/* The number of lines of each kind in the effects of a scene. */
#include "tools/isoc/effects/effects.h"
#include "tools/isoc/scene/names.h"

static int count_all(const scene *written, effect_line_kind line_kind)
{
    int count = 0;
    FOR_EACH (const effect_use, use, written->effects) {
        const effect_kind *kind = use->left_out ? NULL : find_effect_kind(written, use->kind);
        for (size_t i = 0; kind != NULL && i < kind->line_count; i++) {
            count += kind->lines[i].kind == line_kind ? kind->lines[i].parts : 0;
        }
    }
    return count;
}

/* An output of the loss of events asks for it. */
static bool asks_for_loss(const scene *written)
{
    bool any = false;
    FOR_EACH (const output, o, written->outputs) {
        any = any || (o->formula != NULL && o->formula->kind == FORMULA_NAME &&
                      quantity_of_nothing(o->formula->name) == QUANTITY_EVENT_LOSS);
    }
    return any;
}

void count_effects(builder *b)
{
    mechanism *m = &b->mechanism;
    arena *memory = b->s->memory;
    m->effects.first_state = m->position_count;
    m->effects.state_count = count_all(b->written, EFFECT_STATE) + (int)b->written->events.modes.count;
    m->events.loss_state = asks_for_loss(b->written) ? m->position_count + m->effects.state_count++ : -1;
    m->effects.memory_count = count_all(b->written, EFFECT_MEMORY);
    m->position_count += m->effects.state_count;
    m->effects.states = arena_take(memory, (size_t)m->effects.state_count + 1, sizeof *m->effects.states);
    b->memory_room = (size_t)m->effects.memory_count + 1;
    m->effects.memories = arena_take(memory, b->memory_room, sizeof *m->effects.memories);
    m->effects.efforts = zero_nodes(b->g, (size_t)m->dof_count + 1);
    m->effects.count = (int)b->written->effects.count;
    m->effects.names = arena_take(memory, b->written->effects.count + 1, sizeof *m->effects.names);
    m->effects.outer = arena_take(memory, b->written->effects.count + 1, sizeof *m->effects.outer);
    m->effects.accounts = arena_take(memory, b->written->effects.count + 1, sizeof *m->effects.accounts);
    for (int i = 0; i < m->effects.count; i++) {
        const node zero = constant(b->g, 0.0);
        m->effects.names[i] = (name){b->written->effects.all[i].name.text, b->written->effects.all[i].used_at};
        m->effects.outer[i] = b->written->effects.all[i].outer;
        m->effects.accounts[i] = (effect_account){.power = zero, .stored = zero, .loss = zero, .work = zero};
    }
}
