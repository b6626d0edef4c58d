#!/usr/bin/env bash
# The assistant linked to a real LinuxCNC that simulates a lathe without a screen: an operator's commands write the pins,
# ask, read N_cor back and turn the spindle at it.
# Configuration, wiring and NC program are those of the manual's page "The assistant at the machine".
#   linked_linuxcnc.sh LATHELIER_CLI PAGE.md
set -euo pipefail
cli=$(realpath "$1")
page=$(realpath "$2")
here=$(dirname "$(realpath "$0")")/linuxcnc

# An ordinary user's: the real-time side refuses root.
folder=$(mktemp -d -t lathelier-linuxcnc-XXXXXX)
cp "$here"/lathe.* "$folder"
cp "$cli" "$folder/lathelier-cli"
cd "$folder"
export LC_ALL=C.UTF-8 HOME=$folder PATH=/usr/sbin:/usr/bin:/sbin:/bin
as_user() { if ((EUID == 0)); then setpriv --reuid=nobody --regid=nogroup --clear-groups "$@"; else "$@"; fi; }
fail() { echo "FAILED: $*" >&2; tail -n 5 linuxcnc.log log.jsonl | cut -c1-300 >&2 || true; exit 1; }
soon() { for _ in $(seq 100); do "$@" > /dev/null 2>&1 && return 0; sleep 0.1; done; fail "not within ten seconds: $*"; }

# What was started in this folder, its real-time part too, which belongs to root.
kill_linuxcnc() {
    local pid
    for pid in $(pgrep -x 'linuxcnc|linuxcncrsh|linuxcncsvr|milltask|io|rtapi_app|halcmd' || true); do
        { tr '\0' '\n' < "/proc/$pid/environ"; } 2> /dev/null | grep -qF "$folder" && kill -9 "$pid" || true
    done
}

# block LANGUAGE: the blocks of the page in it.
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$page" | grep -v '^```'; }

control=
assistant=
stop() {
    set +e
    [[ -n $control ]] && kill "$control" 2> /dev/null
    for _ in $(seq 100); do kill -0 "$control" 2> /dev/null || break; sleep 0.1; done
    pkill -f "$folder/lathelier-cli"
    kill_linuxcnc
    as_user halrun -U > /dev/null 2>&1
    sleep 0.3
    cd /
    rm -rf "$folder"
}
trap stop EXIT

# The spindle of the papers; with a bar of 32 x 262.25 mm in it its least real part lies at 229.6 Hz.
echo '{"springs": {"radial_N_mm": 14850, "tilt_N_mm_rad": 198.3e6, "loss_factor": 0.06}}' > spindle.json
cat > assist.json << END
{"schema": "lathelier-assist", "schema_version": 1,
 "inputs": {"spindle": {"path": "spindle.json"}},
 "limits": {"highest_rpm": 6000}, "program": {"clearance_mm": 20},
 "linuxcnc": {"component": "lathelier", "program_port": 5117}}
END
cat > shaft.ngc << END
G18 G21 G90 G7
G97 S500 M3
G0 X36 Z2
G1 X32 Z2 F0.2
G1 Z-60
M5
M2
END
cat > assistant.sh << END
#!/bin/sh
exec $folder/lathelier-cli assist --link linuxcnc --config $folder/assist.json --log $folder/log.jsonl
END
chmod 755 assistant.sh lathelier-cli
block hal | sed "s#lathelier-cli .*#$folder/assistant.sh#" >> lathe.hal
grep -q "net assist-run" lathe.hal && grep -q "assistant.sh" lathe.hal || fail "the page has no wiring"
{ block ngc; echo "G4 P0.5"; echo M5; echo M2; } > stable_speed.ngc
grep -q "call \[32\]" stable_speed.ngc || fail "the page has no NC program"
sed 's/call \[32\]/call [-32]/' stable_speed.ngc > refused.ngc
block json | head -7 > page.json
./lathelier-cli inspect page.json > /dev/null || fail "the configuration of the page"
if ((EUID == 0)); then chown -R nobody:nogroup "$folder"; fi

# Without a machine, as the page begins.
mkdir try
(cd try && block sh | sed '/^sudo /,$d' > ../try.sh && PATH=$folder:$PATH bash -euo pipefail ../try.sh) > try.txt 2>&1 ||
    fail "the page's try: $(cat try.txt)"
grep -q "3237" try.txt && grep -q "1 exchanges, 0 answered otherwise" try.txt || fail "the page's try: $(cat try.txt)"

as_user linuxcnc "$folder/lathe.ini" > linuxcnc.log 2>&1 &
control=$!

pin() { as_user halcmd getp "$1" 2> /dev/null || as_user halcmd gets "$1"; }
is() { [[ $(pin "$1") =~ ^$2(\.0*)?$ ]]; }
connected() { exec 3<> /dev/tcp/127.0.0.1/5117; }
soon connected
connected
say() { printf '%s\r\n' "$1" >&3; sleep 0.1; }
mdi() { say "set mdi $1"; sleep 0.2; }
for line in "hello EMC operator 1" "set enable EMCTOO" "set estop off" "set machine on" "set home -1"; do say "$line"; done
sleep 1
say "set mode mdi"

# The case of the paper: D 32 mm, v_c 290 m/min.
mdi "M68 E0 Q32"
mdi "M68 E1 Q262.25"
mdi "M68 E2 Q290"
mdi "M68 E5 Q1"
soon is lathelier.answered 1
is lathelier.state 1 || fail "state $(pin lathelier.state)"
is lathelier.n-cor-rpm 3237 || fail "N_cor $(pin lathelier.n-cor-rpm)"
mdi "M66 E0 L0"
mdi "M3 S#5399"
soon is spindle.0.speed-out 3237

# A spindle that turns: refused, and nothing is written.
mdi "M68 E2 Q200"
mdi "M68 E5 Q2"
soon is lathelier.answered 2
is lathelier.state 12 || fail "state $(pin lathelier.state) with a spindle that turns"
is lathelier.n-cor-rpm 3237 || fail "N_cor was written though the spindle turns"
mdi "M5"
soon is spindle.0.on FALSE

# Out of range: told, and nothing is written.
mdi "M68 E0 Q-3"
mdi "M68 E5 Q3"
soon is lathelier.answered 3
is lathelier.state 10 || fail "state $(pin lathelier.state) for a diameter below zero"
is lathelier.n-cor-rpm 3237 || fail "N_cor was written out of range"

# Diameter and length of the program that is loaded: 32 and 62 + 20 mm.
say "set mode auto"
sleep 0.3
say "set open $folder/shaft.ngc"
sleep 0.5
say "set mode mdi"
mdi "M68 E0 Q0"
mdi "M68 E1 Q0"
mdi "M68 E2 Q290"
mdi "M68 E5 Q4"
soon is lathelier.answered 4
is lathelier.state 1 || fail "state $(pin lathelier.state) with a program"
grep -q '"request":4.*"diameter_mm":32.0,"length_mm":82.0' log.jsonl || fail "diameter and length of the program"

# A second assistant on this control is refused.
code=0
as_user ./lathelier-cli assist --link linuxcnc --config assist.json --once --json second.json > /dev/null 2>&1 || code=$?
[[ $code == 4 ]] && grep -q '"code": "link_taken"' second.json || fail "a second assistant: $code"
mdi "M68 E5 Q5"
soon is lathelier.answered 5

# Fifty requests in a row, each with the speed of its own values.
for i in $(seq 6 55); do
    speed=$((i % 2 == 0 ? 290 : 200))
    printf 'set mdi M68 E2 Q%s\r\n' "$speed" >&3
    sleep 0.03
    printf 'set mdi M68 E5 Q%s\r\n' "$i" >&3
    soon is lathelier.answered "$i"
done
[[ $(grep -c '"event":"exchange"' log.jsonl) == 55 ]] || fail "exchanges: $(grep -c '"event":"exchange"' log.jsonl)"
./lathelier-cli assist --replay log.jsonl --config assist.json || fail "the log is answered otherwise"

# The NC program of the page: the spindle turns at the stable speed; where the request is refused it does not turn.
run() {
    : > "$2"
    say "set mode auto"
    sleep 0.3
    say "set open $folder/$1"
    sleep 0.5
    say "set run"
    for _ in $(seq 25); do pin spindle.0.speed-out >> "$2"; sleep 0.1; done
    say "set mode mdi"
    sleep 0.3
}
run stable_speed.ngc speeds
grep -qE "^3237(\.0*)?$" speeds || fail "the NC program of the page: $(sort -u speeds | tr '\n' ' ')"
is lathelier.state 0 || fail "state $(pin lathelier.state) without a request"
run refused.ngc speeds
grep -qvE "^0(\.0*)?$" speeds && fail "the spindle turned though the request was refused"
tail -n 1 log.jsonl | grep -q '"state_name":"out_of_range"' || fail "not refused: $(tail -n 1 log.jsonl)"

# LinuxCNC ends, and the assistant with it.
say "shutdown"
exec 3>&-
for _ in $(seq 150); do kill -0 "$control" 2> /dev/null || break; sleep 0.1; done
kill -0 "$control" 2> /dev/null && fail "LinuxCNC did not end"
control=
for _ in $(seq 50); do pgrep -f "$folder/lathelier-cli" > /dev/null || break; sleep 0.1; done
pgrep -f "$folder/lathelier-cli" > /dev/null && fail "the assistant outlived LinuxCNC"
code=0
as_user ./lathelier-cli assist --link linuxcnc --config assist.json --once > /dev/null 2> error.txt || code=$?
[[ $code == 4 ]] && grep -q "LinuxCNC does not run" error.txt || fail "without LinuxCNC: $code $(cat error.txt)"

# A LinuxCNC that is killed is noticed, and the same assistant is linked to the next one. It is started by hand here: its
# pins are not wired, and a machine whose `running` is not wired counts as one that runs.
cp "$here/lathe.hal" lathe.hal
start() {
    as_user linuxcnc "$folder/lathe.ini" > linuxcnc.log 2>&1 &
    control=$!
    soon is spindle.0.speed-out 0
}
opened() { (($(grep -c '"event":"opened"' again.jsonl) >= $1)); }
set_pin() { as_user halcmd setp "lathelier.$1" "$2"; }
start
as_user "$folder/lathelier-cli" assist --link linuxcnc --config assist.json --log again.jsonl > /dev/null 2>&1 &
assistant=$!
soon opened 1
set_pin diameter-mm 32
set_pin length-mm 262.25
set_pin cutting-speed-m-min 290
set_pin request 1
soon is lathelier.answered 1
is lathelier.state 12 || fail "state $(pin lathelier.state) with a running that is not wired"
set_pin running 0
set_pin request 2
soon is lathelier.answered 2
is lathelier.n-cor-rpm 3237 || fail "N_cor $(pin lathelier.n-cor-rpm) by hand"
kill_linuxcnc
soon grep -q '"event":"lost"' again.jsonl
kill -0 "$assistant" || fail "the assistant ended with a LinuxCNC that was killed"
wait "$control" 2> /dev/null || true
as_user halrun -U > /dev/null 2>&1 || true
start
soon opened 2
set_pin running 0
set_pin diameter-mm 32
set_pin length-mm 262.25
set_pin cutting-speed-m-min 290
set_pin request 3
soon is lathelier.answered 3
is lathelier.n-cor-rpm 3237 || fail "N_cor $(pin lathelier.n-cor-rpm) after the second link"
pkill -f "$folder/lathelier-cli"
for _ in $(seq 50); do pgrep -f "$folder/lathelier-cli" > /dev/null || break; sleep 0.1; done
pgrep -f "$folder/lathelier-cli" > /dev/null && fail "the assistant does not end"
echo "All answered."
