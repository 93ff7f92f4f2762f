#!/usr/bin/env bash
# run_targets.sh BUILD SECONDS [TARGET…]: fuzzes for SECONDS in total, as many targets at a time as there are processors, and
# prints a table. Inputs that reach new code are collected in BUILD/corpus/TARGET; those that fail are in BUILD/findings.
# A target stops at its first finding. Exit code 1: there are findings.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
build=$1 seconds=$2
shift 2
targets=("$@")
((${#targets[@]})) || mapfile -t targets < <(ls "$here/corpus")

mkdir -p "$build/corpus" "$build/findings" "$build/logs"
for target in "${targets[@]}"; do
    [[ -d $here/corpus/$target ]] || { printf 'no target %s; there are: %s\n' "$target" "$(ls -x "$here/corpus")" >&2; exit 2; }
done
jobs=$(nproc)
export build here each=$(((seconds * jobs + ${#targets[@]} - 1) / ${#targets[@]}))

fuzz() {
    mkdir -p "$build/corpus/$1"
    # An input of a few kilobytes that takes 20 s or 2 GB is a finding. More is reserved for large pictures, but touched
    # only as their rows arrive.
    PLUMBLINE_FUZZ_TARGET=$1 "$build/plumbline_fuzz" -max_total_time="$each" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=16384 -max_len=20000 \
        -print_final_stats=1 -artifact_prefix="$build/findings/$1-" "$build/corpus/$1" "$here/corpus/$1" \
        >"$build/logs/$1" 2>&1 || true
}
export -f fuzz
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c 'fuzz {}'

findings=0
printf '%-14s %12s %9s %9s  %s\n' target executions inputs findings 'first finding'
for target in "${targets[@]}"; do
    log=$build/logs/$target
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    found=$(sed -n 's/.*Test unit written to //p' "$log" | head -n 1)
    # Without the final statistics it ended in a way of its own, for example without memory.
    [[ -n $executions && -z $found ]] || findings=$((findings + 1))
    printf '%-14s %12s %9s %9s  %s\n' "$target" "${executions:--}" "$(ls "$build/corpus/$target" | wc -l)" \
        "$([[ -n $executions && -z $found ]] && echo 0 || echo 1)" "${found:-$([[ -n $executions ]] || echo "see $log")}"
done
((findings == 0))
