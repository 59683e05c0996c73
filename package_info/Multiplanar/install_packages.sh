#!/usr/bin/env bash
# Installs the Debian packages of the list beside this file that are missing. Needs root or sudo only if any is.
# With --for-tests also what only the tests need.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
lists=("$here/debian_packages")
if [ "${1:-}" = --for-tests ]; then lists+=("$here/debian_packages_for_tests"); fi
missing=()
while read -r name; do
  case "$name" in ''|'#'*) continue ;; esac
  case "$name" in npm|chromium) command -v "$name" > /dev/null && continue ;; esac # wherever it is from
  dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q 'ok installed' || missing+=("$name")
done < <(cat "${lists[@]}")
[ ${#missing[@]} -eq 0 ] && exit 0
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
