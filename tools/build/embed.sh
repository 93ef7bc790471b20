#!/bin/sh
# Files as arrays of bytes in C, for tools/isoc/emit/core_files.h.
#
#     embed.sh FILE...
printf '#include "tools/isoc/emit/core_files.h"\n\nconst core_file core_files[] = {\n'
for file in "$@"; do
    printf '{"%s", (const char[]){\n' "$file"
    od -An -v -to1 "$file" | sed 's/ \([0-7]*\)/0\1,/g'
    printf '0}},\n'
done
printf '{0, 0}};\n'
