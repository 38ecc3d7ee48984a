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

# build NAME PRESET OPTION...: builds a preset, with ninja's output in build/logs/NAME.log, and prints how far it is:
# in one line on a terminal, else in a line for each fifth of the steps.
build() {
    local log=build/logs/$1.log preset=$2
    shift 2
    NINJA_STATUS='%f %t ' cmake --build --preset "$preset" "$@" 2>&1 </dev/null | tee "$log" |
        awk -v terminal="$([[ -t 1 ]] && echo 1)" '
            !($1 ~ /^[0-9]+$/ && $2 ~ /^[0-9]+$/) { next }
            terminal { printf "\r  %d of %d steps", $1, $2; fflush(); open = 1; next }
            int(5 * $1 / $2) > fifths { fifths = int(5 * $1 / $2); printf "  %d of %d steps\n", $1, $2; fflush() }
            END { if (open) print "" }' ||
        fail_with "$log" "cmake --build --preset $preset $*"
}
