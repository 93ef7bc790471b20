#!/bin/sh
# isochron conform: a line for each duty of a port; status 1 if one failed. From the environment: TARGET, REAL, CLOCK of
# the port, STACK, EXEC, the command that runs the program that tries the duties, SECONDS of each run, MAKE.

failed=0
build/duties "$STACK" sh -c "exec $EXEC" || failed=1

mkdir -p build/conform/host "build/conform/$TARGET"

# plant SCENE METHOD [STEP=DURATION]: runs it on the host and on the target; counts the equal runs.
compared=0 different='' counts='' varying=''
plant()
{
    hash=''
    for target in host "$TARGET"; do
        folder=build/conform/$target
        $MAKE --no-print-directory run SCENE="models/$1.scene" METHOD="$2" ${3+"$3"} TARGET="$target" REAL="$REAL" SECONDS="$SECONDS" \
            >"$folder/output" 2>"$folder/errors" </dev/null
        now='' execution=''
        while read -r key value; do
            case $key in
            hash) now=$value ;;
            execution) execution=$value ;;
            esac
        done <"$folder/output"
        : "${hash:=$now}"
    done
    if [ -n "$now" ] && [ "$now" = "$hash" ]; then
        compared=$((compared + 1))
    else
        different="$different $1"
        grep -v '^  ' "$folder/errors" | head -n 5
    fi
    # shellcheck disable=SC2086
    set -- "$1" $execution
    [ "${2-none}" = "${4-}" ] || varying="$varying $1 ${2-none} to ${4-none}"
    counts="$counts $1 ${2-none}"
}

plant double_pendulum rk4
plant cart_pole_drive heun
plant four_bar euler STEP=2ms
plant rigid_body rk4
plant cart_pole bdf4
if [ -z "$different" ]; then
    echo "bits ok: $compared plants with the hash of the host"
else
    echo "bits FAILED: another hash than on the host:$different"
    failed=1
fi
case $CLOCK in
instructions | cycles)
    if [ -z "$varying" ]; then
        echo "count ok: $CLOCK of every step:$counts"
    else
        echo "count FAILED: $CLOCK of the steps:$varying"
        failed=1
    fi
    ;;
*) echo "count has none: the clock counts $CLOCK" ;;
esac
exit $failed
