/* What other programs take: FMUs, the end of a wire, a package of Python, a mechanism for MuJoCo. */
#ifndef ISOC_EXPORT_EXPORT_H
#define ISOC_EXPORT_EXPORT_H

#include "tools/isoc/emit/emit.h"

/* exchange.c: whether the plant can be an FMU for model exchange: x' = f(x, u, p) and y = g(x, u, p), where inputs and
 * tunables that are functions of time are all that changes at ticks. Deviations are noted as problems where it is
 * wanted, else as warnings. And fmu_slopes.c, the slopes of f and g; false if a constant leaves the range of real. */
bool exchange_fits(source *s, const scene *written, const graph *g, const plant *p, bool is_wanted);
bool emit_exchange(const plant *p, graph *g, const naming *names, bool exchanges, file_list *files);

/* fmu.c: a plant as an FMU by version 2 or 3 of the standard, for co-simulation, and where it fits for model exchange:
 * its calls, and the description of the model. The name of the plant, where none was given, is that of its scene. */
const char *fmu_name(const plant *p, arena *memory);
void emit_fmu(const plant *p, const graph *g, const naming *names, int version, bool exchanges, file_list *files);

/* link.c: the link of a plant, and the controller's end of it in C and in Python. */

/* Whether its frames fit a channel of a port (port/channel.h); if not, prints an error. */
bool link_fits(const plant *p, const char *path);

/* Adds interface.c, SCENE_link.h and SCENE_link.py to the plant's header and source, the first two of the files. Where
 * a lock is given, for measurement and calibration, the interface has that, and plant.a2l.in is added (a2l.h). */
void emit_link(const plant *p, const naming *names, const char *lock, file_list *files);

/* python.c: adds SCENE_plant, the package of Python that has the plant in it; its library is for a compiler to make.
 * Its identity is that of the link. */
void emit_python(const plant *p, const naming *names, file_list *files);

/* mjcf.c: the mechanism for MuJoCo, with its parameters at their defaults. Why MuJoCo has no such mechanism; else NULL.
 */
const char *emit_mjcf(graph *g, const mechanism *m, text *out);

#endif
