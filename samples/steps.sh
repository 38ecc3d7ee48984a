# Functions for samples/demo and samples/browser, which source this file.

# quietly NAME COMMAND...: writes the command's output to build/logs/NAME.log and shows its end on failure.
quietly() {
    local log=build/logs/$1.log
    shift
    "$@" >"$log" 2>&1 </dev/null || fail_with "$log" "$*"
}

# fail_with LOG COMMAND: shows the end of the log and leaves.
fail_with() {
    tail -n 40 "$1" | cut -c 1-400 >&2
    echo "$0: failed: $2; the whole output is in $1" >&2
    exit 1
}

# show_steps: prints the numbers in lines "DONE ALL ..." as soon as they come. (awk would read ahead: mawk waits for
# 4096 bytes of a pipe.)
show_steps() {
    local done all fifths=0 terminal=false open=false
    [[ -t 1 ]] && terminal=true
    while read -r done all _; do
        [[ $done =~ ^[0-9]+$ && $all =~ ^[1-9][0-9]*$ ]] || continue
        if $terminal; then
            printf '\r  %d of %d steps' "$done" "$all"
            open=true
        elif ((5 * done / all > fifths)); then
            fifths=$((5 * done / all))
            printf '  %d of %d steps\n' "$done" "$all"
        fi
    done
    if $open; then echo; fi
}

# build NAME PRESET OPTION...: builds a preset, with ninja's output in build/logs/NAME.log, and prints how far it is:
# in one line on a terminal, else in a line for each fifth of the steps.
build() {
    local log=build/logs/$1.log preset=$2
    shift 2
    NINJA_STATUS='%f %t ' cmake --build --preset "$preset" "$@" 2>&1 </dev/null | tee "$log" |
        show_steps ||
        fail_with "$log" "cmake --build --preset $preset $*"
}
