"""isoc for tests that call it often: one process carries out all calls (tests/host/requests.c)."""
import os
import subprocess


class Isoc:
    def __init__(self, program, folder):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.messages = os.path.join(folder, 'messages')

    def __call__(self, *arguments):
        """The status of isoc with these arguments, and what it says."""
        self.process.stdin.write(b''.join(a.encode() + b'\0' for a in ('/dev/null', self.messages) + arguments) + b'\n')
        self.process.stdin.flush()
        status = int(self.process.stdout.readline())
        with open(self.messages, encoding='utf-8') as said:
            return status, said.read()
