#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the pictures of the documentation anew: docs/images/make.sh. Needs ImageMagick.
set -eu

cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# render SCENE SIZE TECHNIQUE FILE
render() {
  ./run lueur render "$1" --size "$2" --technique "$3" -o "$folder/$4.png"
}

# pair SCENE SIZE: direct light only beside direct and indirect light, with a gap of four pixels.
# Rendered at SIZE and halved, averaged as light, for smooth edges. Without dates and comments the
# same pixels give the same file.
pair() {
  render "$1" "$2" none direct
  render "$1" "$2" hierarchical both
  convert "$folder/direct.png" "$folder/both.png" \
    -colorspace RGB -filter Box -resize 50% -colorspace sRGB \
    -bordercolor white -border 2x0 +append -shave 2x0 \
    -strip -define png:compression-level=9 -define png:exclude-chunks=date,time \
    "PNG24:docs/images/$1.png"
}

pair atrium 1280x720
pair cornell 720x720
pair spot-floor 960x540
ls -l docs/images/*.png
