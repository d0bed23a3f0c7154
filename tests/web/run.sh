#!/usr/bin/env bash
# Builds the core for wasm32-unknown-unknown on Debian 12 and compares its answers under node with those of a program.
#
# tests/web/run.sh PROGRAM [PRESET...]: wants rustc-web, rust-web-src, nodejs, and wasm-bindgen of the version in Cargo.lock
# (cargo install wasm-bindgen-cli --version ...). RUST_LLD names the linker where it is not found.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=$(realpath "$1")
shift
out=target/web
linker=${RUST_LLD:-$(find "$(rustup run stable rustc --print sysroot)" -name rust-lld | head -1)}

export RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker
cargo build --locked --profile web --target wasm32-unknown-unknown -Zbuild-std=std,panic_abort --target-dir "$out/build" \
  --bin girderbench --no-default-features
wasm-bindgen --target nodejs --out-dir "$out" --out-name girderbench \
  "$out/build/wasm32-unknown-unknown/web/girderbench.wasm"
node tests/web/core.mjs "$out/girderbench.js" "$program" "$out/answers" "$@"
