/* --without 'NAME; ...' */
#include "tools/isoc/scene/leave_out.h"

#include <string.h>

#include "tools/isoc/scene/take.h"

/* The effect of this name, the first `length` characters of a text; or NULL. */
static effect_use *effect_called(const scene *written, const char *called, size_t length)
{
    for (size_t i = 0; i < written->effect_count; i++) {
        const char *other = written->effects[i].name.text;
        if (other != NULL && strlen(other) == length && strncmp(other, called, length) == 0) {
            return &written->effects[i];
        }
    }
    return NULL;
}

/* EFFECT.WHAT of an effect that is left out. */
static bool is_of_left_out(const scene *written, const char *called)
{
    const char *dot = called == NULL ? NULL : strchr(called, '.');
    const effect_use *use = dot == NULL ? NULL : effect_called(written, called, (size_t)(dot - called));
    return use != NULL && use->left_out;
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
 * need each other in a loop that is an error for others to tell. */
static bool is_lost(const scene *written, const formula *f, size_t depth)
{
    if (f == NULL || depth > written->signal_count) {
        return false;
    }
    bool is = f->kind == FORMULA_NAME && is_of_left_out(written, f->name);
    if (f->kind == FORMULA_OF && f->parts[0]->name != NULL) {
        const effect_use *use = effect_called(written, f->parts[0]->name, strlen(f->parts[0]->name));
        is = use != NULL && use->left_out;
    }
    for (size_t i = 0; i < written->signal_count && f->kind == FORMULA_NAME && !is; i++) {
        const quantity *q = &written->signals[i];
        is = q->name.text != NULL && strcmp(q->name.text, f->name) == 0 && is_lost(written, q->value, depth + 1);
    }
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
    for (size_t i = 0; i < written->effect_count; i++) {
        const effect_use *use = &written->effects[i];
        for (size_t j = 0; j < use->operand_count && !use->left_out; j++) {
            is = is || mentions(use->operands[j].value, called) || mentions(use->operands[j].point, called);
        }
    }
    for (size_t i = 0; i < written->signal_count; i++) {
        is = is || (!written->signals[i].left_out && mentions(written->signals[i].value, called));
    }
    for (size_t i = 0; i < written->output_count; i++) {
        is = is || mentions(written->outputs[i].formula, called);
    }
    return is;
}

/* Whether a joint or a force is driven by an input. */
static bool is_drive(const scene *written, const char *called)
{
    bool is = false;
    for (size_t i = 0; i < written->joint_count && called != NULL; i++) {
        is = is || (written->joints[i].drive.text != NULL && strcmp(written->joints[i].drive.text, called) == 0);
    }
    for (size_t i = 0; i < written->force_count && called != NULL; i++) {
        is = is || (written->forces[i].drive.text != NULL && strcmp(written->forces[i].drive.text, called) == 0);
    }
    return is;
}

/* Marks the effects that are named. */
static void mark(source *s, scene *written, const script *of)
{
    parser p = {.s = s, .made = written};
    p.next = lex(s, of, source_passage(s, of, 0, of->length, NULL));
    const char **names = arena_take(s->memory, written->effect_count + 1, sizeof *names);
    for (size_t i = 0; i < written->effect_count; i++) {
        names[i] = written->effects[i].name.text == NULL ? "" : written->effects[i].name.text;
    }
    while (p.next->kind != TOKEN_END && !p.failed) {
        effect_use *use = effect_called(written, p.next->text, strlen(p.next->text));
        if (p.next->kind != TOKEN_NAME) {
            parse_problem(&p, "expected the name of an effect");
        } else if (use == NULL) {
            source_problem(s, p.next->at, "no effect is called '%s'%s", p.next->text,
                           source_suggestion(s, p.next->text, names, written->effect_count));
        } else {
            use->left_out = true;
        }
        p.next += !p.failed;
        if (!p.failed && p.next->kind != TOKEN_END && !take_sign(&p, ';')) {
            parse_problem(&p, "expected ; and a further effect");
        }
    }
}

/* As a scene has an output, one stays where all would go, and shows what it does without the effects. */
static void leave_outputs(scene *written)
{
    const output first = written->output_count > 0 ? written->outputs[0] : (output){0};
    size_t kept = 0;
    for (size_t i = 0; i < written->output_count; i++) {
        if (!is_lost(written, written->outputs[i].formula, 0)) {
            written->outputs[kept++] = written->outputs[i];
        }
    }
    if (kept == 0 && written->output_count > 0) {
        written->outputs[kept++] = first;
    }
    written->output_count = kept;
}

/* Signals that read what is not there and that nothing reads; and then those that only these read. */
static void leave_signals(scene *written)
{
    bool found = true;
    while (found) {
        found = false;
        for (size_t i = 0; i < written->signal_count; i++) {
            quantity *q = &written->signals[i];
            if (!q->left_out && is_lost(written, q->value, 0) && !is_read(written, q->name.text)) {
                q->left_out = true;
                found = true;
            }
        }
    }
}

static void leave_settings(scene *written)
{
    size_t kept = 0;
    for (size_t i = 0; i < written->setting_count; i++) {
        if (!is_of_left_out(written, written->settings[i].what.text)) {
            written->settings[kept++] = written->settings[i];
        }
    }
    written->setting_count = kept;
}

/* Inputs that had been read and are no longer; they go behind the others. */
static void leave_inputs(source *s, scene *written, const bool *was_read)
{
    quantity *sorted = arena_take(s->memory, written->input_count + 1, sizeof *sorted);
    size_t kept = 0, left = written->input_count;
    for (size_t i = written->input_count; i-- > 0;) {
        const char *called = written->inputs[i].name.text;
        if (was_read[i] && !is_read(written, called) && !is_drive(written, called)) {
            sorted[--left] = written->inputs[i];
        }
    }
    for (size_t i = 0; i < written->input_count; i++) {
        const char *called = written->inputs[i].name.text;
        if (!was_read[i] || is_read(written, called) || is_drive(written, called)) {
            sorted[kept++] = written->inputs[i];
        }
    }
    written->inputs = sorted;
    written->left_input_count = written->input_count - kept;
    written->input_count = kept;
}

void scene_leave_out(source *s, scene *written, const script *of)
{
    bool *was_read = arena_take(s->memory, written->input_count + 1, sizeof *was_read);
    for (size_t i = 0; i < written->input_count; i++) {
        was_read[i] = is_read(written, written->inputs[i].name.text);
    }
    mark(s, written, of);
    leave_outputs(written);
    leave_signals(written);
    leave_settings(written);
    leave_inputs(s, written, was_read);
}
