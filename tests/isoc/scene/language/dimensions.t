#!/bin/sh
# The rule about angles in formulas: a radian is the number one, whatever the operator, the function and the order.
# Random formulas with dimensions against a checker that shares no code with isoc: what is refused, and the unit of the
# others.
. tests/host/test.sh
begin language/dimensions

python3 -B tests/isoc/scene/language/dimensions.py build/tests/requests "$out" 250 20261122
result $? 'random formulas: isoc accepts and refuses what an independent checker does, and shows the same unit'
python3 -B tests/isoc/scene/language/dimensions.py build/tests/requests "$out" 60 7 BROKEN
[ $? -eq 1 ]
result $? 'control: a checker for which an angle is a dimension differs'
finish
