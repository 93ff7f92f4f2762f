#!/usr/bin/env bash
# Makes the reports for the tests with the program: make_reports.sh PROGRAM SOURCE_DIR FOLDER
set -euo pipefail
program=$1 source=$2 folder=$3
here=$source/tests/validate/report/page
rm -rf "$folder"
mkdir -p "$folder"

small=(small_torus --scene-set camera.width=200 --scene-set camera.height=150 --rate 64
    --technique linear_binary --technique linear_binary@quadric --technique parallax_slope --technique micro_triangles)
"$program" validate "${small[@]}" --base both -o "$folder/torus"
"$program" validate small_torus --scene-set camera.width=96 --scene-set camera.height=72 --rate 32 \
    --technique linear_binary --technique parallax_slope --single-file -o "$folder/single"

# The same frames with every image as PNG.
"$program" validate small_torus --scene-set camera.width=96 --scene-set camera.height=72 --rate 64 \
    --technique exact_cells@quadric -o "$folder/exact"
"$program" compare "$folder"/exact/frames/{reference,exact_cells-on-quadric}.exr --plain-report -o "$folder/exact_plain"

# A scene takes its name from its file, a technique from its folder.
hostile="$folder/<img src=x onerror=alert('scene')>.toml"
cp "$here/hostile.toml" "$hostile"
technique="$folder/<img src=x onerror=alert('technique')>"
cp -r "$source/realtime/techniques/parallax_slope" "$technique"
mv "$technique/parallax_slope.glsl" "$technique/${technique##*/}.glsl"
"$program" validate "$hostile" --rate 32 --technique linear_binary --technique "$technique" -o "$folder/hostile"