#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# Checks that sources are formatted: check_format.sh [ROOT]
# Mends them: check_format.sh --fix
set -euo pipefail

mode=(--dry-run -Werror)
if [[ "${1:-}" == --fix ]]; then
  mode=(-i)
  shift
fi
cd "${1:-$(dirname "$0")/..}"

# In a checkout what git tracks or would track, in a plain copy everything but build trees.
list_sources() {
  if git rev-parse --git-dir >/dev/null 2>&1; then
    git ls-files -z --cached --others --exclude-standard -- '*.h' '*.cc'
  else
    find . \( -name 'build*' -prune \) -o \( -name '*.h' -o -name '*.cc' \) -print0
  fi
}

# A file that is deleted but still tracked is nobody's mistake.
list_sources | while IFS= read -r -d '' file; do
  if [[ -f "$file" ]]; then printf '%s\0' "$file"; fi
done | xargs -0 -r -n 16 -P "$(nproc)" clang-format --style=file "${mode[@]}"
