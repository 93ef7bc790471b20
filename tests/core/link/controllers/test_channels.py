"""Addresses of the host's channels, and peers that come and go."""
from harness.programs import run

SOURCES = 'tests/core/link/controllers/channels.c tests/host/report.c port/host/*.c port/unix/*.c'.split()
# Bytes that are sent in part, where there is no room for all.
IN_PART = {'count > WAITING_BYTES - to->waiting_bytes': 'count == 0',
           'memcpy(to->waiting +': 'const size_t room = WAITING_BYTES - to->waiting_bytes;\n'
                                   'const size_t cut = count < room ? count : room;\nmemcpy(to->waiting +',
           'waiting_bytes, bytes, count);': 'waiting_bytes, bytes, cut);', 'waiting_bytes += count': 'waiting_bytes += cut'}


def test_what_goes_into_a_channel_comes_out_again(program, proves, tmp_path):
    proves(program(*SOURCES, by='clang'), tmp_path)


def test_found_a_send_of_a_part(program, tmp_path):
    assert run(program(*SOURCES, by='clang', planted={'port/unix/channel.c': IN_PART}), tmp_path).finds('records were sent')
