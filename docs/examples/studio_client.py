#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Says whom a Studio hears, and keeps each voice as a WAV: studio_client.py [ADDRESS [SECONDS]], Ctrl-C ends."""
import base64, json, math, os, socket, struct, sys, time, wave
from urllib.parse import urlsplit


def connect(address):
    at = urlsplit(address)  # http://127.0.0.1:8080/, or with ?token=..., as the daemon prints it
    peer = socket.create_connection((at.hostname, at.port or 80))
    query, key = at.query and "?" + at.query, base64.b64encode(os.urandom(16)).decode()
    peer.sendall(f"GET /api/v1/live{query} HTTP/1.1\r\nHost: {at.netloc}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                 f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n".encode())
    stream = peer.makefile("rb")
    answer = list(iter(lambda: stream.readline().decode().strip(), ""))  # to the empty line
    if " 101 " not in answer[0]:
        sys.exit(answer[0])
    return peer, stream


def send(peer, message):
    data = json.dumps(message).encode()  # of a client each frame is masked, here with zeros
    size = bytes([0x80 | len(data)]) if len(data) < 126 else struct.pack(">BH", 0xFE, len(data))
    peer.sendall(b"\x81" + size + bytes(4) + data)


def messages(peer, stream):
    while len(head := stream.read(2)) == 2 and head[0] & 15 != 8:  # 8: it closes
        kind, size = head[0] & 15, head[1] & 127
        if size > 125:
            size = int.from_bytes(stream.read(2 if size == 126 else 8), "big")
        data = stream.read(size)
        if kind == 9:  # ping
            peer.sendall(bytes([0x8A, 0x80 | size]) + bytes(4) + data)
        elif kind in (1, 2):
            yield json.loads(data) if kind == 1 else data


peer, stream = connect(sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080/")
end = time.monotonic() + (float(sys.argv[2]) if len(sys.argv) > 2 else math.inf)
voices, heard = {}, []  # track: (its file, sample that comes next)
send(peer, {"type": "subscribe", "topics": {"hops": 10}})
for message in messages(peer, stream):
    if isinstance(message, bytes) and message[0] == 1:
        track, index, rate, count, flags = struct.unpack_from("<IQIHH", message, 4)
        if track not in voices:
            voices[track] = wave.open(f"voice_{track}.wav", "wb"), index
            voices[track][0].setparams((1, 2, rate, 0, "NONE", ""))
        file, following = voices[track]
        file.writeframes(bytes(2 * (index - following)) + message[24:])  # what was lost is silence
        voices[track] = file, index + count
    elif isinstance(message, dict) and message["type"] == "hops":  # what is not known is passed over
        now = {row[1]: row[2:5] for hop in message["hops"] for row in hop["tracks"]}
        for track in [track for track in now if track not in heard]:
            print(f"source {track} at azimuth {math.degrees(math.atan2(now[track][1], now[track][0])):.0f}", flush=True)
            heard.append(track)
            send(peer, {"type": "subscribe", "topics": {"hops": 10},
                        "audio": [{"stream": "separated", "track": one} for one in heard[-8:]]})
    if time.monotonic() > end:
        break
