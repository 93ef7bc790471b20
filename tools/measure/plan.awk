# How long to measure, about `nanoseconds` in steps of `step` seconds: the number of steps four times as long, the time
# that they make, and the tick of a method that chooses its steps: the longest part of the time that is at most ten of
# the long steps, and no more than isoc allows, 1 s; and the time of fifty steps.
#
#     awk -v nanoseconds=NANOSECONDS -v step=STEP -f plan.awk
BEGIN {
    coarsest = int(nanoseconds / (4e9 * step) + 0.5)
    if (coarsest < 1) coarsest = 1
    for (steps = 40; steps > 1 && (4 * coarsest % steps || steps * step > 1); steps--) continue
    printf "%d %.17g %.9gs %.9f\n", coarsest, 4 * coarsest * step, steps * step, 50 * step
}
