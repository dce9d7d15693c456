"""A relay between a worker and its database, which can be cut without either side being told."""

from __future__ import annotations

import socket
from contextlib import suppress
from threading import Event, Thread


class Relay:
    """Passes bytes both ways between those who connect here and a port; cut off, it keeps what comes for later."""

    def __init__(self, port: int) -> None:
        self._target = port
        self._open = Event()
        self._open.set()
        self._sockets: list[socket.socket] = []
        self._listening = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listening.getsockname()[1]
        Thread(target=self._accept, daemon=True).start()

    def cut(self) -> None:
        """Pass nothing on; the connections stay open."""
        self._open.clear()

    def mend(self) -> None:
        """Pass on what has gathered, and all that comes."""
        self._open.set()

    def close(self) -> None:
        """End all connections."""
        self.mend()
        for one in (self._listening, *self._sockets):
            with suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)
            one.close()

    def _accept(self) -> None:
        with suppress(OSError):
            while True:
                near, _ = self._listening.accept()
                far = socket.create_connection(("127.0.0.1", self._target))
                self._sockets += [near, far]
                for source, sink in ((near, far), (far, near)):
                    Thread(target=self._pass, args=(source, sink), daemon=True).start()

    def _pass(self, source: socket.socket, sink: socket.socket) -> None:
        with suppress(OSError):
            while content := source.recv(65536):
                self._open.wait()
                sink.sendall(content)
            sink.shutdown(socket.SHUT_WR)
