#include "tools/linear/linear.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"

static const double tau = 6.28318530717958647692;

/* How far the motion goes, in SI units. */
static const double excursion = 1e-6;

enum { MOST_STEPS = 400000, LEAST_STEPS = 256, LEAST_PARTS = 32, MOST_PARTS = 256, ITERATIONS = 60 };

/* A step of the method, of the fastest mode. */
static const double longest_step = 0.1;

typedef struct drive {
    const iso_plant *plant;
    const model *m;
    int input, parts, steps; /* parts of a period, steps of a part */
    double w, amplitude, h;
    double *u, *slopes; /* work: inputs, and five vectors of states */
    double *flow;       /* [n][n] the map of a small deviation over a part */
    double *z;          /* [parts][n] where each part begins */
    double *left;       /* [parts][n] where it ends, less where the next begins */
} drive;

/* Puts the plant to the point of a model. */
static void plant_at(const iso_plant *const plant, const model *const m)
{
    iso_plant_start(plant);
    memcpy(plant->x, m->x, (size_t)m->states * sizeof *plant->x);
    if (m->held > 0) {
        memcpy(plant->u, m->u, (size_t)m->held * sizeof *plant->u);
    }
    if (m->parameters > 0) {
        memcpy(plant->p, m->p, (size_t)m->parameters * sizeof *plant->p);
    }
    if (plant->model->prime != NULL) {
        plant->model->prime(plant->memory);
        memcpy(plant->x, m->x, (size_t)m->states * sizeof *plant->x);
    }
}

/* States from those of the model, and back. */
static void expand_states(const model *const m, const double *const z, double *const x)
{
    for (int i = 0; i < m->states; i++) {
        x[i] = m->x[i];
        for (int k = 0; k < m->n; k++) {
            x[i] += m->up[i * m->n + k] * z[k];
        }
    }
}

static void reduce_states(const model *const m, const double *const x, double *const z)
{
    for (int k = 0; k < m->n; k++) {
        z[k] = 0.0;
        for (int i = 0; i < m->states; i++) {
            z[k] += m->down[k * m->states + i] * (x[i] - m->x[i]);
        }
    }
}

static void derivative_at(const drive *const d, double *const dx, const double *const x, const double t)
{
    d->u[d->input] = d->m->u[d->input] + d->amplitude * sin(d->w * t);
    iso_the_derivative(dx, x, d->u, d->plant->p);
}

/* Kutta (1901). */
static void step(const drive *const d, double *const x, const double t)
{
    const int n = d->m->states;
    const double h = d->h;
    double *const k1 = d->slopes, *const k2 = k1 + n, *const k3 = k2 + n, *const k4 = k3 + n, *const y = k4 + n;
    derivative_at(d, k1, x, t);
    for (int stage = 1; stage < 4; stage++) {
        const double part = stage < 3 ? 0.5 * h : h, *const before = k1 + (stage - 1) * n;
        for (int i = 0; i < n; i++) {
            y[i] = x[i] + part * before[i];
        }
        derivative_at(d, k1 + stage * n, y, t + part);
    }
    for (int i = 0; i < n; i++) {
        x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    }
}

/* Runs each part from its begin, to which the steady drift of positions is added. */
static void run_parts(const drive *const d)
{
    const model *const m = d->m;
    const int n = m->n;
    double *const x = memory_for((size_t)m->states, sizeof *x), *const z = memory_for((size_t)n, sizeof *z);
    const double length = d->h * d->steps;
    for (int part = 0; part < d->parts; part++) {
        for (int k = 0; k < n; k++) {
            z[k] = d->z[part * n + k] + length * part * m->rates[k];
        }
        expand_states(m, z, x);
        for (int i = 0; i < d->steps; i++) {
            step(d, x, length * part + d->h * i);
        }
        reduce_states(m, x, z);
        const double *const next = d->z + (part + 1) % d->parts * n;
        for (int k = 0; k < n; k++) {
            d->left[part * n + k] = z[k] - length * (part + 1) * m->rates[k] - next[k];
        }
    }
    free(x);
    free(z);
}

static void multiply(double *const to, const double *const a, const double *const b, const int n)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            double sum = 0.0;
            for (int k = 0; k < n; k++) {
                sum += a[i * n + k] * b[k * n + j];
            }
            to[i * n + j] = sum;
        }
    }
}

/* The map of a small deviation over a part: from slopes of the plant's derivative by central differences, in as many
 * steps. */
static void find_flow(const drive *const d)
{
    const model *const m = d->m;
    const int n = m->n;
    const size_t square = (size_t)(n * n), states = (size_t)m->states;
    double *const x = memory_for(states, sizeof *x), *const dx = memory_for(states, sizeof *dx),
                  *const z = memory_for((size_t)n, sizeof *z), *const a = memory_for(square, sizeof *a),
                  *const next = memory_for(square, sizeof *next), *const once = memory_for(square, sizeof *once);
    const double distance = 1e-6;
    for (int j = 0; j < n; j++) {
        for (int side = -1; side <= 1; side += 2) {
            memset(z, 0, (size_t)n * sizeof *z);
            z[j] = side * distance;
            expand_states(m, z, x);
            memcpy(d->u, m->u, (size_t)m->held * sizeof *d->u);
            iso_the_derivative(dx, x, d->u, d->plant->p);
            for (int i = 0; i < n; i++) {
                for (int s = 0; s < m->states; s++) {
                    a[i * n + j] += m->down[i * m->states + s] * side * dx[s] / (2.0 * distance);
                }
            }
        }
    }
    /* 1 + hA (1 + hA/2 (1 + hA/3 (1 + hA/4))) */
    for (int i = 0; i < n; i++) {
        once[i * n + i] = 1.0;
    }
    for (int order = 4; order > 0; order--) {
        multiply(next, a, once, n);
        for (int i = 0; i < n * n; i++) {
            once[i] = d->h / order * next[i] + (i % (n + 1) == 0 ? 1.0 : 0.0);
        }
    }
    memcpy(d->flow, once, square * sizeof *once);
    for (int i = 1; i < d->steps; i++) {
        multiply(next, once, d->flow, n);
        memcpy(d->flow, next, square * sizeof *next);
    }
    double *const all[] = {x, dx, z, a, next, once};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        free(all[i]);
    }
}

/* z_(k+1) - flow z_k = left_k around the period, harmonic by harmonic. */
static void join_parts(const drive *const d)
{
    const int n = d->m->n, parts = d->parts;
    double complex *const left = memory_for((size_t)(n * n), sizeof *left), *const b = memory_for((size_t)n, sizeof *b);
    double *const moved = memory_for((size_t)(parts * n), sizeof *moved);
    for (int h = 0; 2 * h <= parts; h++) {
        const double weight = (h == 0 || 2 * h == parts ? 1.0 : 2.0) / parts;
        for (int k = 0; k < n; k++) {
            b[k] = 0.0;
            for (int part = 0; part < parts; part++) {
                b[k] += d->left[part * n + k] * cexp(-(double complex)_Complex_I * tau * h * part / parts);
            }
        }
        for (int i = 0; i < n * n; i++) {
            left[i] = -d->flow[i] + (i % (n + 1) == 0 ? cexp((double complex)_Complex_I * tau * h / parts) : 0.0);
        }
        solve_complex(left, n, b);
        for (int part = 0; part < parts; part++) {
            const double complex turn = weight * cexp((double complex)_Complex_I * tau * h * part / parts);
            for (int k = 0; k < n; k++) {
                moved[part * n + k] += creal(b[k] * turn);
            }
        }
    }
    for (int i = 0; i < parts * n; i++) {
        d->z[i] += moved[i];
    }
    free(left);
    free(b);
    free(moved);
}

static double largest_of(const double *const all, const int count)
{
    double largest = 0.0;
    for (int i = 0; i < count; i++) {
        largest = isfinite(all[i]) ? fmax(largest, fabs(all[i])) : HUGE_VAL;
    }
    return largest;
}

/* The first harmonic of an output where the parts begin. */
static double complex first_harmonic(const drive *const d, const int output)
{
    const model *const m = d->m;
    const double length = d->h * d->steps;
    double *const z = memory_for((size_t)m->n, sizeof *z);
    double complex sum = 0.0;
    double drift = 0.0;
    for (int k = 0; k < m->n; k++) {
        drift += m->c[output * m->n + k] * m->rates[k];
    }
    for (int part = 0; part < d->parts; part++) {
        const double t = length * part;
        for (int k = 0; k < m->n; k++) {
            z[k] = d->z[part * m->n + k] + t * m->rates[k];
        }
        expand_states(m, z, d->plant->x);
        d->plant->u[d->input] = m->u[d->input] + d->amplitude * sin(d->w * t);
        d->plant->model->output(d->plant->memory);
        sum += (d->plant->y[output] - drift * t) * cexp(-(double complex)_Complex_I * d->w * t);
    }
    free(z);
    return 2.0 * (double complex)_Complex_I * sum / (d->parts * d->amplitude);
}

/* The sine is so small that the model moves no state by more than the excursion, and at most a tenth in SI units. */
static double amplitude_of(const model *const m, const int input, const double w)
{
    double complex *const x = memory_for((size_t)m->n, sizeof *x);
    double largest = 10.0 * excursion;
    response(m, input, w, x);
    for (int i = 0; i < m->n; i++) {
        largest = fmax(largest, cabs(x[i]));
    }
    free(x);
    return excursion / largest;
}

double slowest_measured(const model *const m)
{
    return fmax(tau * m->fastest / longest_step / (double)MOST_STEPS, 4.0 * m->growth * tau / (double)MOST_PARTS);
}

measured measure(const iso_plant *const plant, const model *const m, const int input, const int output, const double w)
{
    const double period = tau / w, steps = fmax(LEAST_STEPS, period * m->fastest / longest_step);
    drive d = {.plant = plant, .m = m, .input = input, .w = w, .amplitude = amplitude_of(m, input, w)};
    d.parts = (int)fmin(MOST_PARTS, fmax(LEAST_PARTS, ceil(period * m->growth)));
    d.steps = (int)ceil(steps / d.parts);
    d.h = period / d.parts / d.steps;
    d.u = memory_for((size_t)m->held, sizeof *d.u);
    d.slopes = memory_for(5 * (size_t)m->states, sizeof *d.slopes);
    d.flow = memory_for((size_t)(m->n * m->n), sizeof *d.flow);
    d.z = memory_for((size_t)(d.parts * m->n), sizeof *d.z);
    d.left = memory_for((size_t)(d.parts * m->n), sizeof *d.left);
    plant_at(plant, m);
    find_flow(&d);
    memcpy(d.u, m->u, (size_t)m->held * sizeof *d.u);
    measured result = {.left = HUGE_VAL};
    for (int i = 0; i < ITERATIONS && result.left > 1e-8; i++) {
        run_parts(&d);
        const double before = result.left;
        result.left = largest_of(d.left, d.parts * m->n) / fmax(largest_of(d.z, d.parts * m->n), 1e-300);
        if (i > 3 && result.left > 0.95 * before) {
            break; /* rounding */
        }
        join_parts(&d);
    }
    result.gain = first_harmonic(&d, output);
    /* Of an output that moves by less the rounding would be measured. */
    const double moved = d.amplitude * cabs(result.gain), rounding = 1e-12 * fabs(plant->y[output]);
    result.found = result.left < 1e-4 && moved > rounding;
    free(d.u);
    free(d.slopes);
    free(d.flow);
    free(d.z);
    free(d.left);
    return result;
}
