#!/bin/sh
# A sweep on machines over ssh, by a server of ssh that is started here, on a port of its own: the table has the bytes
# of this machine alone, also where one of the machines is not there, and nothing is left on them. Needs sshd, ssh,
# rsync and GNU parallel; says what is not there.
. tests/host/test.sh
. tests/host/project.sh
begin hosts
PATH=$PATH:/usr/sbin

# skipped WHY
skipped()
{
    echo "ok 1 # SKIP $1"
    echo 1..1
    exit 0
}
for tool in sshd ssh ssh-keygen rsync parallel; do
    command -v $tool >/dev/null || skipped "$tool is missing: apt-get install openssh-server rsync parallel"
done

here=$(mktemp -d)
for key in host user; do
    ssh-keygen -q -t ed25519 -N '' -f "$here/$key"
done
cat >"$here/server" <<END
Port 27822
ListenAddress 127.0.0.1
HostKey $here/host
AuthorizedKeysFile $here/user.pub
StrictModes no
UsePAM no
PasswordAuthentication no
PidFile none
END
cat >"$here/client" <<END
Host here there
HostName 127.0.0.1
Port 27822
Host nowhere
HostName 127.0.0.1
Port 27823
Host *
IdentityFile $here/user
UserKnownHostsFile $here/known
StrictHostKeyChecking accept-new
LogLevel ERROR
END
[ "$(id -u)" -ne 0 ] || mkdir -p /run/sshd
"$(command -v sshd)" -D -f "$here/server" -E "$here/log" &
server=$!
trap 'kill $server; wait; rm -rf "$here"' EXIT
waited $server eval 'ssh -F "$here/client" here true 2>/dev/null' || skipped "sshd does not run here: $(head -n 1 "$here/log")"
PARALLEL_SSH="ssh -F $here/client"
export PARALLEL_SSH

# sweep ARGUMENT...: two runs; the table is then $table.
sweep()
{
    tools/isochron sweep "$out/hosts_cart.scene" --seconds 0.1 --set 'rod_mass = 0.1, 0.2 kg' --of 'max pole; hash' "$@" \
        >"$out/output" 2>"$out/errors" </dev/null
    sweep_status=$?
    table=$(value table)
    return $sweep_status
}

cp models/cart_pole.scene "$out/hosts_cart.scene"
sweep && cp "$table" "$out/whole.tsv"
expect $? "two runs on this machine"
for hosts in '1/here 1/there' '1/here 1/nowhere'; do
    rm -f "${table%/*}"/*/parts/*.tsv "$table"
    sweep --engine parallel --hosts "$hosts" && cmp -s "$table" "$out/whole.tsv" && [ "$(find "${table%/*}"/*/parts -name '*.tsv' | wc -l)" -eq 2 ]
    expect $? "on $hosts: the same bytes"
done
folder=$(echo "${table%/*}"/*/plan)
folder=${folder%/plan}
[ -n "$folder" ] && ! ssh -F "$here/client" here test -e ".isochron/sweep-${folder##*/}"
result $? "nothing is left on a machine"
rm -f "${table%/*}"/*/parts/*.tsv "$table"
! sweep --engine parallel --hosts 1/nowhere && grep -q '2 parts are absent; the same command goes on' "$out/errors" && [ ! -e "$table" ]
expect $? "no machine is there: that is said, and there is no table"
rm -rf build/sweep/*hosts_cart
finish
