#!/usr/bin/env bash
# Builds the program as a page for browsers: a folder of files for any web server.
#
#   assets/web/build.sh [FOLDER | --compile | --bindgen]
#
# FOLDER is out/web unless given; --compile stops after the compiler, which takes minutes and wants no wasm-bindgen; --bindgen
# prints the version of wasm-bindgen that is wanted, that in Cargo.lock. Wants Rust's target wasm32-unknown-unknown and
# wasm-bindgen; README says where from. Where the target is missing it is built from the sources of the compiler RUSTC, which
# Debian has in rustc-web and rust-web-src, and linked with lld.
set -euo pipefail
cd "$(dirname "$0")/../.."

out=${1:-out/web}
target=wasm32-unknown-unknown
rustc=${RUSTC:-rustc}

fail() {
  echo "web: $1" >&2
  exit 1
}

# That of the library that is linked.
wanted=$(awk '/^name = "wasm-bindgen"$/ { getline; gsub(/"/, "", $3); print $3 }' Cargo.lock)
if [ "$out" = --bindgen ]; then
  echo "$wanted"
  exit 0
fi

# Fails where wasm-bindgen is not there or of another version.
check_bindgen() {
  local found
  found=$(wasm-bindgen --version 2>/dev/null | awk '{ print $2 }') || true
  [ "$found" = "$wanted" ] ||
    fail "wasm-bindgen $wanted is wanted, ${found:-none} found: cargo install wasm-bindgen-cli --version $wanted"
}
[ "$out" = --compile ] || check_bindgen

std=()
if [ ! -d "$("$rustc" --print sysroot)/lib/rustlib/$target" ]; then
  if [ ! -d "$("$rustc" --print sysroot)/lib/rustlib/src" ]; then
    fail "$rustc has neither the target $target (rustup target add $target) nor its sources"
  fi
  export RUSTC_BOOTSTRAP=1
  std=(-Zbuild-std=std,panic_abort)
  linker=$(command -v wasm-ld || command -v rust-lld) || fail "no linker: apt-get install lld"
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker
fi

# What draws letters is a quarter of a megabyte smaller with vector instructions, which every browser with WebGL2 that is kept
# up to date has.
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS=-Ctarget-feature=+simd128
cargo build --locked --bin girderbench --profile web --target "$target" --no-default-features --features gui "${std[@]}"
[ "$out" != --compile ] || exit 0
mkdir -p "$out"
wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-dir "$out" \
  "${CARGO_TARGET_DIR:-target}/$target/web/girderbench.wasm"
# Comments and indentation of the generated script, 1.4 kB of its 23 compressed.
sed -i -E '/^ *(\/\/|\/\*\*|\*)/d; s/^ +//' "$out/girderbench.js"
cp assets/web/index.html "$out/"
size=$(cat "$out"/* | gzip -9 | wc -c)
echo "web: $out, $size bytes gzipped"
