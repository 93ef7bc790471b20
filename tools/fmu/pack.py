"""Packs a folder as an FMU: python3 pack.py FOLDER FILE.fmu

FOLDER has sources/, among them modelDescription.xml, which goes to the top, and binaries/. The same files give the same
bytes: names in order, a fixed date, one kind of compression.
"""

import os
import sys
import zipfile

DATE = (1980, 1, 1, 0, 0, 0)


def files_of(folder):
    """The files of a folder with their names in the archive, in the order of these."""
    found = {}
    for part in ("sources", "binaries"):
        for at, folders, names in os.walk(os.path.join(folder, part)):
            folders.sort()
            for name in names:
                path = os.path.join(at, name)
                inside = os.path.relpath(path, folder).replace(os.sep, "/")
                found["modelDescription.xml" if inside == "sources/modelDescription.xml" else inside] = path
    return sorted(found.items())


def pack(folder, archive):
    """Writes the archive beside its place, then into it."""
    with zipfile.ZipFile(archive + ".part", "w") as out:
        for name, path in files_of(folder):
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3
            entry.external_attr = (0o755 if name.startswith("binaries/") else 0o644) << 16
            with open(path, "rb") as file:
                out.writestr(entry, file.read(), compresslevel=9)
    os.replace(archive + ".part", archive)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    pack(sys.argv[1], sys.argv[2])
