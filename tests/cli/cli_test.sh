#!/usr/bin/env bash
# The program from outside: exit codes, messages, files. usage: cli_test.sh TWOFOLD SCENES_DIR
set -u
twofold=$1 scenes=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# expect CODE TEXT COMMAND...: the command ends with CODE and prints TEXT (a fixed string) somewhere.
expect() {
    local code=$1 text=$2 found
    shift 2
    "$@" >"$work/output" 2>&1
    found=$?
    if [ "$found" -eq "$code" ] && grep -qF -- "$text" "$work/output"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED (exit %s, wanted %s with "%s"): %s\n' "$found" "$code" "$text" "$*"
        head -n 5 "$work/output"
    fi
}

# holds TEXT CONDITION...: the test command succeeds.
holds() {
    local text=$1
    shift
    if "$@" >/dev/null 2>&1; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $text"; fi
}

small=(-q -D image.width=96 -D image.height=64 -D environment.cells=128 -D factorization.map_size=16
       -D materials.phong.modified_phong.exponent=20 -D factorization.samples=17000 -D factorization.held_out=500)
lobe=$scenes/sphere-lobe.json

# Usage
expect 0 "Exit codes" "$twofold" --help
expect 0 "twofold 0." "$twofold" --version
expect 0 "Example: twofold run" "$twofold" run --help
expect 2 "subcommand" "$twofold"
expect 2 "SCENE" "$twofold" run
expect 2 "bogus" "$twofold" run "$lobe" --bogus

# run: files, report, a manifest that reruns to the same bytes
expect 0 "report: " "$twofold" run "$lobe" -o "$work/a" "${small[@]}"
for file in exact.png exact.exr nv17.png ideal64.exr factors.json manifest.json report.html phong-t1-front.exr \
            phong-t2-back.png; do
    holds "run writes $file" test -s "$work/a/$file"
done
expect 0 "report: " "$twofold" run "$work/a/manifest.json" -o "$work/b" -q
for file in exact.png nv17.png ideal64.png gl13.exr manifest.json factors.json phong-t1-front.exr; do
    holds "the manifest reruns to the same $file" cmp "$work/a/$file" "$work/b/$file"
done
expect 0 '"comparisons"' "$twofold" run "$lobe" -o "$work/c" "${small[@]}" --json -j 7
holds "threads change nothing" cmp "$work/a/manifest.json" "$work/c/manifest.json"
holds "--json is JSON" python3 -m json.tool "$work/output"
holds "no temporary is left" test -z "$(find "$work" -name '*.tmp')"

# A temporary of a dead process is swept
touch "$work/a/.report.html.twofold-999999.tmp"
expect 0 "report: " "$twofold" run "$lobe" -o "$work/a" "${small[@]}"
holds "stale temporaries are swept" test ! -e "$work/a/.report.html.twofold-999999.tmp"

# factor, render
expect 0 '"log_rms"' "$twofold" factor "$lobe" -o "$work/f" "${small[@]}" --json
holds "factor writes factors.json" test -s "$work/f/factors.json"
expect 0 '"solver": "lsmr"' "$twofold" factor "$lobe" -o "$work/f" "${small[@]}" -D factorization.solver=lsmr --json
for solver in qmr lsmr cgls qmr_augmented; do
    expect 0 "\"solver\": \"$solver\"" "$twofold" factor "$lobe" -o "$work/f" "${small[@]}" --solver $solver --json
done
expect 2 "did you mean 'cgls'" "$twofold" factor "$lobe" -o "$work/f" "${small[@]}" --solver cgs
expect 0 "closed form: one Phong lobe" "$twofold" factor "$lobe" -o "$work/f" "${small[@]}" -D factorization.method=best
expect 5 "the solver ended with limit" "$twofold" factor "$lobe" -o "$work/f" "${small[@]}" -D factorization.iteration_limit=3
expect 2 "nothing to factor" "$twofold" factor "$scenes/two-passes.json" -o "$work/f"
expect 0 "nv17" "$twofold" render "$scenes/two-passes.json" -o "$work/quad.png" --preset nv17
expect 0 "gl13" "$twofold" render "$scenes/two-passes.json" -o "$work/quad-gl13.png" --preset gl13
expect 0 "ideal64" "$twofold" render "$scenes/two-passes.json" -o "$work/quad.exr"
expect 2 "there are: ideal64 float32 gl13 nv2x nv17 coarse8 custom" "$twofold" render "$lobe" -o "$work/x.png" --preset nv99
expect 2 "must end in .png or .exr" "$twofold" render "$lobe" -o "$work/x.jpg"
expect 4 "no/such/folder" "$twofold" render "$scenes/two-passes.json" -o "$work/no/such/folder/x.png"

# Both pipelines: the same bytes, counters of the reference only
expect 0 '"counters"' "$twofold" render "$scenes/two-passes.json" -o "$work/reference.png" --preset nv17 \
    --pipeline reference --json
holds "fast draws the reference's bytes" cmp "$work/quad.png" "$work/reference.png"
expect 0 '"pipeline": "fast"' "$twofold" render "$scenes/two-passes.json" -o "$work/quad.png" --preset nv17 --json -j 2
holds "fast counts nothing" sh -c "! grep -q counters '$work/output'"
expect 0 '"counters"' "$twofold" run "$lobe" -o "$work/r" "${small[@]}" --pipeline reference --json
holds "a run's manifest does not depend on the pipeline" cmp "$work/a/manifest.json" "$work/r/manifest.json"
expect 2 "there are: fast reference" "$twofold" render "$lobe" -o "$work/x.png" --pipeline quick

# compare
expect 0 "0 of 65536 pixels differ" "$twofold" compare "$work/quad.png" "$work/quad.png"
expect 2 "pixels differ, first at" "$twofold" compare "$work/quad.png" "$work/quad-gl13.png" --diff "$work/d.png"
holds "compare writes the heat map" test -s "$work/d.png"
expect 2 '"rms_steps"' "$twofold" compare "$work/quad.png" "$work/quad-gl13.png" --json
expect 3 "" "$twofold" compare "$work/quad.png" "$work/a/nv17.png"
expect 4 "missing.png" "$twofold" compare "$work/quad.png" "$work/missing.png"
expect 0 "0 of" "$twofold" compare "$work/quad.exr" "$work/quad.exr"
expect 2 "" "$twofold" compare "$work/a/exact.exr" "$work/a/gl13.exr"

# explain
expect 0 "bit-exact to preset nv17 v2" "$twofold" explain --preset nv17
expect 0 '"mark"' "$twofold" explain --preset gl13 --json
expect 0 "reflection_map" "$twofold" explain "$lobe" -D image.width=64 -D image.height=64
expect 0 "pass 0: 20172 triangles" "$twofold" explain "$scenes/cube-sphere.json" -D image.width=64 -D image.height=64
expect 2 "either a scene or --preset" "$twofold" explain
expect 0 "fragments on vectors; fused: shares vertices and set-up" "$twofold" explain "$lobe" \
    -D image.width=64 -D image.height=64
expect 0 "not fused with the pass before: other matrices" "$twofold" explain "$scenes/two-passes.json" \
    -D passes.1.cull=front
expect 0 "one by one: texture unit 0: an environment other" "$twofold" explain "$scenes/two-passes.json" \
    -D passes.0.units.0.env.mode=decal
expect 0 '"fused": ' "$twofold" explain "$scenes/two-passes.json" --json
expect 0 "alpha test" "$twofold" explain "$lobe" --cost "${small[@]}"
expect 0 '"percent"' "$twofold" explain "$scenes/two-passes.json" --cost --json -D image.width=64 -D image.height=64
holds "explain --cost --json is JSON" python3 -m json.tool "$work/output"
expect 2 "either a scene or --preset" "$twofold" explain --cost

# Bad input names file, field and value
expect 4 "missing.json" "$twofold" run "$work/missing.json" -o "$work/x"
echo '{"image": {"widht": 3}}' >"$work/bad.json"
expect 2 "did you mean 'width'?" "$twofold" run "$work/bad.json" -o "$work/x"
expect 2 "1000000000" "$twofold" run "$lobe" -o "$work/x" -D image.width=1000000000
expect 2 "factorization.samples" "$twofold" run "$lobe" -o "$work/x" -D factorization.samples=1000000000000
# The address sanitizer cannot start within a limit: under it the refusals are seen without one.
little_memory='ulimit -v 2000000; exec "$@"'
[ -z "${ASAN_OPTIONS:-}" ] || little_memory='exec "$@"'
for field in image.width=1000000000 factorization.samples=1000000000000; do
    expect 2 "sphere-lobe.json: ${field%=*}: ${field#*=} is not in 1.." \
        bash -c "$little_memory" - "$twofold" run "$lobe" -o "$work/x" -D "$field"
done
# Files that are not what their names say: IFF and SGI pictures, meshes and scenes of another kind
printf 'FOR4\0\0\1\4CIMGTBHD\0\0\0 \377\377\377\377' >"$work/iff.png"
cp "$work/iff.png" "$work/iff.hdr"
cp "$work/iff.png" "$work/iff.exr"
printf '\1\332\1\1\0\3\377\377\377\377\0\3' >"$work/sgi.hdr"
printf 'ply\nformat ascii 1.0\nend_header\n' >"$work/a.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/a.ply"
cp "$scenes/two-passes.json" "$work/flat.json"
cp "$lobe" "$work/lobe.json"
expect 4 "iff.png: unknown format (starts with 46 4f 52 34" "$twofold" render "$work/flat.json" -o "$work/x.png" \
    -D 'textures.t={"file":"iff.png"}'
for file in iff.png iff.hdr iff.exr sgi.hdr; do
    expect 4 "$file: unknown format (starts with" "$twofold" run "$work/lobe.json" -o "$work/x" \
        -D "environment={\"latlong\":\"$file\"}"
    expect 4 "$file: unknown format (starts with" "$twofold" compare "$work/$file" "$work/quad.exr"
done
expect 4 "a.obj: no faces" "$twofold" render "$work/flat.json" -o "$work/x.png" -D 'meshes.m={"file":"a.obj"}'
expect 4 "a.ply: not a PLY file" "$twofold" render "$work/flat.json" -o "$work/x.png" -D 'meshes.m={"file":"a.ply"}'
expect 2 "iff.png: line 1, column 5: a NUL byte" "$twofold" run "$work/iff.png" -o "$work/x"
expect 4 "courtyard.hdr" "$twofold" run "$scenes/gold-suzanne.json" -o "$work/x" -D environment.latlong=no/courtyard.hdr
echo "in the way" >"$work/file"
expect 4 "$work/file" "$twofold" run "$lobe" -o "$work/file" "${small[@]}"
holds "a failed run leaves no folder" test ! -e "$work/x"

# The paper to the letter warns when its result is unusable
expect 5 "warning" "$twofold" run "$lobe" -o "$work/w" "${small[@]}" -D factorization.method=letter
# S03
expect 1 "undersampled" "$twofold" run "$lobe" -o "$work/w" "${small[@]}" \
    -D materials.phong.modified_phong.exponent=100000
expect 1 "coarse8: the picture is empty" "$twofold" run "$lobe" -o "$work/w" "${small[@]}" -D 'presets=["gl13","coarse8"]'
expect 1 "coarse8  exact            0         0" "$twofold" run "$lobe" -o "$work/w" "${small[@]}" -D 'presets=["gl13","coarse8"]'
expect 1 "no pixel of any object is visible" "$twofold" run "$lobe" -o "$work/w" "${small[@]}" -D objects.0.scale=1e-6

# T11: a unit without a texture, told once for all presets
expect 1 "passes.0.units.1: no texture, reads as white" "$twofold" render "$scenes/two-passes.json" \
    -o "$work/white.png" -D 'passes.0.units=[null,{}]'
holds "T11 is told once" test "$("$twofold" run "$scenes/two-passes.json" -o "$work/t11" \
    -D 'passes.0.units=[null,{}]' 2>&1 | grep -c 'reads as white')" = 1
# T09: what the chip refuses
expect 2 "textures.t: 1000 x 500: preset nv17" "$twofold" render "$scenes/two-passes.json" \
    -o "$work/x.png" --preset nv17 -D 'textures.t={"checkerboard":{"width":1000,"height":500}}' \
    -D 'passes.0.units=[{"texture":"t"}]'

# Lost output is an error
expect 4 "standard output" sh -c "'$twofold' explain --preset nv17 >/dev/full"
expect 2 "must end in .png" "$twofold" compare "$work/quad.png" "$work/quad.png" --diff "$work/d.exr"

# Not enough samples is a warning
expect 1 "fewer than 10 an unknown" "$twofold" run "$lobe" -o "$work/w" "${small[@]}" -D factorization.samples=2000

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
