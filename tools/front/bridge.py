"""Commands that make still has: `make COMMAND NAME=value`."""
import os
import subprocess

from lab.build import ROOT, Wrong


def call(command, options):
    """Hands the options over as variables of make, from the root of the project."""
    if command.name == 'monitor':
        subprocess.run(['make', '-s', '-C', ROOT, 'build/monitor'], check=True)
        return subprocess.run([ROOT / 'build/monitor', *options.words]).returncode
    if command.name == 'import':
        subprocess.run(['make', '-s', '-C', ROOT, 'build/import'], check=True)
        return subprocess.run([ROOT / 'build/import', *options.words]).returncode
    if os.path.realpath('.') != str(ROOT):
        raise Wrong(f'{command.name} works in {ROOT}')
    goals = {'size': 'size', 'tables': 'tables'}
    variables = {name: getattr(options, name) for name in command.options.split()}
    variables['scene'] = getattr(options, 'scene', None)
    if command.arguments == 'RUN RUN':
        variables['runs'] = ' '.join(options.words)
    if command.name == 'tables' and options.words:
        variables['tables'] = ' '.join(options.words)
    if variables.pop('write', None):
        variables['keep'] = 'yes'
    words = [f'{name.upper()}={"yes" if value is True else value}' for name, value in variables.items()
             if value and (name in options.given or name == 'scene' or name not in command.defaults)]
    return subprocess.run(['make', '-f', 'tools/build/old.mk', '--no-print-directory', goals.get(command.name, command.name), *words]).returncode
