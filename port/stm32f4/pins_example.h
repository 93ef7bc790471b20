/* A table of pins: PA0 (A0 on the Nucleo) measures the first input, from -10 to 10 at 0 V to 3.3 V; PA4 (A2) shows the
 * first output as a voltage, PA6 (D12) the second as the width of pulses. */
#define PINS_INPUTS                                                                                                    \
    {                                                                                                                  \
        .input = 0, .port = 'A', .pin = 0, .at_0 = R(-10.0), .at_full = R(10.0)                                        \
    }
#define PINS_OUTPUTS                                                                                                   \
    {.output = 0, .port = 'A', .pin = 4, .at_0 = R(-1.0), .at_full = R(1.0), .safe = R(0.5)},                          \
    {                                                                                                                  \
        .output = 1, .port = 'A', .pin = 6, .at_0 = R(-5.0), .at_full = R(5.0), .safe = R(0.5)                         \
    }
