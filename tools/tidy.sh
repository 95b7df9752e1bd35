#!/usr/bin/env bash
# clang-tidy over the sources that git knows under the given folders (default: all C++ of the
# library, the executable and the bindings), with the flags of a release, every file by itself.
set -euo pipefail
cd "$(dirname "$0")/.."
build=build/alone
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DLAPILLI_UNITY=OFF -DLAPILLI_TESTS=OFF \
  -DLAPILLI_PYTHON=ON -DPython_EXECUTABLE="$PWD/.venv/bin/python" >/dev/null
# Options of GCC that clang does not know.
flags=build/tidy
mkdir -p "$flags"
sed 's/ -Wno-aggressive-loop-optimizations//g; s/ --param ggc-min-heapsize=400000//g;
     s/ -fno-fat-lto-objects//g; s/ -flto=auto//g; s/ -flto//g' \
  "$build/compile_commands.json" >"$flags/compile_commands.json"
git ls-files "${@:-cpp}" | grep '\.cpp$' |
  xargs -P "${JOBS:-$(nproc)}" -n 1 clang-tidy -p "$flags" --quiet 2>&1 |
  { grep -vE '^[0-9]+ warnings? (and [0-9]+ errors? )?generated|^$' || true; } | tee build/tidy.log
! grep -qE '(error|warning):' build/tidy.log
