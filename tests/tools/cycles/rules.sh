# shellcheck shell=sh
# Programs of a few instructions and what they take by hand, of rules.txt; read by tests/tools/cycles/cycles.t.

# of_core CORE: its lines, with the number of each before it.
of_core()
{
    awk -F ' *[|] *' -v core="$1" -v OFS='|' '$1 == core && $2 != "return" { print ++n, $2, $3, $4 }' tests/tools/cycles/rules.txt
}

# assembly CORE: a program that calls a function, all_rules, which calls a function `rule_N` for each of its lines.
assembly()
{
    of_core "$1" | awk -F '|' -v core="$1" '
        BEGIN {
            avr = core ~ /^atm/
            if (avr) print ".global main\nmain: cli\ncall all_rules\nsleep\nall_rules:"
            else {
                print ".syntax unified\n.thumb\n.global reset\nvectors: .word 0x20008000, reset + 1\n.thumb_func\nreset:"
                print "ldr r0, =0xe000ed88\nldr r1, =0x00f00000\nstr r1, [r0]\ndsb\nisb"
                print "bl all_rules\nldr r0, =0x18\nldr r1, =0x20026\nbkpt 0xab\nb .\n.ltorg"
                print ".type all_rules, %function\nall_rules:\npush {lr}"
            }
        }
        {
            if (avr) printf "ldi r26, 0\nldi r27, 4\nldi r28, 0\nldi r29, 4\nldi r30, 0\nldi r31, 4\ncall rule_%d\n", $1
            else printf "ldr r0, =0x20001000\nbl rule_%d\n", $1
            text = $2
            gsub(/; */, "\n", text)
            functions = functions sprintf(".type rule_%d, %%function\nrule_%d:\n%s\n%s\n", $1, $1, text, avr ? "ret" : "bx lr\n.ltorg")
        }
        END {
            print avr ? "ret" : "pop {pc}\n.ltorg"
            print functions
        }'
}

# counted CORE LISTING TRACE: for each line its instructions, what it took, and what it has to take, with the return.
counted()
{
    back=$(awk -F ' *[|] *' -v core="$1" -v OFS=' ' '$1 == core && $2 == "return" { print $3, $4 }' tests/tools/cycles/rules.txt)
    of_core "$1" >"$2.rules" || return
    parts=
    while IFS='|' read -r number text; do
        parts="$parts rule_$number=rule_$number"
    done <"$2.rules"
    # shellcheck disable=SC2086
    build/cycles tick "tools/measure/cycles/cores/$1.txt" "$2" all_rules "" $parts <"$3" >"$2.ticks" || return
    awk -F '[\t|]' -v least_back="${back% *}" -v most_back="${back#* }" '
        function sum(text, part, n, i, all) {
            gsub(/-/, "+-", text)
            n = split(text, part, "+")
            for (i = 1; i <= n; i++) all += part[i]
            return all
        }
        FNR == NR { took[$2] = $1 == "part" ? $4 " " $5 : took[$2]; next }
        { printf "%s|%s|%s %s\n", $2, took["rule_" $1], sum($3 "+" least_back), sum($4 "+" most_back) }' "$2.ticks" "$2.rules"
}

# untried CORE: the rules of its table of which no line has an instruction, but for those that end a program or wait.
untried()
{
    { of_core "$1" && echo && cat "tools/measure/cycles/cores/$1.txt"; } | awk -F ' *[|] *' '
        # Without conditions and sizes; a rule may name a type, vdiv.f64.
        function is(text, name) {
            if (text == name) return 1
            sub(/[.].*/, "", text)
            if (sub(/[*]$/, "", name)) return index(text, name) == 1
            return text == name || text == name "s" || text == name "eq" || text == name "ne"
        }
        $0 == "" { behind = 1 }
        !behind {
            n = split($2, part, / *; */)
            for (i = 1; i <= n; i++) { sub(/^1: */, "", part[i]); sub(/^2: */, "", part[i]); sub(/ .*/, "", part[i]); tried[part[i]] }
        }
        behind && NF == 6 && !/^#/ && $1 !~ /^(wfi|bkpt|sleep)/ {
            found = 0
            n = split($1, name, " ")
            for (text in tried) for (i = 1; i <= n; i++) found = found || is(text, name[i])
            if (!found) print $1
        }'
}
