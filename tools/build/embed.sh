#!/bin/sh
# Files as arrays of bytes in C, for tools/isoc/base/embedded.h.
#
#     embed.sh ARRAY FILE...
printf '#include "tools/isoc/base/embedded.h"\n\nconst embedded_file %s[] = {\n' "$1"
shift
for file in "$@"; do
    printf '{"%s", (const char[]){\n' "$file"
    od -An -v -to1 "$file" | sed 's/ \([0-7]*\)/0\1,/g'
    printf '0}},\n'
done
printf '{0, 0}};\n'
