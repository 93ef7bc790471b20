#!/bin/sh
# One method in double: $dir/double-METHOD/bench, with its errors at steps of twice the scene's and at the scene's, with
# the fewest steps from which on the error stays at most $error, 0 if that takes steps shorter than 1 us, and `-`. Of
# adams, which has no error at a step, `- -`, the steps and the largest tolerance from which on it does; 0 if there is none.
#
#     search.sh double METHOD
. tools/measure/methods.sh
of=$dir/double-$2
take "$2"
(variable double "$2") || fail "$2 cannot be built for $SCENE; METHODS='...' chooses others"
if [ -n "$TOLERANCE" ]; then
    build/accuracy loosest "$of/drive" "$time" "$error" "$dir/reference.txt"
else
    build/accuracy fewest "$of/drive" "$time" "$coarsest" "$error" "$dir/reference.txt"
fi >"$of/bench" || exit 255
progress "$@"
