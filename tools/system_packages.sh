#!/usr/bin/env bash
# Install the Debian packages that a build needs and that are missing. Arguments: further packages.
set -euo pipefail

wanted=(g++ libhdf5-dev libpng-dev libtomlplusplus-dev libeigen3-dev libcli11-dev catch2 ccache "$@")
python=${PYTHON:-python3}
command -v "$python" >/dev/null || wanted+=(python3)
"$python" -c 'import ensurepip' 2>/dev/null || wanted+=(python3-venv)
"$python" -c 'import os, sysconfig; open(os.path.join(sysconfig.get_path("include"), "Python.h"))' \
  2>/dev/null || wanted+=(python3-dev)

if ! command -v dpkg-query >/dev/null; then
  echo "This is no Debian system: please see to the counterparts of: ${wanted[*]}"
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

install="apt-get install --yes --no-install-recommends ${missing[*]}"
if [ "$(id -u)" -eq 0 ]; then
  as_root=()
elif command -v sudo >/dev/null; then
  as_root=(sudo)
else
  echo "Some Debian packages are missing and there is no way to become root from here."
  echo "Please have this run once, then repeat:"
  echo "  apt-get update && $install"
  exit 1
fi
echo "Installing Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" $install -qq >/dev/null
