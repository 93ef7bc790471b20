"""usage: density.py STEP_IN_S ROWS [PLANTED_FACTOR]: whether columns of samples have their densities and walks.

The columns are of sensor, walk, noisy, and a component of the force and the spin of imu. White noise of density d in steps of h has
the variance d^2 / (2 h), the increments of a walk with sigma k have k^2 h; both within five standard deviations, sqrt(2 / n)
of a variance of n independent Gaussian numbers.
"""
import math
import sys

h, factor = float(sys.argv[1]), float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
rows = [list(map(float, line.split())) for line in open(sys.argv[2])]
wanted = {
    "sensor": 0.01**2 / (2 * h),
    "walk": 0.3**2 * h,
    "noisy": 0.02**2 / (2 * h),
    "force": 0.003**2 / (2 * h),
    "spin": math.radians(0.05) ** 2 / (2 * h),
}
failed = False
for i, (name, want) in enumerate(wanted.items()):
    x = [row[i] for row in rows]
    if name == "walk":
        x = [b - a for a, b in zip(x, x[1:])]
    got = sum(v * v for v in x) / len(x) / (want * factor)
    most = 5.0 * math.sqrt(2.0 / len(x))
    failed |= abs(got - 1.0) > most
    print("# step %g s, %s: %.4f of its variance, within %.2g" % (h, name, got, most))
sys.exit(failed)
