/* Shared by the files of effects: the uses of effects, and the values of the formulas in them.
 *
 * A formula is evaluated when its value is needed; so the lines of a definition may stand in any order, and a formula
 * that needs its own value is found.
 */
#ifndef ISOC_EFFECTS_EFFECTS_H
#define ISOC_EFFECTS_EFFECTS_H

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/method/growth.h"
#include "tools/isoc/method/impact.h"

enum { DEEPEST_EFFECT = 200, MOST_MEMORIES = 65535 /* and inputs, of a plant */ };

/* A line of a definition in one use of the effect. */
typedef struct bound_line {
    value value;
    progress progress;
    int segment; /* of a joint; -1: none */
    int body;    /* likewise; and its point */
    vector point;
    int index;     /* of a state, a memory or a fault: the first among all of its sort */
    row_rate rate; /* of the rows in which it is computed; every 0: not known yet */
    value held;    /* of a slow let or output: the memories that all others read; count 0: none yet */
} bound_line;

/* One effect of the scene. */
typedef struct instance {
    const effect_use *use;
    const struct instance *outer; /* that has it as a part; NULL: the scene */
    name shown;                   /* in messages: its name, and where the scene uses it */
    const effect_kind *kind;      /* NULL: there is none */
    bound_line *bound;            /* [lines] */
    effect_account *account;      /* when all its lines are done */
} instance;

/* A call of a function of a definition that is being evaluated, in another one or in none. */
typedef struct call_frame {
    const effect_line *function;
    value arguments[MOST_ARGUMENTS];
    const struct call_frame *outer;
} call_frame;

/* All effects of the scene. `within` is the instance whose lines are being evaluated, NULL in formulas of the scene. */
typedef struct effect_scope {
    builder *b;
    instance *all;
    value *signals;
    progress *signal_progress;
    value *held_signals; /* of a rate: the memories that all others read; count 0: none yet */
    int first_mode;      /* of the scene, among the states of effects; behind those of all effects */
    bool *is_mode_known;
    const instance *within;
    row_rate rate;                    /* of the formula that is being evaluated */
    const call_frame *frame;          /* whose arguments it sees; NULL: it is that of no function */
    const char *path[DEEPEST_EFFECT]; /* the names that are being evaluated, each for the one before */
    int depth;
    bool is_done;            /* with all lines; outputs are built next */
    stability_limits limits; /* of the method; a rate of 0 before a formula names one */
    impact_limits impact;    /* likewise; a frequency of 0 */
} effect_scope;

/* --- history_memory.c: previous(x) and the like --- */

value history_memory_value(void *context, const formula *f);

/* --- shares.c: share(A < B), pwm(duty, 1 ms) --- */

/* The steps in the period of a pwm; 0 of a share, and after noting a problem. And the value of a call in an effect. */
double share_ticks(effect_scope *w, const formula *f);
value share_value(effect_scope *w, const instance *in, const formula *f);

/* --- time_inputs.c: noise(SEED), time and other functions of it --- */

value time_input_value(void *context, const formula *f);

/* scope.c: the line that declares a name; or with `is_output` the one that shows it. NULL if there is none. */
const effect_line *line_called(const effect_kind *kind, const char *called, bool is_output);

/* The nearest name among the lines of these kinds. */
const char *suggestion(source *s, const effect_kind *kind, const char *typed, effect_line_kind from,
                       effect_line_kind to);

/* From here on names are those of an instance, or of the scene where it is NULL, and problems are of it. Returns the
 * scope before. */
const instance *enter(effect_scope *w, const instance *in);

/* The name of an effect of the scene that a part of the present instance has; of an effect of the scene its own. */
const char *whole_name(const effect_scope *w, const char *called);

/* The value of a formula that is called so. */
value evaluate(effect_scope *w, const instance *in, const formula *f, const char *called);

/* The segment that a word stands for: an operand of the instance, or a joint of the scene; -1 after noting a problem.
 */
int segment_of(effect_scope *w, name n);

/* A body as an operand of the instance, or of the scene, and its point. False: it is none. */
bool find_point(effect_scope *w, const char *called, int *which, vector *point);

/* Notes a formula that needs its own value, with the path to it. */
value refuse_loop(effect_scope *w, place at, const char *called);

/* rates.c: blocks of a rate. The rate of a block, whose formulas have the names of an instance or of the scene: each
 * row where there is no block, or after noting a problem. */
row_rate rate_of_block(effect_scope *w, const instance *in, const rate_block *block);

/* The rate at which an effect is used: of the block that it stands in, or else of what has it as a part. And that of a
 * line: of its block, or else of its effect. */
row_rate rate_of_use(effect_scope *w, const instance *in);
row_rate rate_of_line(effect_scope *w, const instance *in, const effect_line *line);

/* From here on formulas are of this rate. Returns the rate before. */
row_rate pace(effect_scope *w, row_rate rate);

/* What formulas of other rates read: memories that the rows of `rate` set to these numbers; kept in *held. `called` is
 * the name of them, `owner` what declares them, and `in` NULL or its effect. */
value held_value(effect_scope *w, const instance *in, const value *inner, row_rate rate, const char *called, name owner,
                 value *held);

/* limits.c: the value of a name that follows from step and method, in a formula of the instance. */
bool find_limit(effect_scope *w, const char *called, value *found);

/* Whether it follows from the method too: stable_rate, impact_frequency, ... */
bool is_limit(const char *called);

/* calls.c: the value of a call of a function of the present definition; and of a name that is an argument of the
 * function which is being evaluated. False: there is none. And notes what has a past or a number of its own in a
 * function. */
bool call_value(void *context, const formula *f, value *found);
bool find_argument(const effect_scope *w, const char *called, value *found);
bool refuse_in_function(const effect_scope *w, const formula *f);

/* A function has a name of its own. */
void check_function(effect_scope *w, const effect_line *line);

/* names_in_effects.c: the value of a name, as value.h asks for it. */
bool find_name(void *context, const formula *f, value *found);

/* The value of a signal of the scene. */
value signal_value(effect_scope *w, size_t i);

/* quantities.c: a quantity of a point of a body, as leaves. */
value point_query_of(effect_scope *w, quantity_kind kind, int which, vector point, bool in_body);

/* The value of `speed of NAME` and the like, as value.h asks for it. */
value quantity_value(void *context, const formula *f);

/* The value of `energy` and the like: false, where the word is of no such quantity. */
bool find_quantity(effect_scope *w, const formula *f, value *found);

/* lines.c: the value of an operand, a let, a state, a memory or an output. */
value line_value(effect_scope *w, const instance *in, const effect_line *line);

/* holds.c: the holds; and that whose mode this state is, or NULL. */
void build_holds(effect_scope *w);
const held_speed *hold_of_state(const mechanism *m, int state);

/* modes.c: the value of a mode of the scene; and a whole number, as the mode of this name is: rounded where it is no
 * constant. -1 after noting a problem. */
value mode_value(effect_scope *w, size_t i);
void build_loss(builder *b); /* the state that sums what events take */
node whole_node(effect_scope *w, place at, const char *called, const value *found);

/* actions.c: the last quantity among those that nodes need that is known only when all efforts are, or after the step;
 * QUANTITY_ROWS: there is none. */
quantity_kind late_quantity(effect_scope *w, const node *roots, size_t count);

/* Carries out a line: a rate, an effort, a force. */
void do_line(effect_scope *w, const instance *in, const effect_line *line);

/* Notes a state of a definition without a rate, and a memory without a next. */
void check_subjects(effect_scope *w, const instance *in);

/* quantities.c: the query of a formula that is one quantity and nothing else; its nodes need no leaves. An owner that
 * it has not is -1. False: it is another formula. */
bool find_shown(builder *b, const formula *f, query *q);

/* effects.c: the value of a formula over all that the scene has; a signal, say. */
value value_in_scene(builder *b, const formula *f);

/* describe.c: the operands, states, memories, faults and outputs of each trial of a definition, with their units. */
void describe_trials(builder *b, text *out);

/* --- the passes, which tools/isoc/pipeline.c calls in this order, and says what each does --- */

void count_effects(builder *b);    /* counts.c */
void find_time_inputs(builder *b); /* time_inputs.c */
void build_time_inputs(builder *b);
void build_effects(builder *b);           /* effects.c */
void build_events(builder *b);            /* events.c */
void build_substeps(builder *b);          /* substeps.c */
void build_outputs(builder *b);           /* outputs.c */
void finish_history_memories(builder *b); /* history_memory.c */
void drop_unread(builder *b);             /* unread.c */
void check_shares(builder *b);            /* shares.c */
void build_delays(builder *b);            /* delays.c */

#endif
