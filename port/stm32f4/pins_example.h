/* A table of pins: PA0 (A0 on the Nucleo) measures the first input, from -10 to 10 at 0 V to 3.3 V; a
 * pin is 16 for each letter and its number.  PA4 (A2) shows the
 * first output as a voltage, PA6 (D12) the second as the width of pulses. */
#define PINS_INPUTS                                                                                                    \
    {                                                                                                                  \
        .place = 0, .kind = PINS_VOLTAGE, .pin = 0, .at_0 = R(-10.0), .at_1 = R(10.0)                                  \
    }
#define PINS_OUTPUTS                                                                                                   \
    {.place = 0, .kind = PINS_VOLTAGE, .pin = 4, .at_0 = R(-1.0), .at_1 = R(1.0), .safe = R(0.5)},                     \
    {                                                                                                                  \
        .place = 1, .kind = PINS_DUTY, .pin = 6, .at_0 = R(-5.0), .at_1 = R(5.0), .safe = R(0.5)                       \
    }
