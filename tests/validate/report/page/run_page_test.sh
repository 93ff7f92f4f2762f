#!/usr/bin/env bash
# Runs a test of the report's page: run_page_test.sh SOURCE_DIR BUILD_DIR TEST.mjs. Exit code 77: skipped; it
# prints why.
set -euo pipefail
source=$1 build=$2 test=$3

skip() { echo "SKIPPED: $1"; exit 77; }
command -v node >/dev/null && command -v npm >/dev/null || skip "node and npm are missing (apt install nodejs npm)"
oldest=18
[ "$(node -p 'process.versions.node.split(".")[0]')" -ge $oldest ] || skip "node $(node --version) is older than $oldest"
CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
[ -n "$CHROMIUM" ] || skip "chromium is missing (apt install chromium)"
grep -q 'id="report-data"' "$REPORTS_DIR/torus/report/index.html" || skip "the program was built without the interactive page"

# Packages are installed in the build folder once for each lock file; the tests use them through a link.
mkdir -p "$build"
exec 9>"$build/lock"
flock 9
stamp=$(sha256sum "$source/package-lock.json")
if [ "$(cat "$build/installed" 2>/dev/null)" != "$stamp" ]; then
    cp "$source/package.json" "$source/package-lock.json" "$build/"
    (cd "$build" && npm ci --no-audit --no-fund --ignore-scripts >npm.log 2>&1) ||
        skip "npm couldn't fetch the packages ($(grep -m1 -E 'npm (error|ERR!)' "$build/npm.log" || true))"
    ln -sfn "$source" "$build/tests"
    echo "$stamp" >"$build/installed"
fi
flock -u 9
export CHROMIUM
exec node --preserve-symlinks --preserve-symlinks-main "$build/tests/$test"
