#!/bin/sh
# The angle of a joint that turns without limit: by each method for a minute, and for a day.
. tests/host/test.sh
begin hard_rotor
one_isoc
optimised -O1

# rotor NAME OPTION...: builds the rotor, with $with in its joint, with these options of isoc.
with=
rotor()
{
    name=$1.$real
    shift
    mkdir -p "$out/$name"
    sed "s|continuous|continuous; $with|" tests/promises/hard/rotor.scene >"$out/$name/rotor.scene"
    isoc "$out/$name/summary" '' "$out/$name/rotor.scene" -o "$out/$name" --real "$real" "$@" &&
        EXTRA="-I$out/$name" program "$name.run" tests/promises/hard/rotor.c tests/host/report.c "$out/$name/plant.c"
    result $? "$name builds"
}

# Those whose kernels differ; heun is by the kernel of rk4.
for method in euler rk4 semi_implicit ab4 abm4 bdf4 rosenbrock adams; do
    real float
    case $method in
    adams) rotor adams --method adams --tolerance 1e-6 ;;
    *) rotor $method --method $method ;;
    esac
    joined "$name" "$out/$name.run" 60000 more
done
real double
rotor ab4 --method ab4
joined "$name" "$out/$name.run" 60000 more
with='damping 0.05 N*m*s/rad'
real float
for method in rk4 ab4 bdf4; do
    rotor $method.slows --method $method
    joined "$name" "$out/$name.run" 60000 slows
done

joined 'a day' "$out/rk4.float.run" 86400000
finish
