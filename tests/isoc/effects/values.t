#!/bin/sh
# Values that make no sense, zero, negative or crossed, are refused at each effect of the library that has such, with
# the place.
. tests/host/test.sh
begin effects_values
one_isoc
scene=tests/isoc/effects/all.scene

# use KIND 'OPERAND VALUE': the scene in which the first use of this kind has this value.
use()
{
    awk -v kind="$1" -v given="$2" '
        !done && $1 == "effect" && $3 == kind {
            operand = given
            sub(/ .*/, "", operand)
            gsub("; *" operand " [^;}]*", "")
            sub(/ *}$/, "; " given " }")
            done = 1
        }
        { print }
        END { exit !done }' $scene
}

isoc "$out/summary" "$out/told" $scene -o "$out/plain"
result $? 'all effects with sound values are accepted'
while read -r kind given; do
    use "$kind" "$given" >"$out/bad.scene" && ! isoc "$out/summary" "$out/errors" "$out/bad.scene" -o "$out/bad" &&
        grep -q "bad.scene:[0-9]*:[0-9]*: error: .*breaks what its effect requires" "$out/errors" && [ ! -e "$out/bad" ]
    result $? "refused: $kind with $given"
done <<END
stop impact -1 m/s
stop impact 0 m/s
stop rest 0
stop rest 1.1
stop stiffness -1 N/m
stop upper -1 m
bumper impact -1 m/s
bumper side 0.5
bumper stiffness -1 N/m
backlash impact 0 rad/s
backlash gap -1 deg
backlash ratio 0
contact impact -1 m/s
contact friction -1
contact stiffness -1 N/m
friction sliding -1 N
friction static 0 N
friction creep 0 m/s
friction fall -1 m/s
battery capacity 0 A*s
battery start 1.5
battery cells 0
battery empty 0
battery resistance -1 Ohm
chopper period 0 s
chopper inductance -1 H
chopper drop -1 V
dc_motor inductance 0 H
dc_motor resistance -1 Ohm
thermal resistance 0 K/W
thermal capacity -1 J/K
flexible_gear ratio 0
flexible_gear rotor 0 kg*m^2
cogging periods 0.5
cogging peak -1 N*m
jammed rate 0 Hz
current_limit most -1 A
lag constant 0 s
END
sed '/^ *require/d' models/effects/lag.scene >"$out/free.scene"
use lag 'constant 1e-12 s' >>"$out/free.scene"
isoc "$out/summary" "$out/errors" "$out/free.scene" -o "$out/free"
result $? 'found: an effect that requires nothing accepts what is refused with it'
finish
