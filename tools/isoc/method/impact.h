/* What a method makes of an impact: a unit mass against a spring that begins and ends within steps.
 *
 * A method is exact to its order only where forces are smooth. The corner at the begin and at the end of a contact
 * leaves an error of the order (h w)^2 of the speed, of either sign, by the places of both within their steps; and a
 * method can let an oscillation grow. So a mass can leave an elastic spring faster than it came. Both are the smaller
 * the longer the contact takes, and a damping that is as large takes them back: that of a force k (x + lead v), of a
 * depth a little later.
 */
#ifndef ISOC_METHOD_IMPACT_H
#define ISOC_METHOD_IMPACT_H

/* Of a recipe, times the step and over it. */
typedef struct impact_limits {
    double frequency; /* h w of the stiffest spring: half a turn takes 16 steps, or as many as a damping of Hunt and
                         Crossley needs, whose rate is at most sqrt(2) w (models/README.md) */
    double lead;      /* over h, with which no impact on a spring up to this stiffness gains speed */
} impact_limits;

/* `rate`: the h |lambda| of a decay that the method holds. */
impact_limits impact_limits_of(unsigned recipe, double rate);

#endif
