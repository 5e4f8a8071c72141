# Shared by demo.sh, test.sh and .ci/run: sourced, not run. Debian 12 package names live here and nowhere else.

packages="build-essential ca-certificates ccache cmake git ninja-build
  libcairo2-dev libcli11-dev libeigen3-dev libexpat1-dev libgtest-dev libinsighttoolkit5-dev libkissfft-dev libvtk9-dev nlohmann-json3-dev"

# The HTML reports are bundled with npm. A Node.js from elsewhere brings it along, and Debian's packages conflict with that one.
if ! command -v npm > /dev/null; then
  packages="$packages nodejs npm"
fi

# Installs what is missing, as root or by sudo; does nothing when nothing is.
install_packages() {
  local package missing=() as_root=()
  if ! command -v apt-get > /dev/null; then
    echo "No apt-get here: going on with what is installed. Needed, by their Debian 12 names: $packages" >&2
    return
  fi
  for package in $packages; do
    if ! dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null | grep -qx installed; then
      missing+=("$package")
    fi
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
      echo "Missing: ${missing[*]}. Run as root, or install sudo." >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends "${missing[@]}"
}

# Compilers to run at once: one per processor, as far as there are 1.5 GB of memory for each.
build_jobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '/MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo)
  if [ "$memory" -lt 1 ]; then
    memory=1
  fi
  echo $((processors < memory ? processors : memory))
}

# Stops at the first file that clang-format would change. Version 14: another one formats differently.
check_formatting() {
  if ! command -v clang-format-14 > /dev/null; then
    echo "No clang-format-14 here: formatting is not checked." >&2
    return
  fi
  echo "== formatting"
  find Applications Examples Modules Testing \( -name '*.cxx' -o -name '*.h' -o -name '*.hxx' \) -print0 |
    xargs -0 clang-format-14 --dry-run -Werror
}

# Keeps compiled files for the next build when ccache is there.
use_ccache() {
  if command -v ccache > /dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
}
