#!/bin/sh
# Files that isoc writes together: if the disk refuses the name of the second, the first one is as it was, or is not
# there.
. tests/host/test.sh
begin scenes/write

# The n-th file that is renamed is refused.
cat >"$out/refuse.c" <<'C'
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
int rename(const char *old, const char *new)
{
    static int count;
    if (++count == atoi(getenv("REFUSED"))) {
        errno = EIO;
        return -1;
    }
    return renameat(AT_FDCWD, old, AT_FDCWD, new);
}
C
"$CC" -shared -fPIC -D_POSIX_C_SOURCE=200809L "$out/refuse.c" -o "$out/refuse.so"
result $? "a library refuses a rename"

# compile SCENE [REFUSED]: into $out/plant.
compile()
{
    REFUSED=${2-0} LD_PRELOAD=$PWD/$out/refuse.so build/isoc "models/$1.scene" -o "$out/plant" >"$out/said" 2>&1
}

files()
{
    (cd "$out/plant" && ls && cat ./*)
}

compile pendulum && [ "$(ls "$out/plant")" = 'plant.c
plant.h' ]
result $? "control: where none is refused there are both, and nothing else"
files >"$out/before"
for refused in 1 2; do
    ! compile tree $refused && files | cmp -s - "$out/before"
    result $? "where rename $refused is refused, the old files are there, and nothing else"
done
rm -rf "$out/plant"
! compile tree 2 && [ -z "$(ls "$out/plant")" ]
result $? "where there were none, there are none"
compile tree && ! files | cmp -s - "$out/before"
result $? "control: the other scene gives other files"
finish
