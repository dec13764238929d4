#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What one viewer of the Studio costs the daemon, in instructions for a second of sound: studio_viewer.py BUILD [SECONDS].

The daemon plays the sample at its real pace under callgrind, once with nobody, once with a client who wants what the Live
page wants (every hop with potentials, 60 messages a second; meters, health, log), once with one who listens to a voice,
too. The differences are his cost. Where the machine is too slow for that pace, hops are fewer: cost counts by hops."""
import json
import os
import re
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request

TREE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
BUILD, SECONDS = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 20
LIVE = {"hops": 60, "meters": 10, "health": 1, "beams": 2, "log": 2, "recordings": 2, "events": 10, "transcripts": 5}
HEARD = [{"stream": "separated", "track": 1}]


def connect(port, wish):
    peer = socket.create_connection(("127.0.0.1", port))
    peer.sendall((f"GET /api/v1/live HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                  "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n").encode())
    head = b""
    while b"\r\n\r\n" not in head:
        head += peer.recv(1)
    data = json.dumps(wish).encode()
    peer.sendall(b"\x81\xfe" + len(data).to_bytes(2, "big") + bytes(4) + data)
    return peer


def metric(port, name):
    text = urllib.request.urlopen(f"http://127.0.0.1:{port}/metrics").read().decode()
    return float(re.search(rf"^{name} (\S+)$", text, re.M)[1])


def run(wish, seconds=SECONDS):
    with tempfile.TemporaryDirectory() as folder:
        daemon = subprocess.Popen(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", os.path.join(BUILD, "bin/odas"), "studio",
             os.path.join(TREE, "configs/sample.cfg"), "--play", os.path.join(TREE, "samples/sample_4mic.flac"), "--loop",
             "--listen", "127.0.0.1:0", "--recordings", folder], stderr=subprocess.PIPE, text=True)
        said = ""
        while "Ctrl-C ends" not in said:
            said += daemon.stderr.readline()
        port = int(re.search(r"Studio: http://127.0.0.1:(\d+)", said)[1])
        peer, received, end = None, 0, time.monotonic() + seconds
        if wish:
            peer = connect(port, wish)
            peer.settimeout(0.2)
        while time.monotonic() < end:
            try:
                received += len(peer.recv(1 << 16)) if peer else time.sleep(0.2) or 0
            except TimeoutError:
                pass
        hops = metric(port, "odas_hops_total")
        daemon.send_signal(2)
        instructions = int(re.search(r"Collected : (\d+)", daemon.communicate()[1])[1])
    return instructions, hops, received


def line(what, cost, received, hops):
    print(f"{what:42} {cost / 1e6:8.2f} million instructions for a second of sound, {received / (hops / 125) / 1e3:6.1f} kB")


nobody, hops_alone, _ = run(None)
short, hops_short, _ = run(None, SECONDS / 4)
hop = (nobody - short) / (hops_alone - hops_short)  # the engine's own work; what is left is the start
for what, wish in (("a viewer of the Live page", {"type": "subscribe", "topics": LIVE}),
                   ("one who listens to a voice, too", {"type": "subscribe", "topics": LIVE, "audio": HEARD})):
    instructions, hops, received = run(wish)
    line(what, (instructions - nobody - hop * (hops - hops_alone)) / (hops / 125), received, hops)
print(f"{'the daemon with nobody':42} {hop * 125 / 1e6:8.2f} million ({hops_alone:.0f} hops)")
