#!/bin/sh
# elsewhere.sh SCENE: writes the scene so that it can stand in any folder: what it includes is named from the root.
folder=$(cd -- "$(dirname -- "$1")" && pwd | sed 's/[\\&|]/\\&/g') || exit 1
exec sed 's|\(include *"\)\([^/"]\)|\1'"$folder"'/\2|g' "$1"
