# shellcheck shell=sh
# Pictures read back, and what they must show; read after tests/host/test.sh and `begin`.

# reads_picture: builds the program of tests/tools/lab/picture/.
reads_picture()
{
    EXTRA=-O0 program picture tests/tools/lab/picture/*.c
}

# shows SVG [POINTS all|drawn|covered]...: whether the picture shows these points, and has no text that is cut off. If
# not, it is said in comments.
shows()
{
    "$out/picture" "$@" >"$out/shown" 2>&1
    shows_status=$?
    [ $shows_status -eq 0 ] || head -n 20 "$out/shown" | sed 's/^/# /'
    return $shows_status
}
