"""`isochron fmu`: a scene as an FMU (tools/fmu/README.md): the files of isoc in sources/, a library for each platform
whose compiler is there in binaries/, and NAME.fmu."""
import os
import pathlib
import re
import shutil

from fmu.pack import pack
from lab import build

# The compilers of other platforms: platform, ending. Version 2.0 has names of its own for two of them.
OTHERS = {'aarch64-linux-gnu-gcc': ('aarch64-linux', 'so'), 'x86_64-w64-mingw32-gcc': ('x86_64-windows', 'dll')}
NAMES_OF_2 = {'x86_64-linux': 'linux64', 'x86_64-windows': 'win64'}


def run(options):
    folder = build.outputs('fmu', options.scene, options)
    folder = folder if options.fmi == '3' or options.out else folder / '2'
    new = folder / 'new'
    shutil.rmtree(new, ignore_errors=True)
    new.mkdir(parents=True)
    # A scene that is refused leaves the FMU of before as it was.
    try:
        said = build.call([build.tools('isoc'), options.scene, '-o', new, '--fmu', '--fmi', options.fmi,
                           *(['--exchange'] if options.exchange else []), *build.isoc_options(options)])
    except build.Wrong:
        shutil.rmtree(new)
        raise
    (folder / 'plant.txt').write_text(said)
    for old in 'sources', 'binaries':
        shutil.rmtree(folder / old, ignore_errors=True)
    new.rename(folder / 'sources')
    name = re.search('<CoSimulation modelIdentifier="([^"]*)"',
                     (folder / 'sources/modelDescription.xml').read_text())[1]
    host = f'{os.uname().machine}-linux'
    compiler, *flags = build.host_compiler()
    library(folder, options.fmi, name, host, 'so', [compiler, *flags, '-Wl,--build-id=none'])
    for other, (platform, ending) in OTHERS.items():
        if platform != host and shutil.which(other):
            library(folder, options.fmi, name, platform, ending, [other, *flags])
    archive = folder / f'{name}.fmu'
    pack(str(folder), str(archive))
    print(f'fmu {archive}')


def library(folder, fmi, name, platform, ending, command):
    """A library of this platform, by a path that is no part of it."""
    place = pathlib.Path('binaries', platform if fmi == '3' else NAMES_OF_2.get(platform, platform))
    (folder / place).mkdir(parents=True)
    sources = folder / 'sources'
    with build.progress(f'compiles the library of {platform}'):
        build.call([*command, f'-DFMI{fmi}_OVERRIDE_FUNCTION_PREFIX', '-fPIC', '-shared', '-fvisibility=hidden', '-s',
                    *(f'./{path.name}' for path in sorted(sources.glob('*.c'))), '-o', f'../{place}/{name}.{ending}'],
                    cwd=sources)
