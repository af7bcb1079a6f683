#!/usr/bin/env bash
# A program that knows the package by pkg-config only.
#
#   pkg_config.sh STAGE COMPILER PROGRAM      PROGRAM.cpp, which says what is in PROGRAM.out
set -euo pipefail
stage=$1 compiler=$2 program=$3
PKG_CONFIG_PATH=$(find "$stage" -name pkgconfig)
export PKG_CONFIG_PATH
for package in stickslip-numeric stickslip-symbolic stickslip-proofs; do
  pkg-config --define-prefix --exists --print-errors "$package"
done
read -ra flags <<<"$(pkg-config --define-prefix --cflags --libs stickslip-numeric)"
"$compiler" -std=c++20 "$program.cpp" "${flags[@]}" -o "$stage/by_pkg_config"
"$stage/by_pkg_config" | diff "$program.out" -
rm "$stage/by_pkg_config"
