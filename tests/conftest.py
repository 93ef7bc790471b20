"""What all tests share: the parts of harness/."""
pytest_plugins = [f'harness.{part}' for part in ('plants', 'families', 'commands', 'tap', 'programs', 'kept', 'tally')]
