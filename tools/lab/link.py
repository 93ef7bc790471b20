"""isochron link: a plant and a controller, joined by a wire that build/link watches."""
import os

from . import a2l, build, run as runs


def run(options):
    bench = linked(options)
    if options.xcp:
        print(f'a2l {a2l.write(bench)}', flush=True)
    connect(bench, options)


def linked(options):
    """The plant with a link, and with measurement and calibration where --xcp says so."""
    need_channels(options)
    return build.plant(options, kind='calibrated' if options.xcp else 'linked',
                       isoc=['--link', *(['--xcp', options.xcp] if options.xcp else [])])


def need_channels(options):
    target = options.target or 'host'
    port = build.port(target, options.real or 'float')
    if not port.channel:
        raise build.Wrong(f'{options.command} needs channels (port/channel.h), and --target {target} has none')
    if options.xcp and port.channels == '1':
        raise build.Wrong(f'--target {target} has one channel, that of a controller, and none for measurement and '
                          'calibration over XCP')


def connect(bench, options, quiet=False):
    """Runs both, and prints the summary of their exchanges. A controller in Python finds the plant's module."""
    endless = options.seconds == '0'
    command, environment = bench.command(options.seconds, options.script, endless=endless)
    header, = bench.sources.glob('*_link.h')
    environment['PYTHONPATH'] = ':'.join(filter(None, [str(bench.sources), os.environ.get('PYTHONPATH')]))
    words = [build.tools('link'), '-o', bench.folder, '--header', header,
             *(['--mode', options.mode] if options.mode else []), *(['--end', 'controller'] if endless else []),
             *(['--controller', options.controller] if options.controller else [])]
    text, status = build.copied([*words, '--', *command], environment, quiet)
    (bench.folder / 'summary.txt').write_text(text)
    if status:
        raise build.Wrong('')
    if options.keep:
        runs.keep(bench.folder, options.keep)
