# shellcheck shell=sh
# Plants that are compared in one program; read after tests/host/test.sh and `begin`.

# as_evaluation NAME [FLAG...]: the plant in $out/NAME as the object $out/NAME.o, which is the evaluation NAME, and has
# no other name in common with those beside it.
as_evaluation()
{
    evaluation_name=$1
    shift
    # shellcheck disable=SC2086
    "$CC" $FLAGS $REAL_FLAG "$@" "-DPLANT_FILE=\"$out/$evaluation_name/plant.c\"" "-DEVALUATION=$evaluation_name" \
        "-Diso_the_plant_$real=${evaluation_name}_plant" "-Diso_the_derivative_$real=${evaluation_name}_slope" \
        "-Dplant_model=${evaluation_name}_model" "-Dplant_derivative=${evaluation_name}_derivative" \
        -c tests/isoc/dynamics/formulation/evaluation.c -o "$out/$evaluation_name.o"
}
