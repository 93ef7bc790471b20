#!/bin/sh
# Noise is given by its density: the spectrum of what sensors show is the same at any step. Its unit is checked.
. tests/host/test.sh
begin density
one_isoc

cat >"$out/noise.scene" <<'END'
step 1 ms
body b { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint j prismatic { parent ground; child b; axis x }
signal volts = 0 * speed of j / 1 m/s * 1 V
effect probe sensor { input volts; density 10 mV/sqrt(Hz); noise noise(1) }
effect drift walk { sigma 0.3 V/sqrt(s) }
effect fault noisy { input volts; density 20 mV/sqrt(Hz) }
effect unit imu {
    on b; force_density 3 mm/s^2/sqrt(Hz); noise_1 noise(3)
    spin_density 0.05 deg/s/sqrt(Hz); noise_6 noise(4)
}
at 0 s set fault.active = 1
output a = probe.value; output b = drift.value; output c = fault.value
output d = unit.force_x; output e = unit.spin_z
END
optimised -O0
for number in float double; do
    real $number
    for step in 0.25 1 8; do
        rm -f "$out/rows"
        isoc "$out/summary" '' "$out/noise.scene" -o "$out/plant" --real $number --step ${step}ms &&
            EXTRA="-I$out/plant" program show tests/isoc/effects/laws/rows.c "$out/plant/plant.c" && "$out/show" 8000 >"$out/rows" &&
            python3 -B tests/isoc/effects/laws/density.py ${step}e-3 "$out/rows"
        result $? "$number, $step ms: the density of each sensor"
    done
done
python3 -B tests/isoc/effects/laws/density.py 8e-3 "$out/rows" 1.1 >"$out/found"
[ $? -eq 1 ] && grep -q 'spin: ' "$out/found"
result $? 'found: a tenth more of the variance'

# refused FROM TO MESSAGE: the scene with another word.
refused()
{
    sed "s|$1|$2|" "$out/noise.scene" >"$out/bad.scene"
    ! isoc /dev/null "$out/errors" "$out/bad.scene" -o "$out/bad" && grep -q "$3" "$out/errors"
    result $? "refused: $2"
    sed 's/^/# /' "$out/errors"
}
refused 'density 3 mm/s^2/sqrt(Hz)' 'density 3 mm/s^2' 'm/s\*sqrt(Hz)'
refused 'density 10 mV/sqrt(Hz)' 'density 10 mV' 'V/sqrt(Hz)'
finish
