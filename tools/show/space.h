/* Vectors and turns in space. */
#ifndef ISO_TOOLS_SHOW_SPACE_H
#define ISO_TOOLS_SHOW_SPACE_H

#include <math.h>
#include <stdbool.h>

typedef struct vec {
    double x, y, z;
} vec;

/* A turn and a move: p becomes turn p + at. The rows of the turn. */
typedef struct pose {
    vec row[3];
    vec at;
} pose;

static const pose no_pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static inline vec plus(vec a, vec b)
{
    return (vec){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec times(double k, vec a)
{
    return (vec){k * a.x, k * a.y, k * a.z};
}

static inline vec minus(vec a, vec b)
{
    return plus(a, times(-1.0, b));
}

static inline double inner(vec a, vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec outer(vec a, vec b)
{
    return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double length_of(vec a)
{
    return sqrt(inner(a, a));
}

/* Of length 1; zero stays zero. */
static inline vec unit(vec a)
{
    const double length = length_of(a);
    return length > 0.0 ? times(1.0 / length, a) : a;
}

static inline vec turned(const pose *p, vec a)
{
    return (vec){inner(p->row[0], a), inner(p->row[1], a), inner(p->row[2], a)};
}

static inline vec placed(const pose *p, vec a)
{
    return plus(turned(p, a), p->at);
}

/* The turn of a unit quaternion w, x, y, z, which is normalised here. */
static inline pose pose_of(const double q[4], vec at)
{
    const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], s = norm > 0.0 ? 2.0 / norm : 0.0;
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return (pose){{{1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
                   {s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)},
                   {s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)}},
                  at};
}

/* The pose whose z axis leads from one point to another and is as long as their distance, with axes of length 1 across
 * it. */
static inline pose pose_between(vec from, vec to)
{
    const vec way = minus(to, from), z = unit(way);
    const vec far = fabs(z.x) < 0.6 ? (vec){1, 0, 0} : (vec){0, 1, 0};
    const vec x = unit(outer(far, z)), y = outer(z, x);
    return (pose){{{x.x, y.x, way.x}, {x.y, y.y, way.y}, {x.z, y.z, way.z}}, from};
}

/* The least box along the axes around points. */
typedef struct box {
    vec least, most;
    bool any;
} box;

static inline void include(box *b, vec p)
{
    if (isfinite(p.x) && isfinite(p.y) && isfinite(p.z)) {
        b->least = b->any ? (vec){fmin(b->least.x, p.x), fmin(b->least.y, p.y), fmin(b->least.z, p.z)} : p;
        b->most = b->any ? (vec){fmax(b->most.x, p.x), fmax(b->most.y, p.y), fmax(b->most.z, p.z)} : p;
        b->any = true;
    }
}

static inline double diagonal(const box *b)
{
    return length_of(minus(b->most, b->least));
}

static inline vec box_centre(const box *b)
{
    return times(0.5, plus(b->least, b->most));
}

#endif
