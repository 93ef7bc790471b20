# shellcheck shell=sh
# Plants under memcheck with all of their memory marked undefined (tests/promises/poison.c): many in one program; read
# after tests/host/test.sh and `begin`.

# batch DIR float|double [COMPILER]: begins a program of many plants in that real.
batch()
{
    folder=$out/$1
    real "$2"
    compiler=${3:-$CC}
    count=0
    mkdir -p "$folder"
}

# add NAME PLANT [FLAG...]: the plant's object, under symbols of its own, and a line of the list of cases. The object
# is the one that promises/same_bits.t compiles.
add()
{
    count=$((count + 1))
    printf '%s\n' "    {\"$1\", &plant_$count}," >>"$folder/cases"
    echo "extern const iso_plant plant_$count;" >>"$folder/plants"
    shift
    # shellcheck disable=SC2086
    $compiler $FLAGS $REAL_FLAG -c "$@" -o "$folder/$count.o" || { rm -f "$folder/$count.o" && return; }
    set -- --redefine-sym "iso_the_plant_$real=plant_$count"
    for add_symbol in iso_the_derivative_$real plant_derivative plant_model; do
        set -- "$@" --redefine-sym "$add_symbol=${add_symbol}_$count"
    done
    objcopy "$@" "$folder/$count.o"
}

# generated SCENE METHOD [OPTION...]: the plant of a scene, with these options of isoc.
generated()
{
    generated_of=$1
    generated_by=$2
    shift 2
    isoc /dev/null '' "$generated_of" -o "$folder/plant" --method "$generated_by" --real "$real" "$@"
    generated_of=${generated_of##*/}
    add "${generated_of%.scene}, $generated_by${1:+, $*}, $real" "$folder/plant/plant.c"
}

# watch: the program of all that was added, under memcheck; no program where one was not built.
watch()
{
    {
        echo '#include "tests/promises/poison.h"'
        cat "$folder/plants"
        echo 'const poison_case poison_cases[] = {'
        cat "$folder/cases"
        echo '    {NULL, NULL},'
        echo '};'
    } >"$folder/list.c"
    # shellcheck disable=SC2086
    $CC $FLAGS $REAL_FLAG -gdwarf-4 tests/promises/poison.c "$folder/list.c" "$folder"/*.o -o "$folder/program" &&
        valgrind --quiet "$folder/program" 2>"$folder/errors"
}
