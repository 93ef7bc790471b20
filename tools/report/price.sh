#!/bin/sh
# One method in float: $dir/float-METHOD/instructions, those of a step on the Cortex-M4F.
#
#     price.sh float METHOD
. tools/report/common.sh
mkdir -p "$dir/float-$2"
instructions_m4f float "$2" >"$dir/float-$2/instructions" || exit 255
