"""A kernel whose answers are looked for every second.

A client of Jupyter sleeps until its socket wakes it. At times the answer of a kernel has come and the socket does not wake it: the client
then sleeps on to the end of its time limit, minutes later. Here no sleep is longer than a second.
"""

from __future__ import annotations

import time
from queue import Empty
from typing import Any

from jupyter_client import AsyncKernelClient, AsyncKernelManager
from jupyter_client.channels import AsyncZMQSocketChannel
from traitlets import Type

LONGEST_SLEEP = 1.0


class WatchedChannel(AsyncZMQSocketChannel):
    """A channel that looks for messages at least every LONGEST_SLEEP seconds."""

    async def get_msg(self, timeout: float | None = None) -> dict[str, Any]:
        """The next message; raises Empty after timeout seconds without one, never where timeout is None."""
        end = float("inf") if timeout is None else time.monotonic() + timeout
        while True:
            left = max(end - time.monotonic(), 0.0)
            try:
                return await super().get_msg(min(left, LONGEST_SLEEP))
            except Empty:
                if left <= LONGEST_SLEEP:
                    raise


class WatchedClient(AsyncKernelClient):
    """A client with watched channels."""

    shell_channel_class = Type(WatchedChannel)
    iopub_channel_class = Type(WatchedChannel)


class WatchedKernelManager(AsyncKernelManager):
    """A manager whose clients have watched channels."""

    client_factory = Type(WatchedClient)
