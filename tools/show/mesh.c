#include "tools/show/show.h"

#include "tools/file/file.h"

static const double whole_turn = 6.28318530717958647692;

static size_t add_vertex(mesh *to, const pose *at, vec p)
{
    to->vertex = room_behind(to->vertex, to->vertices, sizeof *to->vertex);
    to->vertex[to->vertices] = placed(at, p);
    return to->vertices++;
}

static void add_corner(mesh *to, size_t vertex)
{
    to->corner = room_behind(to->corner, to->corners, sizeof *to->corner);
    to->corner[to->corners++] = vertex;
}

static void end_face(mesh *to)
{
    to->end = room_behind(to->end, to->faces, sizeof *to->end);
    to->end[to->faces++] = to->corners;
}

static void add_face(mesh *to, const size_t *vertex, size_t corners)
{
    for (size_t i = 0; i < corners; i++) {
        add_corner(to, vertex[i]);
    }
    end_face(to);
}

/* A side of a box, in parts: near faces are drawn over far ones in the order of their middles, so a face must not be
 * large against one before it. */
static void add_side(mesh *to, const pose *at, vec middle, vec across, vec up)
{
    enum { PARTS = 3 };
    const size_t first = to->vertices;
    for (int i = 0; i <= PARTS; i++) {
        const vec row = plus(middle, times(2.0 * i / (double)PARTS - 1.0, up));
        for (int j = 0; j <= PARTS; j++) {
            add_vertex(to, at, plus(row, times(2.0 * j / (double)PARTS - 1.0, across)));
        }
    }
    for (size_t i = 0; i < PARTS; i++) {
        for (size_t j = 0; j < PARTS; j++) {
            const size_t a = first + i * (PARTS + 1) + j;
            add_face(to, (size_t[]){a, a + 1, a + PARTS + 2, a + PARTS + 1}, 4);
        }
    }
}

void mesh_box(mesh *to, pose at, vec edges)
{
    const vec x = {edges.x / 2, 0, 0}, y = {0, edges.y / 2, 0}, z = {0, 0, edges.z / 2};
    add_side(to, &at, x, y, z);
    add_side(to, &at, times(-1, x), z, y);
    add_side(to, &at, y, z, x);
    add_side(to, &at, times(-1, y), x, z);
    add_side(to, &at, z, x, y);
    add_side(to, &at, times(-1, z), y, x);
}

/* A ring of vertices; returns the first. */
static size_t add_ring(mesh *to, const pose *at, double rx, double ry, double z, int sides)
{
    const size_t first = to->vertices;
    for (int i = 0; i < sides; i++) {
        const double angle = whole_turn * i / sides;
        add_vertex(to, at, (vec){rx * cos(angle), ry * sin(angle), z});
    }
    return first;
}

/* The faces between two rings, of which the second is above as seen from without. */
static void add_band(mesh *to, size_t low, size_t high, int sides)
{
    const size_t n = (size_t)sides;
    for (size_t i = 0; i < n; i++) {
        add_face(to, (size_t[]){low + i, low + (i + 1) % n, high + (i + 1) % n, high + i}, 4);
    }
}

static void add_cap(mesh *to, size_t ring, int sides, int is_top)
{
    const size_t n = (size_t)sides;
    for (size_t i = 0; i < n; i++) {
        add_corner(to, ring + (is_top ? i : n - 1 - i));
    }
    end_face(to);
}

void mesh_bar(mesh *to, pose at, double radius, double length, int sides, int pieces)
{
    const size_t first = add_ring(to, &at, radius, radius, 0.0, sides);
    size_t low = first;
    for (int i = 1; i <= pieces; i++) {
        const size_t high = add_ring(to, &at, radius, radius, length * i / pieces, sides);
        add_band(to, low, high, sides);
        low = high;
    }
    add_cap(to, first, sides, 0);
    add_cap(to, low, sides, 1);
}

void mesh_prism(mesh *to, pose at, double radius, double length, int sides)
{
    mesh_bar(to, at, radius, length, sides, 1);
}

void mesh_wedge(mesh *to, pose at, vec sizes, int sides, int from, int end)
{
    size_t ring[4]; /* low and high, of the outside and of the hole */
    for (int i = 0; i < 4; i++) {
        const double radius = i < 2 ? sizes.x : sizes.y, z = i % 2 == 0 ? -sizes.z / 2 : sizes.z / 2;
        ring[i] = add_ring(to, &at, radius, radius, z, sides);
    }
    for (int i = from; i < end; i++) {
        const size_t a = (size_t)(i % sides), b = (size_t)((i + 1) % sides);
        add_face(to, (size_t[]){ring[0] + a, ring[0] + b, ring[1] + b, ring[1] + a}, 4);
        add_face(to, (size_t[]){ring[1] + a, ring[1] + b, ring[3] + b, ring[3] + a}, 4);
        add_face(to, (size_t[]){ring[2] + a, ring[2] + b, ring[0] + b, ring[0] + a}, 4);
        if (sizes.y > 0.0) {
            add_face(to, (size_t[]){ring[3] + a, ring[3] + b, ring[2] + b, ring[2] + a}, 4);
        }
    }
}

void mesh_cone(mesh *to, pose at, double radius, double length, int sides)
{
    const size_t ring = add_ring(to, &at, radius, radius, 0.0, sides), n = (size_t)sides;
    const size_t tip = add_vertex(to, &at, (vec){0.0, 0.0, length});
    for (size_t i = 0; i < n; i++) {
        add_face(to, (size_t[]){ring + i, ring + (i + 1) % n, tip}, 3);
    }
    add_cap(to, ring, sides, 0);
}

void mesh_ellipsoid(mesh *to, pose at, vec radii, int sides)
{
    const int rows = sides / 2;
    size_t before = 0;
    for (int i = 1; i < rows; i++) {
        const double angle = whole_turn / 2 * i / rows;
        const size_t ring = add_ring(to, &at, radii.x * sin(angle), radii.y * sin(angle), -radii.z * cos(angle), sides);
        if (i > 1) {
            add_band(to, before, ring, sides);
        } else {
            add_cap(to, ring, sides, 0);
        }
        before = ring;
    }
    add_cap(to, before, sides, 1);
}

/* The outline of points in a plane, gift wrapping (Jarvis 1973); returns its length. */
static size_t wrap(const vec *point, size_t points, vec normal, size_t *outline)
{
    size_t first = 0, count = 0; /* the point farthest from the middle is on the outline */
    vec middle = {0, 0, 0};
    for (size_t i = 0; i < points; i++) {
        middle = plus(middle, times(1.0 / (double)points, point[i]));
    }
    for (size_t i = 0; i < points; i++) {
        first = length_of(minus(point[i], middle)) > length_of(minus(point[first], middle)) ? i : first;
    }
    size_t at = first;
    do {
        outline[count++] = at;
        size_t next = at == 0 ? 1 : 0;
        for (size_t i = 0; i < points; i++) {
            const vec a = minus(point[next], point[at]), b = minus(point[i], point[at]);
            const double side = inner(normal, outer(a, b));
            const double slack = 1e-9 * length_of(a) * length_of(b);
            next = i != at && (side < -slack || (side < slack && length_of(b) > length_of(a))) ? i : next;
        }
        at = next;
    } while (at != first && count < points);
    return count;
}

void mesh_plate(mesh *to, const vec *point, size_t points, vec normal, double thickness)
{
    size_t outline[64];
    if (points > sizeof outline / sizeof outline[0]) {
        return;
    }
    const size_t count = wrap(point, points, normal, outline), low = to->vertices;
    for (int side = 0; side < 2; side++) {
        const vec move = times((side - 0.5) * thickness, normal);
        for (size_t i = 0; i < count; i++) {
            add_vertex(to, &no_pose, plus(point[outline[i]], move));
        }
    }
    add_band(to, low, low + count, (int)count);
    add_cap(to, low, (int)count, 0);
    add_cap(to, low + count, (int)count, 1);
}

void mesh_helix(mesh *to, double radius, int turns)
{
    enum { STEPS = 12 };
    for (int i = 0; i <= turns * STEPS; i++) {
        const double angle = whole_turn * i / (double)STEPS, share = (double)i / (turns * STEPS);
        add_corner(to, add_vertex(to, &no_pose, (vec){radius * sin(angle), radius * cos(angle), share}));
    }
    end_face(to);
}
