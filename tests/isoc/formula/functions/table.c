/* Tables beyond their places: at and behind an end the value there; of a NaN a NaN, or the value at an end. */
#include <math.h>

#include "plant.h"

#include "tests/tap.h"

static iso_plant plant;

/* The outputs with this position. */
static const real *outputs_at(const real position)
{
    plant.x[PLANT_X_J] = position;
    plant.model->output(plant.memory);
    return plant.y;
}

static bool shows(const real position, const real line, const real area)
{
    const real *const y = outputs_at(position);
    return y[PLANT_Y_LINE] == line && y[PLANT_Y_AREA] == area;
}

static bool is_one_of(const real value, const real first, const real last)
{
    return isnan(value) || value == first || value == last;
}

static bool ends(const real nan)
{
    const real *const y = outputs_at(nan);
    return is_one_of(y[PLANT_Y_LINE], R(8.0), R(-3.0)) && is_one_of(y[PLANT_Y_AREA], R(2.0), R(9.0));
}

int main(void)
{
    plant = iso_the_plant;
    iso_plant_start(&plant);
    tap_ok(shows(R(-1.0), R(8.0), R(2.0)) && shows(R(0.5), R(4.5), R(6.0)) && shows(R(2.0), R(-3.0), R(9.0)),
           "a table has its values at its places and between them");
    tap_ok(shows(-ISO_REAL_MAX, R(8.0), R(2.0)) && shows(ISO_REAL_MAX, R(-3.0), R(9.0)),
           "of the largest numbers those at its ends");
    tap_ok(shows(-(real)INFINITY, R(8.0), R(2.0)) && shows((real)INFINITY, R(-3.0), R(9.0)),
           "of infinities those at its ends");
    tap_ok(ends((real)NAN) && ends(-(real)NAN), "of a NaN a NaN, or the value at an end");
    tap_done();
}
