#!/bin/sh
# The local error that a checked method tells, beside the true one, where it is hard to tell: long steps in chains and
# close encounters, and steps whose end is put onto closures. tests/core/methods/estimate/estimate.t has every method on
# one plant.
. tests/host/test.sh
begin estimate_mechanisms
one_isoc
. tests/core/methods/order/settled.sh
EXTRA=-O0 # compiled once and run shortly
program mechanisms.o -c tests/core/methods/estimate/mechanisms.c
result $? "tests/core/methods/estimate/mechanisms.c compiles"

# plant NAME SOURCE [FLAG]: the program of a plant in C.
plant()
{
    settled "$1" "$2" "$out/mechanisms.o" "${3-}"
    result $? "$1 builds"
}

# scene NAME METHOD [FLAG]: that of $out/NAME.scene, with what the method needs.
scene()
{
    isoc "$out/$1.summary" '' "$out/$1.scene" -o "$out/$1" --real double --method "$2" && plant "$1" "$out/$1/plant.c" ${3:+"$3"}
}

# Chains of rods that fall from the horizontal.
python3 tools/lab/chain.py 3 planar >"$out/triple.scene"
scene triple bdf4 -DSETTLE=NULL
joined triple "$out/triple.run" 5 200 heun rk4 ab4 abm4 bdf4 rosenbrock adams -- adams_formula
python3 tools/lab/chain.py 30 planar >"$out/chain.scene"
scene chain rk4 -DSETTLE=NULL
joined chain "$out/chain.run" 3 200 heun rk4 ab4 abm4 adams -- adams_formula

plant pleiades tests/core/methods/estimate/pleiades.c -DSETTLE=NULL
joined pleiades "$out/pleiades.run" 3 1000 heun rk4 ab4 abm4 adams -- adams_formula

# With a projection. The top turns at 150 rad/s: Milne's estimate needs shorter steps there.
cp tests/core/methods/estimate/heavy_top.scene tests/core/methods/order/spatial.scene "$out"
scene spatial bdf4
joined spatial "$out/spatial.run" 1 1000 heun rk4 ab4 abm4 bdf4 rosenbrock adams -- unsettled
scene heavy_top bdf4
joined heavy_top "$out/heavy_top.run" 0.3 2000 heun rk4 ab4 rosenbrock adams -- unsettled abm4 abm4_pec
joined "heavy_top, shorter steps" "$out/heavy_top.run" 0.1 16000 abm4 abm4_pecece bdf4

# The estimate as an output, of every kind of method.
{ cat tests/core/methods/estimate/heavy_top.scene && echo "output error = local_error"; } >"$out/told.scene"
for method in rk4 abm4 bdf4 adams; do
    isoc "$out/told.summary" '' "$out/told.scene" -o "$out/told" --real double --method $method &&
        EXTRA=-O0 program told.o -c "$out/told/plant.c"
    result $? "$method tells it in an output"
done
finish
