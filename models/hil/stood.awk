# Whether the pole stood: upright to 2 degrees in the last second of the run, and the cart between the stops at all
# times. The table of the run, by the names of its columns; awk -F, -f.
NR == 1 {
    for (i = 1; i <= NF; i++) {
        column[$i] = i
    }
    next
}

{
    time[NR] = $column["t"]
    pole[NR] = size($column["pole"]) * 180 / 3.14159265358979
    cart = larger(cart, size($column["cart"]))
}

END {
    for (row = 2; row <= NR; row++) {
        last = time[row] >= time[NR] - 1 ? larger(last, pole[row]) : last
    }
    stood = NR > 1 && last < 2 && cart < 0.4
    printf "%s: pole within %.2f deg of upright in the last second (limit 2 deg), cart within %.3f m (stops at 0.4 m)\n",
        stood ? "stood" : "fell", last, cart
    exit !stood
}

function size(x)
{
    return x < 0 ? -x : x
}

function larger(x, y)
{
    return x > y ? x : y
}
