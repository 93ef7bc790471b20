#!/bin/sh
# The request of a run, in C (core/record/request.h): the tick of a snapshot to take, and the snapshot to begin at.
#
#     request.sh TICK|'' FILE|''
at=ISO_REQUEST_NONE
[ -z "$1" ] || at="UINT64_C($1)"
printf '#include "core/record/request.h"\n\n'
if [ -n "$2" ]; then
    printf 'static const unsigned char from[] = {\n'
    od -An -v -tx1 "$2" | sed 's/ \([0-9a-f][0-9a-f]\)/0x\1,/g'
    printf '};\n\nconst iso_request iso_the_request = {.at = %s, .from = from, .from_bytes = sizeof from};\n' "$at"
else
    printf 'const iso_request iso_the_request = {.at = %s};\n' "$at"
fi
