#!/bin/sh
# A sweep by Slurm, on a controller and one node that are started here: 10,000 runs, killed twice, have the bytes of
# those of this machine alone. Needs slurmctld, slurmd and munged, and to be root; says what is not there.
. tests/host/test.sh
. tests/host/project.sh
begin slurm
PATH=$PATH:/usr/sbin

# skipped WHY
skipped()
{
    echo "ok 1 # SKIP $1"
    echo 1..1
    exit 0
}
for tool in slurmctld slurmd sbatch squeue scancel munged; do
    command -v $tool >/dev/null || skipped "$tool is missing: apt-get install slurmctld slurmd slurm-client munge"
done
[ "$(id -u)" -eq 0 ] || skipped "it takes root to start a node of Slurm"

here=$(mktemp -d)
host=$(hostname -s)
SLURM_CONF=$here/slurm.conf
export SLURM_CONF
mkdir "$here/state" "$here/spool"
cat >"$SLURM_CONF" <<END
ClusterName=sweep
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=27817
SlurmdPort=27818
AuthType=auth/munge
AuthInfo=socket=$here/munge.socket
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
SlurmctldLogFile=$here/slurmctld.log
SlurmdLogFile=$here/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
head -c 1024 /dev/urandom >"$here/munge.key"
chmod 400 "$here/munge.key"
munged --foreground --force --key-file="$here/munge.key" --socket="$here/munge.socket" --pid-file="$here/munge.pid" --log-file="$here/munge.log" \
    --seed-file="$here/munge.seed" >"$here/munge.out" 2>&1 &
munge=$!
waited $munge test -S "$here/munge.socket"
slurmctld -D >"$here/out" 2>&1 &
controller=$!
slurmd -D >"$here/out" 2>&1 &
node=$!
trap 'kill $node $controller $munge; wait; rm -rf "$here"' EXIT
waited $controller eval 'sinfo -h -o %t 2>/dev/null | grep -q idle'
result $? "a controller and a node of Slurm run here"

cp models/cart_pole.scene "$out/slurm_cart.scene"
set='rod_mass = normal(0.2, 0.01) kg; half_length = uniform(200, 300) mm'

# sweep ENGINE; its table is then $table.
sweep()
{
    tools/isochron sweep "$out/slurm_cart.scene" --seconds 1 --set "$set" --runs 10000 --of 'max pole; hash' --lanes 1 --engine "$1" \
        >"$out/output" 2>"$out/errors" </dev/null
    sweep_status=$?
    table=$(value table)
    return $sweep_status
}

# killed PARTS: begins it by Slurm, and kills it and its jobs when so many parts are there.
killed()
{
    killed_parts=$(python3 -B tests/tools/sweep/kill.py "${table%/*}" "$1" tools/isochron sweep "$out/slurm_cart.scene" --seconds 1 \
        --set "$set" --runs 10000 --of 'max pole; hash' --lanes 1 --engine slurm) && scancel --signal=KILL -u root && scancel -u root
    killed_status=$?
    waited $node eval '! squeue -h | grep -q .'
    killed_parts=$(find "${table%/*}" -path '*/parts/*.tsv' | wc -l)
    echo "# killed with $killed_parts of 256 parts"
    [ $killed_status -eq 0 ] && [ "$killed_parts" -lt 256 ] && [ ! -e "$table" ]
}

sweep local && cp "$table" "$out/whole.tsv"
expect $? "10,000 runs on this machine"
rm -rf "${table%/*}"
killed 20 && killed 100
expect $? "killed twice, with their jobs"
sweep slurm && cmp -s "$table" "$out/whole.tsv"
expect $? "it went on to the same bytes, by Slurm"
rm -rf build/sweep/*slurm_cart
finish
