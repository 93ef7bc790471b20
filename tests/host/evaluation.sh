# shellcheck shell=sh
# Plants that are compared in one program; read after tests/host/test.sh and `begin`.

# as_evaluation NAME [FLAG...]: the plant in $out/NAME as the objects $out/NAME.plant.o, whose symbols are its own, and $out/NAME.o,
# the evaluation NAME.
as_evaluation()
{
    evaluation_name=$1
    shift
    # shellcheck disable=SC2086
    "$CC" $FLAGS $REAL_FLAG "$@" -c "$out/$evaluation_name/plant.c" -o "$out/$evaluation_name.plant.o" &&
        objcopy --redefine-sym "iso_the_plant_$real=${evaluation_name}_plant" --keep-global-symbol "${evaluation_name}_plant" \
            --redefine-sym "iso_the_derivative_$real=${evaluation_name}_slope" --keep-global-symbol "${evaluation_name}_slope" \
            "$out/$evaluation_name.plant.o" &&
        "$CC" $FLAGS $REAL_FLAG "-DPLANT=${evaluation_name}_plant" "-DSLOPE=${evaluation_name}_slope" \
            "-DEVALUATION=$evaluation_name" -c tests/formulation/evaluation.c -o "$out/$evaluation_name.o"
}
