# shellcheck shell=sh
# One hash per scene and method, whatever compiles the plant and wherever it runs; read after tests/host/test.sh,
# tests/host/project.sh and `begin`. A script names a variant, and tries models with methods in it: the hash of the
# first variant is the one that all others must have.

METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')
[ -n "$METHODS" ] || result 1 "build/isoc lists the methods"
mkdir -p "$out/hash" "$out/plant" "$out/run"

# variant NAME PORT COMPILER LEVEL [FLAG...]: how programs are made and run from here on. What a variant has already is
# not compiled again.
variant()
{
    variant=$1
    port=$2
    compiler="$3 ${FLAGS% -O2 *} $4 ${FLAGS#* -O2 }"
    link=$3
    libraries=-lm
    sources="port/host/*.c port/unix/console.c"
    shift 4
    case $port in
    mps2)
        libraries=
        sources="port/mps2/*.c"
        compiler="$compiler $(of_port mps2 PORT_FLAGS)"
        link="$link $(of_port mps2 PORT_FLAGS) $(of_port mps2 PORT_LINK)"
        ;;
    esac
    # shellcheck disable=SC2086
    set -- $compiler "$@"
    compiler=$*
    base=$out/$variant
    [ -f "$base/command" ] && read -r made <"$base/command" && [ "$made" = "$compiler" ] && return
    mkdir -p "$base"
    for source in core/numbers/*.c core/runtime/*.c core/application/*.c $sources; do
        $compiler -c "$source" -o "$base/${source##*/}.o" || return
    done
    echo "$compiler" >"$base/command"
}

# runs SOURCE NANOSECONDS [FLAG...]: the program of this plant in C; its summary is in $out/output. Returns its status.
runs()
{
    source=$1
    duration=$2
    shift 2
    : >"$out/output"
    $compiler "$@" -c "$source" -o "$out/plant.o" 2>"$out/errors" && $link "$base"/*.o "$out/plant.o" $libraries -o "$out/program" || return
    case $port in
    mps2)
        build/trace -o "$out/run" --clock instructions -- qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off \
            -display none -monitor none -serial none \
            -semihosting-config "enable=on,target=native,arg=plant,arg=$duration" -kernel "$out/program"
        ;;
    *) build/trace -o "$out/run" -- "$out/program" "$duration" ;;
    esac >"$out/output" 2>"$out/errors" </dev/null
}

# length METHOD SCENE: $length is how long in nanoseconds, and in what step, if it is not the scene's: ten seconds of
# rk4, one of the other methods; but for PEC, which is not stable there on a model with much damping; and less of a
# model that is not tried in depth: ten steps or, with effects, until most of them have begun to act.
length()
{
    length=1000000000
    if [ "$2" != models/oscillator.c ] && ! in_depth "$2"; then
        length=10000000
        shared_models
        # shellcheck disable=SC2086
        [ "$1" != rk4 ] || [ "$2" = models/stewart.scene ] || place "$2" $shared_models || length=2000000000
        return
    fi
    case $1 in
    rk4) length=10000000000 ;;
    abm4_pec) length='500000000 500us 0.0005' ;;
    esac
}

# model SCENE METHOD: runs it. A scene is compiled once for all variants.
model()
{
    : >"$out/output"
    length "$2" "$1"
    # shellcheck disable=SC2086
    set -- "$1" "$2" $length
    case $1 in
    *.c)
        macro_of "$2"
        runs "$1" "$3" "-DISO_METHOD=$macro" "-DISO_METHOD_NAME=$2" ${5+"-DISO_STEP=$5"}
        ;;
    *)
        generated=${1##*/}
        generated=$out/plant/${generated%.scene}-$2
        { [ -f "$generated/plant.c" ] ||
            isoc "$out/summary" "$out/errors" "$1" -o "$generated" --method "$2" ${4+--step "$4"}; } &&
            runs "$generated/plant.c" "$3"
        ;;
    esac
}

# is_number WORD...: each is a whole number.
is_number()
{
    for is_number_word; do
        case $is_number_word in
        '' | *[!0-9]*) return 1 ;;
        esac
    done
    [ $# -gt 0 ]
}

# counted METHOD: every step took one number of instructions, unless one lasts longer than a tick, whose interrupt
# counts; with adams, whose sub-steps the budget bounds, two that say from what to what. The number is $instructions
# then.
counted()
{
    read_value instructions_per_step
    instructions=$value
    read_value margin
    # shellcheck disable=SC2086
    case $1,$instructions in
    adams,*' '*' '*) false ;;
    adams,*) is_number $instructions ;;
    *) is_number "$instructions" || [ "${value#-}" != "$value" ] ;;
    esac
}

# same SCENE METHOD: two tests in the variant of now; only the first on the host.
same()
{
    plant=${1##*/}
    plant=${plant%%.*}
    # Only a generated plant has adams.
    [ "$plant $2" != "oscillator adams" ] || return
    known=$out/hash/$plant-$2
    model "$1" "$2"
    status=$?
    read_value hash
    hash=$value
    case $hash in
    *[!0-9a-f]*) status=1 ;;
    ????????????????) ;;
    *) status=1 ;;
    esac
    [ -f "$known" ] || echo "$hash" >"$known"
    read -r known_hash <"$known"
    [ $status -eq 0 ] && [ "$hash" = "$known_hash" ]
    expect $? "$plant, $2: $variant, $hash"
    [ "$port" != mps2 ] || {
        counted "$2"
        expect $? "$plant, $2: $instructions instructions on every step"
    }
}

# everywhere: the plants and methods that the script's `wanted` says: on the host without optimisation by gcc and by
# tcc, with it by gcc and by clang, and last on the Cortex-M4F.
everywhere()
{
    for place in "host host $CC -O0" "tcc host tcc -O0 $quick_flags" "optimised host $CC -O2" \
        "clang host clang -O2" \
        "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
        # shellcheck disable=SC2086
        variant $place
        result $? "$variant: core and port compile"
        for method in $METHODS; do
            models_of "$method"
            for scene in $models models/oscillator.c; do
                ! wanted "$scene" "$method" || same "$scene" "$method"
            done
        done
    done
}
