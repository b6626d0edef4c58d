#!/usr/bin/env bash
# The commands of the manual's page "From one part to a thousand", run as they stand there, on a GNU parallel over ssh, a
# Slurm and a PostgreSQL of the test's own on this machine: all ways give the same canonical export, and the three bad
# parts are found.
#   many_machines.sh LATHELIER_CLI PAGE.md
set -euo pipefail
cli=$(realpath "$1")
page=$(realpath "$2")

# Other users have to reach the folder: PostgreSQL refuses to run as root.
folder=$(mktemp -d -t lathelier-machines-XXXXXX)
chmod 755 "$folder"
cd "$folder"
mkdir bin
ln -s "$cli" bin/lathelier-cli
export PATH=$folder/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8
host=$(hostname)
me=$(id -un)

stop() {
    set +e
    for pid_file in ssh/pid slurm/d.pid slurm/ctld.pid munge/pid; do [[ -s $pid_file ]] && kill "$(cat "$pid_file")"; done
    [[ -d postgres/data ]] && as_postgres "$postgres/pg_ctl" -D "$folder/postgres/data" -m immediate stop > /dev/null
    cd /
    rm -rf "$folder"
}
trap stop EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

# postgres: a server that is reached by a socket in the folder, the service "shop", and by the network under TLS, as the
# host shop.test. 0.0.0.0 leads to this machine too, but is no address of it to the archive.
postgres=$(ls -d /usr/lib/postgresql/*/bin | tail -1)
as_postgres() { if ((EUID == 0)); then (cd / && setpriv --reuid=nobody --regid=nogroup --clear-groups "$@"); else "$@"; fi; }
start_postgres() {
    mkdir -p postgres/socket
    if ((EUID == 0)); then chown -R nobody:nogroup postgres; fi
    as_postgres "$postgres/initdb" -D "$folder/postgres/data" -U "$me" --auth=trust -E UTF8 --no-sync > postgres.log
    for name in server other; do
        openssl req -x509 -nodes -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -subj /CN=shop.test \
            -addext subjectAltName=DNS:shop.test -keyout "postgres/$name.key" -out "postgres/$name.crt" 2>> openssl.log
    done
    if ((EUID == 0)); then chown nobody postgres/*.key; fi
    printf '%s\n' "local all all trust" "hostssl all all 127.0.0.1/32 trust" > postgres/data/pg_hba.conf
    as_postgres "$postgres/pg_ctl" -D "$folder/postgres/data" -w -l "$folder/postgres/log" -o "-p $pg_port \
        -c listen_addresses=127.0.0.1 -c unix_socket_directories='$folder/postgres/socket' -c fsync=off -c ssl=on \
        -c ssl_cert_file='$folder/postgres/server.crt' -c ssl_key_file='$folder/postgres/server.key'" start >> postgres.log
    chmod 777 postgres/socket
    "$postgres/createdb" -h "$folder/postgres/socket" -p "$pg_port" -U "$me" shop
    printf '[shop]\nhost=%s\nport=%s\ndbname=shop\nuser=%s\n' "$folder/postgres/socket" "$pg_port" "$me" > service.conf
    export PGSERVICEFILE=$folder/service.conf
}

# ssh: node1 and node2 are this machine.
start_ssh() {
    mkdir -m 700 ssh
    ssh-keygen -q -t ed25519 -N "" -f ssh/host
    ssh-keygen -q -t ed25519 -N "" -f ssh/user
    cat > ssh/server.conf << END
Port $ssh_port
ListenAddress 127.0.0.1
HostKey $folder/ssh/host
AuthorizedKeysFile $folder/ssh/user.pub
PidFile $folder/ssh/pid
StrictModes no
UsePAM no
PasswordAuthentication no
SetEnv PATH=$PATH
END
    cat > ssh/client.conf << END
Host node1 node2
    HostName 127.0.0.1
    Port $ssh_port
    IdentityFile $folder/ssh/user
    StrictHostKeyChecking no
    UserKnownHostsFile /dev/null
    LogLevel ERROR
END
    if ((EUID == 0)); then mkdir -p /run/sshd; fi
    /usr/sbin/sshd -f ssh/server.conf
    export PARALLEL_SSH="ssh -F $folder/ssh/client.conf"
}

# slurm: one controller, one node.
start_slurm() {
    mkdir -m 700 munge
    mkdir socket slurm
    dd if=/dev/urandom of=munge/key bs=1024 count=1 status=none
    chmod 400 munge/key
    munged --force --key-file="$folder/munge/key" --socket="$folder/socket/munge" --pid-file="$folder/munge/pid" \
        --seed-file="$folder/munge/seed" --log-file="$folder/munge/log" 2> /dev/null
    cat > slurm.conf << END
ClusterName=lathelier
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$((ssh_port + 1))
SlurmdPort=$((ssh_port + 2))
AuthType=auth/munge
AuthInfo=socket=$folder/socket/munge
CredType=cred/munge
SlurmUser=$me
SlurmdUser=$me
StateSaveLocation=$folder/slurm/state
SlurmdSpoolDir=$folder/slurm/spool
SlurmctldPidFile=$folder/slurm/ctld.pid
SlurmdPidFile=$folder/slurm/d.pid
SlurmctldLogFile=$folder/slurm/ctld.log
SlurmdLogFile=$folder/slurm/d.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -i
    slurmd
}

# Ports that nobody has: another test of this kind may run beside.
ssh_port=$((20000 + $$ % 20000))
pg_port=$((ssh_port + 3))
start_postgres || fail "PostgreSQL does not start: $(cat postgres.log)"
start_ssh || fail "sshd does not start"
start_slurm || fail "Slurm does not start"

# The page's own commands: its blocks of the language sh, in their order.
mkdir work
cd work
sed -n '/^```sh$/,/^```$/p' "$page" | grep -v '^```' > ../commands
[[ -s ../commands ]] || fail "the page has no commands"
bash -euo pipefail ../commands > ../said 2>&1 < /dev/null || fail "a command of the page: $(tail -30 ../said)"

# What they left: one export for each way.
for way in plain parallel slurm queue; do
    [[ -s $way.jsonl ]] || fail "$way.jsonl is not there"
    cmp plain.jsonl "$way.jsonl" || fail "$way computed something else"
done
[[ $(grep -c '"verdict":"fail","characteristics"' plain.jsonl) == 3 ]] || fail "not three parts are out of tolerance"
known_bad=$(tr -d ' \n' < day/truth.json | grep -o '"file":"parts/[^"]*","seat_oversize_um":[^,]*,"out_of_tolerance":true' |
    grep -o 'part-[0-9]*.ply')
[[ $(wc -w <<< "$known_bad") == 3 ]] || fail "the truth does not name three bad parts"
for bad in $known_bad; do
    grep -q "\"path\":\"$bad\".*\"verdict\":\"fail\",\"characteristics\"" plain.jsonl || fail "$bad was not found"
done

# Over the network: by TLS to a server whose certificate is known and has its name, and no other way.
archive_over() { # HOST CERTIFICATE [MORE]
    PGSSLROOTCERT=$folder/postgres/$2.crt lathelier-cli archive verify --json said.json \
        "host=$1 hostaddr=0.0.0.0 port=$pg_port dbname=shop user=$me${3:+ $3}" > said.txt 2>&1
}
refuses() { # EXIT_CODE CODE HOST CERTIFICATE [MORE]
    local code=0
    archive_over "${@:3}" || code=$?
    [[ $code == "$1" ]] && grep -q "\"code\": \"$2\"" said.json || fail "${*:3}: exit $code, $(cat said.txt)"
}
archive_over shop.test server || fail "by TLS: $(cat said.txt)"
refuses 3 archive_not_opened shop.test other
refuses 3 archive_not_opened another.test server
refuses 2 tls_required shop.test server sslmode=disable
echo "four ways, one export, three parts found"
