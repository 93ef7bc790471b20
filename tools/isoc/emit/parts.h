/* The parts of a plant's source, in the order in which they stand there. */
#ifndef ISOC_EMIT_PARTS_H
#define ISOC_EMIT_PARTS_H

#include "tools/isoc/emit/emit.h"

typedef struct emission {
    const plant *p;
    graph *g;
    const naming *names;
    text *out;
    const char *suffix;         /* of functions of a rung that drops effects; empty for those of the whole plant */
    bool in_step;               /* its functions are those that a step calls, which read what is held */
    double *out_of_range_value; /* gets a constant that leaves the range of real */
} emission;

/* put.c: adds formatted text to the source, as printf; the same under a condition; and the formatted text alone. In the
 * format stand $p for the prefix of names, $C for it in capitals, $s for the suffix. */
void put(const emission *e, const char *format, ...) __attribute__((format(printf, 2, 3)));
void put_if(const emission *e, bool wanted, const char *format, ...) __attribute__((format(printf, 3, 4)));
const char *form(const emission *e, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A number as C; and in a table, of numbers of this type, where it is one for all lanes: that, and a limit, of which
 * none is the largest real. */
const char *literal(const emission *e, double number);
const char *table_type(const emission *e);
const char *table_literal(const emission *e, double number);
const char *limit(const emission *e, double number);

/* As C: a mask of zeros. */
const char *no_bits(const emission *e);

/* features.c: whether the plant keeps values that a start or a restart sets: the method's history, samples of smooth
 * inputs, values that follow from tunables. */
bool is_primed(const plant *p);

/* Whether a discontinuity, of an input or of a parameter, makes that useless; and whether the latter can. */
bool can_restart(const plant *p);
bool watches_parameters(const plant *p);
bool watches_inputs(const mechanism *m);

/* Whether ticks are marked in which an input jumps by itself. */
bool watches_edges(const mechanism *m);

/* The nanoseconds of a step. */
long period_of(const plant *p);

/* The address of the progress of a step, as C; NULL, as C, where there is none. */
const char *progress_of(const mechanism *m);

/* The recipe as C: ISO_RK4 | ISO_CHECKED. */
const char *recipe_symbol(arena *memory, unsigned recipe);

/* Whether the plant needs the number of the row: for a memory, for an output that is due, or for a function of time
 * that a memory or an output reads. */
bool keeps_rows(const plant *p);

/* Whether it counts the rows one by one: for what is due, or for such a function. */
bool counts_rows(const plant *p);

/* Whether a row sets something besides the outputs. */
bool sets_rows(const plant *p);

/* Whether a memory does not begin with the zero of an empty plant. */
bool begins(const emission *e, const effect_quantity *q);

/* Whether the start sets an input, which stays so until a platform sets it. That of an FMU has it from the importer. */
bool has_value(const emission *e, int input);

/* Whether some start is more than a constant of the tables: then `begin` sets it. */
bool has_begin(const emission *e);

/* The last place in the ring of a delay, whose number of places is a power of two: a row is a place by its last bits.
 */
unsigned long last_of_ring(const effect_quantity *e);

/* Whether something is a function of time, that every tick sets. */
bool is_driven(const plant *p);

/* The size of u as C: the inputs, and the memories behind them. */
const char *held_size(const emission *e);

/* The number of these that can be samples of continuous signals. */
const char *sampled_size(const emission *e);

/* Whether one of these quantities has a limit; of states, for the guard. */
bool has_limits(const quantities *content);

/* Whether the corrections after a step depend on tunables, as masses or lengths of closures (OP_PARAMETER); or, in the
 * resistance with an implicit method, on inputs and memories (OP_INPUT). */
bool settles_by(const plant *p, const graph *g, operation array);

/* memory.c: the reals of x that the method has, as C. */
const char *method_state_size(const emission *e);

/* function.c: the emission of a reduced plant of its ladder; or of the whole plant where it is NULL. */
emission emission_of(const emission *e, const reduced_plant *left);

/* Targets: the places in an array of the values of these leaves, or its first `count` places. */
const char *const *places_in(const emission *e, const char *array, const leaf_name *leaves, int count);
const char *const *numbered(const emission *e, const char *array, int count);

/* Targets that are set to roots; whether these need a node of an operation; and the arrays of the plant's memory that a
 * function of it reads, all that there are where it asks for the derivative, which this function computes; their
 * declarations. */
code code_of(const emission *e, const char *const *targets, const node *roots, int count);
bool code_uses(const emission *e, const code *result, operation op);
void emit_arrays(const emission *e, const code *result, const char *derivative);
extern const char array_scope[];

/* The begin of a function of the memory: static void prime. */
void begin_function(const emission *e, const char *head);

/* statements.c: the statements of a function. Where they are many, they are calls of functions that this adds to the
 * source, so that the function itself comes after it. `scope` has the declarations of the variables that the statements
 * may name, as a list of parameters. */
const char *emit_statements(const emission *e, const char *function, const char *scope, const code *c);

/* (void)x; for the variables of the scope that the statements do not name. */
void emit_unread(const emission *e, const char *scope, const char *statements);

/* The whole of a function that has its parameters alone. */
void emit_function(const emission *e, const char *function, const char *parameters, const code *c);

/* Targets that are set each to its root, below a line of the scene or NULL: room for so many; one more; and as code. */
typedef struct assignments {
    const char **targets, **quotes;
    node *roots;
    int count;
} assignments;

assignments room_for(arena *memory, int count);
void assign(assignments *to, const char *target, const char *quote, node root);
code code_of_assignments(const emission *e, const assignments *all);

/* The derivatives of all states, with the scene's lines of their leaves and of the closures. */
code derivative_code(const emission *e);

/* The name of the array that a function reads for tunables: p, or h where values are held. */
const char *held_or_tunables(const emission *e);

/* The parameters of a function that fills `array` from x, u and p; `more` are further ones. The head of a function. */
const char *equation_parameters(const emission *e, const char *array, const char *more);
void emit_head(const emission *e, const char *function, const char *parameters);

/* static const uint16_t ARRAY[COUNT] = {CART_X_RAIL, ...}; */
void emit_states(const emission *e, const char *array, const int *states, int count);

/* emit.c: the files of core that have the functions which the rest of the source calls, each once. */
void emit_calls_included(const text *rest, text *out);

/* --- the parts --- */

/* memory.c: the struct of all that the plant keeps; and that the compiler put nothing between its members. */
void emit_memory(const emission *e);
void emit_memory_check(const emission *e);

/* The offset in it of its array of reals x, u, p or y, in bytes. */
size_t memory_place(const emission *e, char array);

/* As C: the bytes of the memory that are rows, with a word of each lane. */
const char *lane_bytes(const emission *e);

/* data.c: the constant tables. */
void emit_data(emission *e);

/* static const iso_limits ARRAY[CART_WHAT] = {[PLACE] = {LEAST, MOST}, ...}; nothing where none has any. */
void emit_limits(emission *e, const char *array, const char *what, const quantities *content);

/* data.c: the tables of the functions of the tick that these roots need. */
void emit_tick_tables(emission *e, const node *roots, size_t count);

/* functions.c: the equations. */
void emit_functions(emission *e);

/* rows.c: the assignments of a row: functions of time, at the begin of a tick and for the outputs of its end; memories;
 * shares, at the begin of a step; and the starts. */
void emit_drive(emission *e);
void emit_advance(emission *e);
void emit_shares(emission *e);
void emit_begin(emission *e);

/* due.c: the periods of rates; as C, whether the row is one of a rate; a statement, under that condition where the rate
 * is slow; and the number of the row, with that in each period: the next one, or this. */
typedef LIST_OF(double) period_list;

period_list periods_of(const emission *e);
const char *due_condition(const emission *e, row_rate rate);
void put_when_due(const emission *e, row_rate rate, const char *statement);
void emit_next_row(const emission *e);
void emit_row(const emission *e, const char *indent, const char *row);

/* settle.c: the corrections after the method in a step. */
void emit_settle(emission *e);

/* outputs.c: the outputs. */
void emit_output(emission *e);

/* sines.c: the derivative in a step, which may be given the sines and cosines of angles; how it reads those, of each
 * state; the parameter by which it gets them, or nothing; the table of the angles, by its name, where they are not the
 * first states; and the call that finds them. */
void emit_derivative_function(emission *e, const char *function, code result);
const char *const *given_sines(const emission *e, const char *from);
const char *sines_parameter(const emission *e);
const char *angles_table(const emission *e);
void emit_angles(emission *e);
void emit_found_sines(const emission *e, const char *x, const char *sines);

/* The number of reals behind the states for the values that a step prepares, sines among them. */
int prepared_count(const emission *e);

/* prepared.c: the derivative in two functions, or one that reads prepared sines; the expressions by which the outputs
 * read prepared sines and cosines, or NULL; the call by which the end of a step, or a start, prepares the next one; and
 * the outputs with that. */
void emit_cut_derivative(emission *e);
void emit_derivative_at_sines(emission *e);
const char *const *prepared_turns(const emission *e);
void emit_preparing(const emission *e);
void emit_preparing_output(const emission *e);

/* events.c: the events; the call that arms them at a start; and that which finds them in a step behind its method,
 * where `before` has the states before it, and `read` is what the derivative reads for tunables. */
void emit_events(emission *e);
void emit_event_begin(const emission *e);
void emit_event_step(const emission *e, const char *recipe, const char *read);

/* step.c: the method. */
void emit_step(emission *e);

/* policies.c: the account of ticks that do not keep their time; nothing where the scene asks for none. */
void emit_policies(emission *e);

/* description.c: the model; and, for the program, its plant. */
void emit_model(emission *e);
void emit_plant(emission *e);

#endif
