#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds Angiomesh and runs all tests on a virtual display. Ends with ctest's summary and its exit
# code. Arguments are handed to ctest (for example: -R tst_volume).
set -u
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

compile all
cd "$build" || exit 1
exec xvfb-run -a -s "-screen 0 1280x900x24" \
  ctest --output-on-failure -j2 --no-tests=error "$@"
