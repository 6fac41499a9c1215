"""A network device whose packets come back late, in another order, or not at all.

Makes the TUN device "lossy" in the network namespace it runs in. Packets to `far` come back as packets from `far` to
`near`: source and destination are swapped, which leaves the checksums of IP, TCP and UDP as they are. So programs of
one namespace talk with one another over a link that loses packets, without netem in the kernel.

Usage: link.py <near> <far>. Each line of standard input changes the link: {"loss": 0.1, "delayMs": 50, "jitterMs": 80}
Prints "ready", and one line of JSON with the number of packets passed and lost when standard input ends.
"""

import fcntl
import heapq
import json
import os
import random
import selectors
import struct
import subprocess
import sys
import time

TUNSETIFF = 0x400454CA
IFF_TUN, IFF_NO_PI = 0x0001, 0x1000
MAX_PACKET = 65536
# As a router does: what waits is bounded, the rest is lost.
MAX_WAITING = 2000


def open_device(near: str, far: str) -> int:
    device = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
    fcntl.ioctl(device, TUNSETIFF, struct.pack("16sH", b"lossy", IFF_TUN | IFF_NO_PI))
    subprocess.run(["ip", "addr", "add", near, "peer", far, "dev", "lossy"], check=True)
    subprocess.run(["ip", "link", "set", "lossy", "up"], check=True)
    subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
    return device


def main() -> None:
    near, far = sys.argv[1:3]
    device = open_device(near, far)
    link = {"loss": 0.0, "delayMs": 0.0, "jitterMs": 0.0}
    waiting: list[tuple[float, int, bytes]] = []
    passed = lost = 0
    selector = selectors.DefaultSelector()
    selector.register(device, selectors.EVENT_READ)
    selector.register(sys.stdin, selectors.EVENT_READ)
    print("ready", flush=True)
    while True:
        pause = max(0.0, waiting[0][0] - time.monotonic()) if waiting else None
        for key, _ in selector.select(pause):
            if key.fileobj is sys.stdin:
                line = sys.stdin.readline()
                if not line:
                    print(json.dumps({"passed": passed, "lost": lost}), flush=True)
                    return
                link.update(json.loads(line))
                continue
            packet = os.read(device, MAX_PACKET)
            if packet[0] >> 4 != 4:
                continue
            if random.random() < link["loss"] or len(waiting) >= MAX_WAITING:
                lost += 1
                continue
            passed += 1
            due = time.monotonic() + (link["delayMs"] + random.random() * link["jitterMs"]) / 1000
            back = packet[:12] + packet[16:20] + packet[12:16] + packet[20:]
            heapq.heappush(waiting, (due, passed, back))
        while waiting and waiting[0][0] <= time.monotonic():
            try:
                os.write(device, heapq.heappop(waiting)[2])
            except BlockingIOError:
                lost += 1


main()
