#include "tools/isoc/scales.h"

#include <float.h>
#include <math.h>
#include <string.h>

bool is_sum(const graph_node *n)
{
    return n->op == OP_ADD || n->op == OP_SUB;
}

bool is_product(const graph_node *n)
{
    return n->op == OP_MUL || n->op == OP_DIV;
}

bool is_one(double ratio)
{
    return fabs(ratio - 1.0) <= 16.0 * DBL_EPSILON;
}

int operands(const graph_node *n)
{
    return n->op < OP_ADD ? 0 : n->op <= OP_DIV ? 2 : 1;
}

node operand_at(const graph_node *n, int which)
{
    return which == 0 ? n->a : n->b;
}

/* --- multiples and uses --- */

static multiple multiple_of(const scales *s, node i)
{
    const graph_node *n = &s->g->nodes[i];
    const multiple a = operands(n) > 0 ? s->as[n->a] : (multiple){1.0, i};
    const multiple b = operands(n) > 1 ? s->as[n->b] : a;
    if (n->op == OP_CONSTANT) {
        return (multiple){n->value, i};
    }
    if (n->op == OP_NEG) {
        return (multiple){-a.times, a.of};
    }
    if (n->op == OP_MUL && is_constant(s->g, n->a)) {
        return (multiple){a.times * b.times, b.of};
    }
    return (multiple){n->op == OP_MUL ? a.times * b.times : n->op == OP_DIV ? a.times / b.times : 1.0, i};
}

static void add_use(scales *s, node of, node by, int which)
{
    const multiple as = s->as[of];
    if (!is_constant(s->g, of)) {
        s->uses = arena_grow(s->g->memory, s->uses, s->use_count, &s->use_room, sizeof *s->uses);
        s->uses[s->use_count] = (use){by, which, as.times, s->first[as.of]};
        s->first[as.of] = (int)s->use_count++;
    }
}

static void find_uses(scales *s, const node *roots, size_t count)
{
    const size_t n = s->g->count;
    for (size_t i = 0; i < n; i++) {
        s->first[i] = -1;
    }
    for (size_t i = 0; i < n; i++) {
        const graph_node *user = &s->g->nodes[i];
        if (s->needed[i]) {
            s->as[i] = multiple_of(s, (node)i);
            for (int k = 0; k < operands(user) && s->as[i].of == (node)i; k++) {
                add_use(s, operand_at(user, k), is_sum(user) || is_product(user) ? (node)i : WHOLE, k);
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        add_use(s, roots[i], WHOLE, 0);
    }
}

/* --- what scales cost --- */

double scale_taken(const scales *s, node p, int which)
{
    const node factor = operand_at(&s->g->nodes[p], which);
    const double at = s->taken[2 * p + which];
    return is_constant(s->g, factor) ? 1.0 : at > 0.0 ? at : s->scale[s->as[factor].of];
}

static double product_scale(const scales *s, node p)
{
    const double a = scale_taken(s, p, 0), b = scale_taken(s, p, 1);
    return s->g->nodes[p].op == OP_DIV ? a / b : a * b;
}

static bool is_in_product(const scales *s, const use *u)
{
    return u->by != WHOLE && is_product(&s->g->nodes[u->by]);
}

/* Whether a product takes a factor as it is. */
static bool follows(const scales *s, const use *u)
{
    return is_in_product(s, u) && s->taken[2 * u->by + u->which] == 0.0;
}

/* The scale at which a use would have a node at no cost. */
static double asked(const scales *s, const use *u)
{
    return is_in_product(s, u) ? scale_taken(s, u->by, u->which)
                               : (u->by == WHOLE ? 1.0 : s->scale[u->by]) / fabs(u->times);
}

/* Multiplications of a node by constants: one for all uses that ask for the same. */
static int price(const scales *s, node i)
{
    int sum = 0;
    for (int at = s->first[i]; at >= 0; at = s->uses[at].next) {
        const double wanted = asked(s, &s->uses[at]);
        bool known = follows(s, &s->uses[at]) || is_one(wanted / s->scale[i]);
        for (int before = s->first[i]; before != at && !known; before = s->uses[before].next) {
            known = !follows(s, &s->uses[before]) && is_one(wanted / asked(s, &s->uses[before]));
        }
        sum += !known;
    }
    return sum;
}

static int price_of_touched(const scales *s)
{
    int sum = 0;
    for (size_t i = 0; i < s->touched_count; i++) {
        sum += price(s, s->touched[i]);
    }
    return sum;
}

static void touch(scales *s, node i)
{
    if (s->mark[i] != s->marks) {
        s->mark[i] = s->marks;
        s->touched[s->touched_count++] = i;
    }
}

static void touch_none(scales *s)
{
    s->marks++;
    s->touched_count = 0;
}

/* Gives a node its scale, and the products that take it as it is theirs. */
static void set_scale(scales *s, node i, double scale)
{
    s->scale[i] = scale;
    touch(s, i);
    for (int at = s->first[i]; at >= 0; at = s->uses[at].next) {
        const use *u = &s->uses[at];
        if (follows(s, u)) {
            set_scale(s, u->by, product_scale(s, u->by));
        }
    }
}

/* --- the search --- */

/* What a change may touch, and what may take a factor: a node of which more depends stays as it is, so that the search
 * takes a time in proportion to the graph. */
enum { MOST_TOUCHED = 24, MOST_TAKERS = 24 };

/* Touches a node and the products that take it as it is; false if they are too many. */
static bool touch_all(scales *s, node i)
{
    touch(s, i);
    bool few = s->touched_count <= MOST_TOUCHED;
    for (int at = s->first[i]; at >= 0 && few; at = s->uses[at].next) {
        const use *u = &s->uses[at];
        few = !follows(s, u) || s->mark[u->by] == s->marks || touch_all(s, u->by);
    }
    return few;
}

/* What a change has touched, and what is beside it, is to be tried again. */
static void wake(scales *s)
{
    for (size_t i = 0; i < s->touched_count; i++) {
        const node touched = s->touched[i];
        const graph_node *n = &s->g->nodes[touched];
        s->awake[touched] = true;
        for (int k = 0; k < operands(n); k++) {
            s->awake[s->as[operand_at(n, k)].of] = true;
        }
        for (int at = s->first[touched]; at >= 0; at = s->uses[at].next) {
            s->awake[s->uses[at].by == WHOLE ? touched : s->uses[at].by] = true;
        }
    }
}

/* Scales to try; one that is far from the value's own is none, lest the numbers leave their range. */
typedef struct trials {
    double at[48];
    size_t count;
} trials;

static bool is_moderate(double scale)
{
    const double most = 0x1p20;
    return scale <= most && scale >= 1.0 / most;
}

static void propose(trials *t, double scale)
{
    bool known = !is_moderate(scale);
    for (size_t i = 0; i < t->count && !known; i++) {
        known = is_one(scale / t->at[i]);
    }
    if (!known && t->count < sizeof t->at / sizeof t->at[0]) {
        t->at[t->count++] = scale;
    }
}

/* The scales of a sum that one of its terms asks for, or one of its uses, or of a product that it is in. */
static bool improve_sum(scales *s, node z)
{
    const graph_node *n = &s->g->nodes[z];
    const double before = s->scale[z];
    double best = before;
    trials t = {.count = 0};
    touch_none(s);
    if (!touch_all(s, z)) {
        return false;
    }
    for (size_t i = 0; i < s->touched_count; i++) {
        const node reached = s->touched[i];
        for (int at = s->first[reached]; at >= 0; at = s->uses[at].next) {
            propose(&t, before * asked(s, &s->uses[at]) / s->scale[reached]);
        }
    }
    for (int k = 0; k < 2; k++) {
        const multiple term = s->as[operand_at(n, k)];
        if (!is_constant(s->g, term.of)) {
            touch(s, term.of);
            propose(&t, fabs(term.times) * s->scale[term.of]);
        }
    }
    int least = price_of_touched(s);
    for (size_t i = 0; i < t.count && least > 0; i++) {
        set_scale(s, z, t.at[i]);
        const int now = price_of_touched(s);
        best = now < least ? t.at[i] : best;
        least = now < least ? now : least;
    }
    set_scale(s, z, best);
    return best != before;
}

/* Products that take one factor. */
typedef struct takers {
    const use *all[MOST_TAKERS];
    double before[MOST_TAKERS]; /* at which scale they took it */
    int count;
} takers;

static void take_at(scales *s, const use *taker, double scale)
{
    s->taken[2 * taker->by + taker->which] = scale;
    set_scale(s, taker->by, product_scale(s, taker->by));
}

/* The scales at which others ask for a factor, and at which it would give its product a scale that one asks for. */
static void propose_for_factor(const scales *s, node x, const use *taker, trials *t)
{
    const double now = asked(s, taker);
    const bool divides = s->g->nodes[taker->by].op == OP_DIV && taker->which == 1;
    for (int at = s->first[x]; at >= 0; at = s->uses[at].next) {
        propose(t, asked(s, &s->uses[at]));
    }
    for (int at = s->first[taker->by]; at >= 0; at = s->uses[at].next) {
        const double change = asked(s, &s->uses[at]) / s->scale[taker->by];
        propose(t, divides ? now / change : now * change);
    }
}

/* Lets products take a factor at another scale, all at the same. */
static bool improve_takers(scales *s, node x, takers *of)
{
    trials t = {{0.0}, 1};
    bool better = false;
    touch_none(s);
    touch(s, x);
    for (int i = 0; i < of->count; i++) {
        if (!touch_all(s, of->all[i]->by)) {
            return false;
        }
    }
    int least = price_of_touched(s);
    for (int i = 0; i < of->count && least > 0; i++) {
        propose_for_factor(s, x, of->all[i], &t);
        of->before[i] = s->taken[2 * of->all[i]->by + of->all[i]->which];
    }
    for (size_t k = 0; k < t.count && least > 0; k++) {
        for (int i = 0; i < of->count; i++) {
            take_at(s, of->all[i], t.at[k]);
        }
        const int now = price_of_touched(s);
        for (int i = 0; i < of->count; i++) {
            if (now < least) {
                of->before[i] = t.at[k];
            } else {
                take_at(s, of->all[i], of->before[i]);
            }
        }
        better = better || now < least;
        least = now < least ? now : least;
    }
    if (better) {
        wake(s);
    }
    return better;
}

/* Of the products that a node is in, each by itself and then all. */
static bool improve_factor(scales *s, node x)
{
    takers all = {.count = 0};
    bool better = false;
    for (int at = s->first[x]; at >= 0; at = s->uses[at].next) {
        if (is_in_product(s, &s->uses[at])) {
            if (all.count == MOST_TAKERS) {
                return false;
            }
            all.all[all.count++] = &s->uses[at];
        }
    }
    for (int i = 0; i < all.count; i++) {
        takers one = {.all = {all.all[i]}, .count = 1};
        better = improve_takers(s, x, &one) || better;
    }
    return (all.count > 1 && improve_takers(s, x, &all)) || better;
}

static bool is_base(const scales *s, size_t i)
{
    return s->needed[i] && s->as[i].of == (node)i && !is_constant(s->g, (node)i);
}

static bool improve(scales *s, node i)
{
    const bool better = is_sum(&s->g->nodes[i]) && improve_sum(s, i);
    if (better) {
        wake(s);
    }
    return improve_factor(s, i) || better;
}

/* Changes one sum or factor after the other, as long as that is cheaper. The price that is left. */
static int search(scales *s)
{
    enum { SWEEPS = 8 };
    const size_t n = s->g->count;
    bool better = true;
    memset(s->awake, true, n * sizeof *s->awake);
    for (int sweep = 0; sweep < SWEEPS && better; sweep++) {
        better = false;
        for (size_t k = 0; k < n; k++) {
            const size_t i = sweep % 2 == 0 ? n - 1 - k : k;
            if (is_base(s, i) && s->awake[i]) {
                s->awake[i] = false;
                better = improve(s, (node)i) || better;
            }
        }
    }
    int sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += is_base(s, i) ? price(s, (node)i) : 0;
    }
    return sum;
}

/* Where a search begins: with constants where the graph has them, or with none in products, and sums by their terms. */
static void begin(scales *s, bool as_built)
{
    for (size_t i = 0; i < s->g->count; i++) {
        const graph_node *n = &s->g->nodes[i];
        if (!is_base(s, i)) {
            continue;
        }
        s->scale[i] = 1.0;
        if (is_product(n)) {
            for (int k = 0; k < 2; k++) {
                const double times = fabs(s->as[operand_at(n, k)].times);
                s->taken[2 * i + (size_t)k] = as_built && times != 1.0 ? 1.0 / times : 0.0;
            }
            s->scale[i] = product_scale(s, (node)i);
        } else if (is_sum(n) && !as_built) {
            const multiple a = s->as[n->a], b = s->as[n->b];
            const double of_b = fabs(b.times) * s->scale[b.of];
            const double asked_first = is_constant(s->g, a.of) || is_one(of_b) ? of_b : fabs(a.times) * s->scale[a.of];
            s->scale[i] = is_moderate(asked_first) ? asked_first : 1.0;
        }
    }
}

scales scales_choose(const graph *g, const node *roots, size_t count)
{
    enum { LARGE = 8000 }; /* nodes; there the graph's own constants have been the better beginning */
    const size_t n = g->count;
    scales s = {.g = g};
    s.needed = arena_take(g->memory, n, sizeof *s.needed);
    s.as = arena_take(g->memory, n, sizeof *s.as);
    s.scale = arena_take(g->memory, n, sizeof *s.scale);
    s.taken = arena_take(g->memory, 2 * n, sizeof *s.taken);
    s.first = arena_take(g->memory, n, sizeof *s.first);
    s.touched = arena_take(g->memory, n, sizeof *s.touched);
    s.awake = arena_take(g->memory, n, sizeof *s.awake);
    s.mark = arena_take(g->memory, n, sizeof *s.mark);
    graph_reach(g, roots, count, s.needed);
    find_uses(&s, roots, count);
    begin(&s, true);
    const int as_built = search(&s);
    if (n > LARGE) {
        return s;
    }
    double *const scale = arena_take(g->memory, n, sizeof *scale);
    double *const taken = arena_take(g->memory, 2 * n, sizeof *taken);
    memcpy(scale, s.scale, n * sizeof *scale);
    memcpy(taken, s.taken, 2 * n * sizeof *taken);
    begin(&s, false);
    if (as_built <= search(&s)) {
        s.scale = scale;
        s.taken = taken;
    }
    return s;
}
