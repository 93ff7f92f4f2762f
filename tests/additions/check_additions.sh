#!/usr/bin/env bash
# Adds one thing of each kind to a copy of the tree in the way .github/CONTRIBUTING.md describes, builds the program and
# uses what was added: the lists there are complete as long as this passes.
#     check_additions.sh WORK_FOLDER        (which is emptied first)
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
source=$(dirname "$(dirname "$here")")
work=$1
tree=$work/tree
files=() # that the addition at hand touches

fail() { printf 'check_additions: %s\n' "$*" >&2; exit 1; }

# new_files KIND: copies them into the tree.
new_files() {
    local file
    cp -r "$here/$1/." "$tree/"
    while read -r file; do files+=("$file"); done < <(cd "$here/$1" && find . -type f)
}

# row FILE PATTERN LINE: adds the line in front of the only one that matches the extended regular expression.
row() {
    local count
    count=$(grep -cE -- "$2" "$tree/$1" || true)
    [[ $count == 1 ]] || fail "$1: $count lines match '$2'; expected one"
    LINE=$3 awk -v pattern="$2" '$0 ~ pattern { print ENVIRON["LINE"] } { print }' "$tree/$1" >"$work/row"
    cat "$work/row" >"$tree/$1"
    files+=("./$1")
}

add_technique() { new_files technique; }

add_surface() { new_files surface; }

add_metric() {
    new_files metric
    row validate/metrics/metric_registry.cpp '^#include "validate/metrics/st_error.h"' \
        '#include "validate/metrics/throwaway.h"'
    row validate/metrics/metric_registry.cpp '^ *fetchCostMetric[(][)],' '        throwawayMetric(),'
    row validate/CMakeLists.txt 'metrics/boundary_iou.cpp' '    metrics/throwaway.cpp'
}

add_baked_map() {
    new_files baked_map
    row realtime/bake/bake_kinds.h '^BakedMap bakeMaxMipmap' \
        'BakedMap bakeThrowawayMap(const HeightMap& map, const BakeRequest& request);'
    row realtime/bake/bake.cpp '^ *[{][.]name = "max_mipmap",' '        {.name = "throwaway_map",
         .meaning = "The depth",
         .source = "none",
         .slices = "one",
         .channels = "relief depth",
         .needsScale = false,
         .make = bakeThrowawayMap},'
    row realtime/bake/CMakeLists.txt '^ *bake_cache.cpp' '    throwaway_map.cpp'
    row realtime/technique/baked_family.cpp '^ *[{]"depth_bounds.glsl",' \
        '        {"throwaway_map.glsl", "uThrowawayMap", nullptr, 6, false, {"throwaway_map"}},'
}

add_shape() {
    new_files shape
    row scenes/CMakeLists.txt 'mesh/shapes/limit_points.cpp' '    mesh/shapes/throwaway_shape.cpp'
    row scenes/scene_file/scene_shape.cpp '^#include "scenes/mesh/shapes/shapes.h"' \
        '#include "scenes/mesh/shapes/throwaway_shape.h"'
    row scenes/scene_file/scene_shape.cpp '^struct Kind [{]' 'Maker throwaway(const TomlTable& shape) {
    const double depth = size(shape, "depth", 1);
    return [=] { return makeThrowawayShape(depth); };
}
'
    row scenes/scene_file/scene_shape.cpp '[{]"plane", plane[}]' '        {"throwaway", throwaway},'
}

add_subcommand() {
    new_files subcommand
    row validate/cli/commands.cpp '^Command doctorCommand[(][)];' 'Command throwawayCommand();'
    row validate/cli/commands.cpp '^ *listCommand[(][)],' '        throwawayCommand(),'
    row validate/CMakeLists.txt 'cli/bake_command.cpp' '    cli/throwaway_command.cpp'
}

# check TEXT COMMAND…: the command succeeds and prints the text.
check() {
    local text=$1
    shift
    "$@" >"$work/output" 2>&1 || { cat "$work/output" >&2; fail "failed: $*"; }
    grep -q -- "$text" "$work/output" || { cat "$work/output" >&2; fail "didn't print '$text': $*"; }
}

check_program() {
    local program=$work/build/plumbline scene=$tree/scenes/library/small_torus.toml
    check 'throw-away 7' "$program" throwaway 7
    check 'throwaway .*Print a number' "$program" --help
    check 'throwaway_surface' "$program" list surfaces
    check 'throwaway\.shared_px' "$program" list metrics

    local techniques=(--technique throwaway --technique linear_binary@throwaway_surface --technique throwaway_baked)
    check 'shared' "$program" validate "$scene" --plain-report --scene-set camera.width=80 --scene-set camera.height=60 \
        "${techniques[@]}" --require 'throwaway.shared_px>=100' -o "$work/run"
    check 'throwaway.shared_px' cat "$work/run/results.csv"
    check 'throw-away' grep -rh throw-away "$work/run/report"
    check 'linear_binary@throwaway_surface' cat "$work/run/results.json"

    sed 's/kind = "torus", .*\]/kind = "throwaway"/; s/^proxy_rate.*//' "$scene" >"$work/shape.toml"
    check '' "$program" reference "$work/shape.toml" --scene-set camera.width=80 --scene-set camera.height=60 \
        -o "$work/shape.exr"
}

rm -rf "$work"
mkdir -p "$tree"
tar -C "$source" -c --exclude=./build --exclude=./.git --exclude=./plumbline-out . | tar -C "$tree" -x

for kind in technique surface metric baked_map shape subcommand; do
    files=()
    "add_$kind"
    mapfile -t files < <(printf '%s\n' "${files[@]}" | sort -u)
    printf '%-12s %d files: %s\n' "$kind" ${#files[@]} "${files[*]#./}"
done

cmake -S "$tree" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPLUMBLINE_TESTS=OFF >"$work/configure.log"
cmake --build "$work/build" -j2 >"$work/build.log" || { tail -50 "$work/build.log" >&2; fail "doesn't build"; }
check_program
