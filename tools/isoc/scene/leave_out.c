/* --without 'NAME; ...' */
#include "tools/isoc/scene/parser.h"

#include <string.h>

#include "tools/isoc/scene/take.h"

/* Whether the effect whose name is the first `length` characters of a text is left out. */
static bool is_left_out(const scene *written, const char *called, size_t length)
{
    FOR_EACH (const effect_use, use, written->effects) {
        const char *other = use->name.text;
        if (other != NULL && strlen(other) == length && strncmp(other, called, length) == 0) {
            return use->left_out;
        }
    }
    return false;
}

/* EFFECT.NAME of an effect that is left out. */
static bool is_of_left_out(const scene *written, const char *called)
{
    const char *dot = called == NULL ? NULL : strrchr(called, '.');
    return dot != NULL && is_left_out(written, called, (size_t)(dot - called));
}

/* Whether a formula names something. */
static bool mentions(const formula *f, const char *called)
{
    bool is = f != NULL && f->kind == FORMULA_NAME && called != NULL && strcmp(f->name, called) == 0;
    for (size_t i = 0; f != NULL && i < f->count; i++) {
        is = is || mentions(f->parts[i], called);
    }
    return is;
}

/* Whether a formula reads an effect that is left out, itself or through signals. `depth`: signals on the way, which may
 * form a loop: that error is noted elsewhere. */
static bool is_lost(const scene *written, const formula *f, size_t depth)
{
    if (f == NULL || depth > written->signals.count) {
        return false;
    }
    bool is = f->kind == FORMULA_NAME && is_of_left_out(written, f->name);
    if (f->kind == FORMULA_OF && f->parts[0]->name != NULL) {
        is = is_left_out(written, f->parts[0]->name, strlen(f->parts[0]->name));
    }
    const int signal = f->kind == FORMULA_NAME ? INDEX_OF(written->signals, f->name) : -1;
    is = is || (signal >= 0 && is_lost(written, written->signals.all[signal].value, depth + 1));
    for (size_t i = 0; i < f->count && !is; i++) {
        is = is_lost(written, f->parts[i], depth);
    }
    return is;
}

bool scene_reads_left_out(const scene *written, const formula *f)
{
    return is_lost(written, f, 0);
}

/* Whether an effect, a signal or an output reads a name. */
static bool is_read(const scene *written, const char *called)
{
    bool is = false;
    FOR_EACH (const effect_use, use, written->effects) {
        for (size_t j = 0; j < use->operand_count && !use->left_out && use->outer < 0; j++) {
            is = is || mentions(use->operands[j].value, called) || mentions(use->operands[j].point, called);
        }
    }
    for (size_t i = 0; i < written->signals.count; i++) {
        is = is || (!written->signals.all[i].left_out && mentions(written->signals.all[i].value, called));
    }
    for (size_t i = 0; i < written->outputs.count; i++) {
        is = is || mentions(written->outputs.all[i].formula, called);
    }
    FOR_EACH (const quantity, q, written->events.modes) {
        is = is || mentions(q->value, called);
    }
    FOR_EACH (const when_statement, when, written->events.whens) {
        is = is || mentions(when->condition, called);
        FOR_EACH (const set_statement, set, when->sets) {
            is = is || mentions(set->value, called);
        }
    }
    return is;
}

/* Whether a joint or a force is driven by an input. */
static bool is_drive(const scene *written, const char *called)
{
    bool is = false;
    FOR_EACH (const joint, j, written->joints) {
        is = is || name_is(j->drive, called);
    }
    FOR_EACH (const body_force, f, written->forces) {
        is = is || name_is(f->drive, called);
    }
    return is;
}

/* Marks the effect that is named, with its parts. */
static void mark(parser *p, void *to)
{
    scene *written = to;
    if (p->next->kind != TOKEN_NAME) {
        parse_problem(p, "expected the name of an effect");
        return;
    }
    const int found = find_effect(p->s, written, (name){p->next->text, p->next->at});
    for (int i = 0; i < (int)written->effects.count && found >= 0; i++) {
        written->effects.all[i].left_out |= is_within_use(written, i, found);
    }
    p->next++;
}

/* A scene has at least one output: where all would go, one stays, with its value without the effects. */
static void leave_outputs(scene *written)
{
    size_t kept = 0;
    for (size_t i = 0; i < written->outputs.count; i++) {
        if (!is_lost(written, written->outputs.all[i].formula, 0)) {
            written->outputs.all[kept++] = written->outputs.all[i];
        }
    }
    written->outputs.count = kept == 0 && written->outputs.count > 0 ? 1 : kept;
}

/* Leaves out signals that read an absent effect and that nothing reads; then those that only these read. */
static void leave_signals(scene *written)
{
    bool found = true;
    while (found) {
        found = false;
        FOR_EACH (quantity, q, written->signals) {
            if (!q->left_out && is_lost(written, q->value, 0) && !is_read(written, q->name.text)) {
                q->left_out = found = true;
            }
        }
    }
}

static void leave_settings(scene *written)
{
    size_t kept = 0;
    for (size_t i = 0; i < written->settings.count; i++) {
        if (!is_of_left_out(written, written->settings.all[i].what.text)) {
            written->settings.all[kept++] = written->settings.all[i];
        }
    }
    written->settings.count = kept;
}

/* Inputs that had been read and are no longer; they go behind the others. */
static void leave_inputs(source *s, scene *written, const bool *was_read)
{
    const size_t count = written->inputs.count;
    quantity *left = arena_take(s->memory, count + 1, sizeof *left);
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        const quantity input = written->inputs.all[i];
        const bool stays = !was_read[i] || is_read(written, input.name.text) || is_drive(written, input.name.text);
        if (stays) {
            written->inputs.all[kept++] = input;
        } else {
            left[i - kept] = input;
        }
    }
    memcpy(written->inputs.all + kept, left, (count - kept) * sizeof *left);
    written->left_input_count = count - kept;
    written->inputs.count = kept;
}

void scene_leave_out(source *s, scene *written, const script *names)
{
    bool *was_read = arena_take(s->memory, written->inputs.count + 1, sizeof *was_read);
    for (size_t i = 0; i < written->inputs.count; i++) {
        was_read[i] = is_read(written, written->inputs.all[i].name.text);
    }
    parser p = parser_of_option(s, written, names, names);
    parse_items(&p, mark, written, "expected ; and a further effect");
    leave_outputs(written);
    leave_signals(written);
    leave_settings(written);
    leave_inputs(s, written, was_read);
}
