#include "tools/isoc/emit/emit.h"

#include "tools/isoc/plant/cost.h"

#include <ctype.h>
#include <string.h>

static const char *upper(arena *memory, const char *word)
{
    char *copy = arena_copy(memory, word, strlen(word));
    for (char *c = copy; *c != '\0'; c++) {
        *c = (char)toupper((unsigned char)*c);
    }
    return copy;
}

/* Whether the method keeps something that must be filled before the first step. */
static bool is_primed(const mechanism *m)
{
    return ISO_IS_PRIMED(m->recipe);
}

/* Whether the method keeps a history that a jump of an input or a change of a parameter makes useless. */
static bool can_jump(const mechanism *m)
{
    bool jumps = m->parameter_count > 0;
    for (int i = 0; i < m->input_count; i++) {
        jumps = jumps || m->jumps[i] > 0.0;
    }
    return jumps && is_primed(m);
}

/* The recipe as C: ISO_RK4 | ISO_CHECKED. */
static const char *recipe_symbol(arena *memory, unsigned recipe)
{
    const char *options = ISO_IS_COMPENSATED(recipe) ? " | ISO_COMPENSATED" : "";
    options = arena_format(memory, "%s%s", options, ISO_IS_CHECKED(recipe) ? " | ISO_CHECKED" : "");
    if (recipe >> 8 != 0) {
        options = arena_format(memory, "%s | ISO_ITERATIONS(%u)", options, recipe >> 8);
    }
    return arena_format(memory, "ISO_%s%s", upper(memory, method_names[ISO_METHOD_OF(recipe)]), options);
}

static const char *prefixed(arena *memory, const char *prefix, const char *word)
{
    return arena_format(memory, "%s%s", prefix, word);
}

/* What each state is called: a position by its link, a speed by its degree of freedom. */
static const char *const *state_words(const mechanism *m, arena *memory)
{
    static const char *const endings[] = {"_w", "_x", "_y", "_z"};
    const char **words = arena_take(memory, (size_t)state_count(m), sizeof *words);
    for (int i = 0; i < m->link_count; i++) {
        const link *l = &m->links[i];
        for (int n = 0; n < positions_of(l->kind); n++) {
            const bool is_ball = l->kind == JOINT_SPHERICAL;
            words[l->position + n] = arena_format(memory, "%s%s", l->name, is_ball ? endings[n] : "");
        }
    }
    for (int i = 0; i < m->clocks.count; i++) {
        words[m->clocks.first + i] = arena_format(memory, "clock_%d", i + 1);
    }
    for (int f = 0; f < m->dof_count; f++) {
        words[m->position_count + f] = m->dofs[f].name;
    }
    return words;
}

/* q_JOINT and qd_JOINT, u_INPUT, p_PARAMETER. */
static leaf_names names_of(const plant *p, arena *memory)
{
    const mechanism *m = p->m;
    const char *const *symbols = state_words(m, memory);
    const char **states = arena_take(memory, (size_t)state_count(m), sizeof *states);
    const char **inputs = arena_take(memory, (size_t)m->input_count + 1, sizeof *inputs);
    const char **parameters = arena_take(memory, (size_t)m->parameter_count + 1, sizeof *parameters);
    for (int i = 0; i < state_count(m); i++) {
        states[i] = prefixed(memory, i < m->position_count ? "q_" : "qd_", symbols[i]);
    }
    for (int i = 0; i < m->input_count; i++) {
        inputs[i] = prefixed(memory, "u_", m->input_names[i]);
    }
    for (int i = 0; i < m->parameter_count; i++) {
        parameters[i] = prefixed(memory, "p_", m->parameter_names[i]);
    }
    return (leaf_names){states, inputs, parameters};
}

static void emit_enum(text *out, const char *letter, const char *const *names, int count, const char *total)
{
    text_add(out, "enum {\n");
    for (int i = 0; i < count; i++) {
        text_add(out, "    PLANT_%s_%s,\n", letter, upper(out->memory, names[i]));
    }
    text_add(out, "    %s\n};\n\n", total);
}

/* JOINT and JOINT_SPEED. */
static const char *const *state_symbols(const mechanism *m, arena *memory)
{
    const char *const *words = state_words(m, memory);
    const char **states = arena_take(memory, (size_t)state_count(m), sizeof *states);
    for (int i = 0; i < state_count(m); i++) {
        states[i] = i < m->position_count ? words[i] : arena_format(memory, "%s_SPEED", words[i]);
    }
    return states;
}

bool emit_header(const plant *p, text *out)
{
    const mechanism *m = p->m;
    const char *const *states = state_symbols(m, out->memory);
    text_add(out, "/* %s: what stands where in the arrays of its plant. Made by isoc from %s.scene. */\n", m->name,
             m->name);
    text_add(out, "#ifndef PLANT_H\n#define PLANT_H\n\n#include \"core/runtime/plant.h\"\n\n");
    text_add(out, "_Static_assert(sizeof(real) == %d, \"this plant was made with isoc --real %s\");\n\n",
             p->is_double ? 8 : 4, p->is_double ? "double" : "float");
    text_add(out, "/* States x: joint positions (rad, m; w x y z of a quaternion), %sthen their speeds. */\n",
             m->clocks.count > 0 ? "clocks of motions (rad, s), " : "");
    emit_enum(out, "X", states, state_count(m), "PLANT_STATES");
    if (m->input_count > 0) {
        text_add(out, "/* Inputs u: efforts (N, N*m). */\n");
        emit_enum(out, "U", m->input_names, m->input_count, "PLANT_INPUTS");
    }
    if (m->parameter_count > 0) {
        text_add(out, "/* Tunable parameters p, in SI units. */\n");
        emit_enum(out, "P", m->parameter_names, m->parameter_count, "PLANT_PARAMETERS");
    }
    text_add(out, "/* Outputs y, in SI units. */\n");
    emit_enum(out, "Y", p->output_names, p->output_count, "PLANT_OUTPUTS");
    text_add(out, "#endif\n");
    return true;
}

/* static const real ARRAY[SIZE] = {[PLANT_LETTER_NAME] = NUMBER, ...}; */
static void emit_array(const plant *p, text *out, const char *array, const char *size, const char *letter,
                       const char *const *names, const double *numbers, int count)
{
    text_add(out, "static const real %s[%s] = {\n", array, size);
    for (int i = 0; i < count; i++) {
        text_add(out, "    [PLANT_%s_%s] = %s,\n", letter, upper(out->memory, names[i]),
                 code_literal(out->memory, numbers[i], p->is_double));
    }
    text_add(out, "};\n\n");
}

/* Whether a link's position is an angle that is not kept within a turn, and whose sine is taken. */
static bool is_angle(const link *l)
{
    return l->kind == JOINT_REVOLUTE && !l->continuous;
}

static bool has_angles(const mechanism *m)
{
    bool any = false;
    for (int i = 0; i < m->link_count; i++) {
        any = any || is_angle(&m->links[i]);
    }
    return any;
}

/* How large each state may be, for the guard. */
static void emit_range(const plant *p, text *out)
{
    const mechanism *m = p->m;
    const char *const *symbols = state_symbols(m, out->memory);
    bool *angles = arena_take(out->memory, (size_t)state_count(m), sizeof *angles);
    for (int i = 0; i < m->link_count; i++) {
        angles[m->links[i].position] = is_angle(&m->links[i]);
    }
    text_add(out, "static const real range[PLANT_STATES] = {\n");
    for (int i = 0; i < state_count(m); i++) {
        text_add(out, "    [PLANT_X_%s] = %s,\n", upper(out->memory, symbols[i]),
                 angles[i] ? "ISO_ANGLE_RANGE" : "ISO_REAL_MAX");
    }
    text_add(out, "};\n\n");
}

static void emit_memory(const plant *p, text *out)
{
    const mechanism *m = p->m;
    text_add(out, "typedef struct plant_memory {\n    real x[ISO_METHOD_STATE(%s, PLANT_STATES)];\n",
             recipe_symbol(out->memory, m->recipe));
    if (m->input_count > 0) {
        text_add(out, "    real u[PLANT_INPUTS];\n");
    }
    if (m->parameter_count > 0) {
        text_add(out, "    real p[PLANT_PARAMETERS];\n");
    }
    text_add(out, "    real y[PLANT_OUTPUTS];\n");
    if (p->turn_count > 0) {
        text_add(out, "    int32_t turns[%d]; /* of the continuous joints */\n", p->turn_count);
    }
    if (ISO_HAS_PROGRESS(m->recipe)) {
        text_add(out, "    %s;\n", ISO_IS_VARYING(m->recipe) ? "iso_adams_state adams" : "iso_progress progress");
    }
    if (can_jump(m)) {
        text_add(out, "%s%s", m->input_count > 0 ? "    real last_u[PLANT_INPUTS];\n" : "",
                 m->parameter_count > 0 ? "    real last_p[PLANT_PARAMETERS];\n" : "");
    }
    text_add(out, "} plant_memory;\n\n");

    emit_array(p, out, "start", "PLANT_STATES", "X", state_symbols(m, out->memory), mechanism_start(m, out->memory),
               state_count(m));
    if (has_angles(m)) {
        emit_range(p, out);
    }
    if (m->parameter_count > 0) {
        emit_array(p, out, "defaults", "PLANT_PARAMETERS", "P", m->parameter_names, m->defaults, m->parameter_count);
    }
}

static const char *const *targets_of(arena *memory, const char *array, int count)
{
    const char **targets = arena_take(memory, (size_t)count, sizeof *targets);
    for (int i = 0; i < count; i++) {
        targets[i] = arena_format(memory, "%s[%d]", array, i);
    }
    return targets;
}

/* What the equations read, as arrays. */
static const struct {
    operation op;
    const char *name;
} arguments[] = {{OP_STATE, "x"}, {OP_INPUT, "u"}, {OP_PARAMETER, "p"}};

/* A function of plant.c that fills `array` from x, u and p with `count` roots; `more` is a further parameter. */
static bool emit_function(const plant *p, graph *g, text *out, const char *function, const char *array,
                          const char *more, const node *roots, int count, double *culprit)
{
    const code body_of = {
        g, names_of(p, out->memory), p->is_double, targets_of(out->memory, array, count), roots, (size_t)count};
    text_add(out, "static void %s(real *restrict const %s, const real *restrict const x,\n", function, array);
    text_add(out, "    const real *restrict const u, const real *restrict const p%s)\n{\n", more);
    for (int i = 0; i < 3; i++) {
        if (!uses_operation(g, roots, (size_t)count, arguments[i].op)) {
            text_add(out, "    (void)%s;\n", arguments[i].name);
        }
    }
    if (more[0] != '\0' && !uses_operation(g, roots, (size_t)count, OP_STEP)) {
        text_add(out, "    (void)hb;\n");
    }
    const bool good = code_emit(&body_of, out, culprit);
    text_add(out, "}\n\n");
    return good;
}

/* The arrays of a plant's memory, that `roots` are functions of; all of those that it has, for the derivative. */
static void emit_arrays(const plant *p, const graph *g, text *out, const node *roots, int count)
{
    const bool derives = uses_operation(g, roots, (size_t)count, OP_DERIVATIVE);
    const int sizes[] = {state_count(p->m), p->m->input_count, p->m->parameter_count};
    for (int i = 0; i < 3; i++) {
        if (uses_operation(g, roots, (size_t)count, arguments[i].op) || (derives && sizes[i] > 0)) {
            text_add(out, "    const real *const %s = memory->%s;\n", arguments[i].name, arguments[i].name);
        }
    }
    if (derives) {
        text_add(out, "    real dx[PLANT_STATES];\n    derivative(dx, x, %s, %s);\n", sizes[1] > 0 ? "u" : "NULL",
                 sizes[2] > 0 ? "p" : "NULL");
    }
}

/* The outputs of a plant. */
static bool emit_output(const plant *p, graph *g, text *out, double *culprit)
{
    const char *const *targets = targets_of(out->memory, "y", p->output_count);
    const code body_of = {g, names_of(p, out->memory), p->is_double, targets, p->outputs, (size_t)p->output_count};
    text_add(out, "static void output(void *const instance)\n{\n");
    text_add(out, "    plant_memory *const memory = instance;\n    real *const y = memory->y;\n");
    emit_arrays(p, g, out, p->outputs, p->output_count);
    const bool good = code_emit(&body_of, out, culprit);
    text_add(out, "}\n\n");
    return good;
}

/* How far off its closures a plant is. */
static bool emit_violation(const plant *p, graph *g, text *out, double *culprit)
{
    static const char *const targets[] = {"off"};
    const code body_of = {g, names_of(p, out->memory), p->is_double, targets, &p->violation, 1};
    text_add(out, "static real violation(const void *const instance)\n{\n");
    text_add(out, "    const plant_memory *const memory = instance;\n");
    emit_arrays(p, g, out, &p->violation, 1);
    text_add(out, "    real off;\n");
    const bool good = code_emit(&body_of, out, culprit);
    text_add(out, "    return off;\n}\n\n");
    return good;
}

/* What an implicit method solves with. */
static bool emit_solver(const plant *p, graph *g, text *out, double *culprit)
{
    const int n = state_count(p->m);
    const code body_of = {
        g, names_of(p, out->memory), p->is_double, targets_of(out->memory, "d", n), p->j.solution, (size_t)n};
    bool good = emit_function(p, g, out, "factor", "lu", ", const real hb", p->j.factors, p->j.factor_count, culprit);
    text_add(out, "static void solve(real *restrict const d, const real *restrict const lu)\n{\n");
    good = code_emit(&body_of, out, culprit) && good;
    text_add(out, "}\n\n");
    return good;
}

/* What a method that varies its step may do in a tick. */
static void emit_adams(const plant *p, text *out)
{
    const mechanism *m = p->m;
    const char *tolerance = code_literal(out->memory, m->tolerance, p->is_double);
    text_add(out, "static const iso_adams_options options = {\n    .tolerance_absolute = %s,\n", tolerance);
    text_add(out, "    .tolerance_relative = %s,\n    .budget = %.0f,\n", tolerance, m->substeps);
    text_add(out, "    .driven = %s,\n", m->input_count + m->parameter_count > 0 ? "true" : "false");
    text_add(out, "    .level_max = %s,\n};\n\n", m->substeps > 1024 ? "ISO_ADAMS_LEVELS" : "ISO_ADAMS_LEVEL_MAX");
}

/* The functions of the plant as a method takes them. */
static void emit_equations(const plant *p, text *out)
{
    if (ISO_IS_VARYING(p->m->recipe)) {
        emit_adams(p, out);
    }
    text_add(out, "static const iso_equations equations = {\n    .derivative = derivative,\n");
    if (ISO_IS_IMPLICIT(p->m->recipe)) {
        text_add(out, "    .factor = factor,\n    .solve = solve,\n    .factors = %d,\n", p->j.factor_count);
    }
    if (p->rate_count > 0) {
        text_add(out, "    .rates = rates,\n    .positions = %d,\n", p->rate_count);
    }
    text_add(out, "%s};\n\n", ISO_IS_VARYING(p->m->recipe) ? "    .adams = &options,\n" : "");
}

/* What a tick sets: inputs, then clocks. */
static size_t driven_count(const mechanism *m)
{
    return (size_t)(m->input_count + m->clocks.count);
}

static bool emit_drive(const plant *p, graph *g, text *out, double *culprit)
{
    const mechanism *m = p->m;
    const size_t count = driven_count(m);
    const char **targets = arena_take(out->memory, count, sizeof *targets);
    for (int i = 0; i < m->input_count; i++) {
        targets[i] = arena_format(out->memory, "memory->u[%d]", i);
    }
    for (int i = 0; i < m->clocks.count; i++) {
        targets[m->input_count + i] = arena_format(out->memory, "memory->x[%d]", m->clocks.first + i);
    }
    const code body_of = {g, names_of(p, out->memory), p->is_double, targets, m->drives, count};
    text_add(out, "/* What is a function of time; other inputs are zero until a port reads them. */\n");
    text_add(out, "static void drive(void *const instance, const uint32_t tick)\n{\n    plant_memory *const memory = "
                  "instance;\n");
    if (!uses_time(g, m->drives, count)) {
        text_add(out, "    (void)tick;\n");
    }
    if (uses_operation(g, m->drives, count, OP_PARAMETER)) {
        text_add(out, "    const real *const p = memory->p;\n");
    }
    const bool good = code_emit(&body_of, out, culprit);
    text_add(out, "}\n\n");
    return good;
}

static const char *array_or_null(int count, const char *array)
{
    return count > 0 ? array : "NULL";
}

/* What starts the method anew: an input that changed by more than its jump in a tick, a parameter that changed. */
static void emit_jumped(const plant *p, text *out)
{
    const mechanism *m = p->m;
    text_add(out, "static bool jumped(void *const instance)\n{\n    plant_memory *const memory = instance;\n    bool "
                  "jump = false;\n");
    for (int i = 0; i < m->input_count; i++) {
        if (m->jumps[i] > 0.0) {
            text_add(out, "    jump |= iso_abs(memory->u[%d] - memory->last_u[%d]) > %s;\n", i, i,
                     code_literal(out->memory, m->jumps[i], p->is_double));
        }
    }
    for (int i = 0; i < m->parameter_count; i++) {
        text_add(out, "    jump |= memory->p[%d] != memory->last_p[%d];\n", i, i);
    }
    text_add(out, "    remember(memory);\n    return jump;\n}\n\n");
}

/* The inputs and parameters that jumped() compares with. */
static void emit_remember(const plant *p, text *out)
{
    text_add(out, "static void remember(plant_memory *const memory)\n{\n");
    text_add(out, "%s", p->m->input_count > 0 ? "    memcpy(memory->last_u, memory->u, sizeof memory->last_u);\n" : "");
    text_add(out, "%s",
             p->m->parameter_count > 0 ? "    memcpy(memory->last_p, memory->p, sizeof memory->last_p);\n" : "");
    text_add(out, "}\n\n");
}

/* The call of iso_method_step or iso_method_prime, with what it works on. */
static void emit_call(const plant *p, text *out, const char *function, const char *size)
{
    const mechanism *m = p->m;
    const char *recipe = recipe_symbol(out->memory, m->recipe);
    const char *told = !ISO_HAS_PROGRESS(m->recipe) ? "NULL"
                       : ISO_IS_VARYING(m->recipe)  ? "&memory->adams.progress"
                                                    : "&memory->progress";
    text_add(out, "    real work[%s(%s, PLANT_STATES)];\n", size, recipe);
    if (ISO_IS_IMPLICIT(m->recipe)) {
        text_add(out, "    real lu[%d];\n", p->j.factor_count);
    }
    text_add(out, "    %s(%s, PLANT_STATES, &equations, %s, memory->x, %s, %s, %s, work,\n", function, recipe,
             code_literal(out->memory, m->step, p->is_double), array_or_null(m->input_count, "memory->u"),
             array_or_null(m->parameter_count, "memory->p"), ISO_IS_IMPLICIT(m->recipe) ? "lu" : "NULL");
    text_add(out, "                    %s);\n", told);
}

static void emit_prime(const plant *p, text *out)
{
    text_add(out, "static void prime(void *const instance)\n{\n    plant_memory *const memory = instance;\n");
    emit_call(p, out, "iso_method_prime", "ISO_METHOD_PRIME_WORK");
    text_add(out, "%s}\n\n", can_jump(p->m) ? "    remember(memory);\n" : "");
}

/* What is put right after a step, in place. */
static bool emit_settle(const plant *p, graph *g, text *out, double *culprit)
{
    const char **targets = arena_take(out->memory, (size_t)p->after.count + 1, sizeof *targets);
    for (int i = 0; i < p->after.count; i++) {
        targets[i] = arena_format(out->memory, "x[%d]", p->after.states[i]);
    }
    const code body_of = {g, names_of(p, out->memory), p->is_double, targets, p->after.values, (size_t)p->after.count};
    text_add(out, "static void settle(real *const x)\n{\n");
    const bool good = code_emit(&body_of, out, culprit);
    text_add(out, "}\n\n");
    return good;
}

/* Whether a step copies all that it calls into itself: up to so many operations in its evaluations, a sine and cosine
 * counted as 25, those of a sub-step that varies once. In float calls cost a fifth of a small plant's step on a Cortex-M4F and an eighth of a chain's of
 * three, in double on a PC less; of a large one's step little, whose copies take much text. */
static bool is_flat(const plant *p, const graph *g)
{
    enum { MOST_FLOAT = 600, MOST_DOUBLE = 400, OF_SINCOS = 25 };
    const int most = p->is_double ? MOST_DOUBLE : MOST_FLOAT;
    const operations n = count_operations(g, p->derivatives, (size_t)state_count(p->m));
    const int evaluations = ISO_IS_VARYING(p->m->recipe) ? 1 : ISO_EVALUATIONS_OF(p->m->recipe);
    return evaluations * (n.add + n.mul + n.div + OF_SINCOS * n.sincos) <= most;
}

static void emit_step(const plant *p, const graph *g, text *out)
{
    const mechanism *m = p->m;
    if (can_jump(m)) {
        emit_remember(p, out);
        emit_jumped(p, out);
    }
    if (is_primed(m)) {
        emit_prime(p, out);
    }
    text_add(out, "%sstatic void step(void *const instance)\n{\n    plant_memory *const memory = instance;\n",
             is_flat(p, g) ? "ISO_FLAT " : "");
    emit_call(p, out, "iso_method_step", "ISO_METHOD_WORK");
    if (m->projections > 1 && p->after.count > 0) {
        text_add(out, "    for (int i = 0; i < %d; i++) {\n        settle(memory->x);\n    }\n", m->projections);
    } else if (p->after.count > 0) {
        text_add(out, "    settle(memory->x);\n");
    }
    int counted = 0;
    for (int i = 0; i < m->link_count; i++) {
        if (m->links[i].continuous) {
            text_add(out, "    memory->turns[%d] += iso_take_turns(&memory->x[PLANT_X_%s]);\n", counted++,
                     upper(out->memory, m->links[i].name));
        }
    }
    text_add(out, "}\n\n");
}

/* A list of words, with commas between. A compiler need not take a string of more than 4095 characters: a longer list
 * is an array of characters, which stands before the struct that has it. */
static bool is_long(const char *const *words, int count)
{
    enum { LONGEST_STRING = 4095 };
    size_t length = 0;
    for (int i = 0; i < count; i++) {
        length += strlen(words[i]) + 1;
    }
    return length > LONGEST_STRING;
}

static void emit_long_list(text *out, const char *field, const char *const *words, int count)
{
    if (!is_long(words, count)) {
        return;
    }
    text_add(out, "static const char %s[] = {\n", field);
    for (int i = 0; i < count; i++) {
        text_add(out, "   ");
        for (const char *c = words[i]; *c != '\0'; c++) {
            text_add(out, " '%c',", *c);
        }
        text_add(out, i + 1 < count ? " ',',\n" : " 0,\n};\n\n");
    }
}

static void emit_list(text *out, const char *field, const char *const *words, int count)
{
    const bool is_array = is_long(words, count);
    text_add(out, "    .%s =%s", field, count == 0 ? " \"\"" : is_array ? " " : "");
    for (int i = 0; i < count && !is_array; i++) {
        text_add(out, "\n        \"%s%s\"", words[i], i + 1 < count ? "," : "");
    }
    text_add(out, "%s,\n", is_array ? field : "");
}

/* What all plants of the scene share. */
static void emit_model(const plant *p, text *out)
{
    const mechanism *m = p->m;
    const char *seconds = code_literal(out->memory, m->step, true); /* R(0.001) */
    emit_long_list(out, "output_names", p->output_names, p->output_count);
    emit_long_list(out, "output_units", p->output_units, p->output_count);
    text_add(out, "static const iso_model model = {\n");
    text_add(out, "    .name = \"%s\",\n    .method = \"%s\",\n", m->name, method_names[ISO_METHOD_OF(m->recipe)]);
    text_add(out, "    .step_text = \"%.*s\",\n    .step_size = %s,\n", (int)strlen(seconds) - 3, seconds + 2,
             code_literal(out->memory, m->step, p->is_double));
    text_add(out, "    .period_ns = UINT32_C(%.0f),\n    .states = PLANT_STATES,\n", m->step * 1e9);
    text_add(out, "%s", m->input_count > 0 ? "    .inputs = PLANT_INPUTS,\n" : "");
    text_add(out, "    .outputs = PLANT_OUTPUTS,\n");
    text_add(out, "%s", m->parameter_count > 0 ? "    .parameters = PLANT_PARAMETERS,\n" : "");
    emit_list(out, "output_names", p->output_names, p->output_count);
    emit_list(out, "output_units", p->output_units, p->output_count);
    text_add(out, "    .start = start,\n");
    text_add(out, "%s", m->parameter_count > 0 ? "    .defaults = defaults,\n" : "");
    text_add(out, "%s", has_angles(m) ? "    .range = range,\n" : "");
    text_add(out, "    .memory_bytes = sizeof(plant_memory),\n    .derivative = derivative,\n    .output = output,\n");
    if (p->violation >= 0) {
        text_add(out, "    .violation = violation,\n    .violation_limit = %s,\n",
                 code_literal(out->memory, m->violation_limit, p->is_double));
    }
    text_add(out, "%s", driven_count(m) > 0 ? "    .drive = drive,\n" : "");
    text_add(out, "%s", can_jump(m) ? "    .jumped = jumped,\n" : "");
    text_add(out, "%s    .step = step,\n};\n\n", is_primed(m) ? "    .prime = prime,\n" : "");
}

/* The plant of the program, and its memory. */
static void emit_plant(const plant *p, text *out)
{
    const mechanism *m = p->m;
    text_add(out, "static plant_memory memory%s;\n\n", ISO_IS_WATCHED(m->recipe) ? ", before" : "");
    text_add(out,
             "const iso_plant iso_the_plant = {\n    .model = &model,\n    .memory = &memory,\n    .x = memory.x,\n");
    text_add(out, "%s", m->input_count > 0 ? "    .u = memory.u,\n" : "");
    text_add(out, "%s", m->parameter_count > 0 ? "    .p = memory.p,\n" : "");
    text_add(out, "    .y = memory.y,\n");
    if (ISO_IS_VARYING(m->recipe)) {
        text_add(out, "    .progress = &memory.adams.progress,\n    .adams = &memory.adams,\n");
    } else if (ISO_HAS_PROGRESS(m->recipe)) {
        text_add(out, "    .progress = &memory.progress,\n");
    }
    text_add(out, "%s};\n", ISO_IS_WATCHED(m->recipe) ? "    .before = &before,\n" : "");
}

bool emit_source(const plant *p, graph *g, text *out, double *culprit)
{
    const mechanism *m = p->m;
    text_add(out, "/* %s: equations of motion of a tree of %d joint%s. Made by isoc from %s.scene.\n *\n", m->name,
             m->link_count, m->link_count == 1 ? "" : "s", m->name);
    text_add(out,
             " * M(q) q'' + bias(q, q') = effort, solved for q''; all in SI units.\n */\n#include \"plant.h\"\n\n");
    text_add(out, "#include \"core/methods/method.h\"\n%s#include \"core/numbers/sincos.h\"\n%s\n",
             uses_time(g, m->drives, driven_count(m)) ? "#include \"core/numbers/signal.h\"\n" : "",
             p->turn_count > 0 ? "#include \"core/numbers/turns.h\"\n" : "");
    emit_memory(p, out);
    bool good = emit_function(p, g, out, "derivative", "dx", "", p->derivatives, state_count(m), culprit);
    good = good && emit_output(p, g, out, culprit);
    good = good && (driven_count(m) == 0 || emit_drive(p, g, out, culprit));
    good = good && (!ISO_IS_IMPLICIT(m->recipe) || emit_solver(p, g, out, culprit));
    good = good &&
           (p->rate_count == 0 || emit_function(p, g, out, "rates", "dx", "", p->derivatives, p->rate_count, culprit));
    good = good && (p->after.count == 0 || emit_settle(p, g, out, culprit));
    good = good && (p->violation < 0 || emit_violation(p, g, out, culprit));
    emit_equations(p, out);
    emit_step(p, g, out);
    emit_model(p, out);
    emit_plant(p, out);
    return good;
}
