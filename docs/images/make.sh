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
  side_by_side "$1" "$folder/direct.png" "$folder/both.png"
}

# side_by_side FILE PICTURES...
side_by_side() {
  name=$1
  shift
  convert "$@" -colorspace RGB -filter Box -resize 50% -colorspace sRGB \
    -bordercolor white -border 2x0 +append -shave 2x0 \
    -strip -define png:compression-level=9 -define png:exclude-chunks=date,time \
    "PNG24:docs/images/$name.png"
}

# truth SCENE SIZE: path traced beside the technique, and the difference that one perceives.
truth() {
  ./run lueur reference "$1" --size "$2" --spp 1024 -o "$folder/truth.png"
  render "$1" "$2" hierarchical both
  ./run lueur diff "$folder/both.png" "$folder/truth.png" -o "$folder/map.png" >/dev/null
  side_by_side truth "$folder/truth.png" "$folder/both.png" "$folder/map.png"
}

pair atrium 1280x720
pair cornell 720x720
pair spot-floor 960x540
truth cornell 600x600
ls -l docs/images/*.png
