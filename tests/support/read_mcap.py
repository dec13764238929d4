# SPDX-License-Identifier: MIT
"""Reads an uncompressed MCAP as https://mcap.dev/spec says, checks sums, indices and summary, and prints how
many messages each channel has. With a second argument: prints the data of that topic's messages, a line each."""
import struct
import sys
import zlib

data = open(sys.argv[1], "rb").read()
MAGIC = b"\x89MCAP0\r\n"
assert data[:8] == MAGIC and data[-8:] == MAGIC, "magic"


def u(size, at):
    return int.from_bytes(data[at:at + size], "little")


def text(at):
    size = u(4, at)
    return data[at + 4:at + 4 + size].decode(), at + 4 + size


def records(at, end):
    while at < end:
        size = u(8, at + 1)
        yield data[at], at + 9, size
        at += 9 + size
    assert at == end, "records end where they should"


def channel(at):
    topic, at_encoding = text(at + 4)
    return u(2, at), (topic, text(at_encoding)[0], u(2, at + 2))


channels, schemas, messages, by_index = {}, set(), [], []


def take(op, at, size, where):
    if op == 3:
        schemas.add(u(2, at))
    if op == 4:
        number, entry = channel(at)
        channels[number] = entry
        assert entry[2] == 0 or entry[2] in schemas, "schema before channel"
    if op == 5:
        assert u(2, at) in channels, "channel before message"
        messages.append((u(2, at), u(8, at + 6), data[at + 22:at + size], where))


chunks = {}
footer = len(data) - 8 - 29
assert data[footer] == 2
start, offsets, crc = u(8, footer + 9), u(8, footer + 17), u(4, footer + 25)
assert zlib.crc32(data[start:footer + 25]) == crc, "sum of the summary"
for op, at, size in records(8, start):
    if op == 6:
        begin, end, length, crc = struct.unpack_from("<QQQI", data, at)
        compression, at_records = text(at + 28)
        inner = at_records + 8
        assert compression == "" and u(8, at_records) == length and inner + length == at + size
        assert zlib.crc32(data[inner:inner + length]) == crc, "sum of a chunk"
        first = len(messages)
        for op2, at2, size2 in records(inner, inner + length):
            take(op2, at2, size2, at2 - 9)
        times = [m[1] for m in messages[first:]]
        assert (begin, end) == (min(times), max(times)), "times of a chunk"
        chunks[at - 9] = (size + 9, inner)
        current = inner
    elif op == 7:
        for i in range(at + 6, at + 6 + u(4, at + 2), 16):
            by_index.append((u(2, at), u(8, i), current + u(8, i + 8)))
    else:
        take(op, at, size, None)
assert sorted(by_index) == sorted((m[0], m[1], m[3]) for m in messages), "indices"

groups = {}
for op, at, size in records(start, offsets if offsets else footer):
    groups.setdefault(op, []).append((at, size))
    if op == 8:
        where, length = u(8, at + 16), u(8, at + 24)
        assert chunks[where][0] == length, "chunk index"
    if op == 4:
        number, entry = channel(at)
        assert channels[number] == entry, "channel of the summary"
    if op == 11:
        assert u(8, at) == len(messages) and u(4, at + 22) == len(chunks), "statistics"
assert len(groups.get(8, [])) == len(chunks)
for op, at, size in records(offsets, footer):
    group, begin, length = data[at], u(8, at + 1), u(8, at + 9)
    assert [(a, s) for _, a, s in records(begin, begin + length)] == groups[group], "offsets"

counts = {}
for number, _, content, _ in messages:
    topic, encoding, _ = channels[number]
    counts[topic, encoding] = counts.get((topic, encoding), 0) + 1
    if len(sys.argv) > 2 and topic == sys.argv[2]:
        print(content.decode())
if len(sys.argv) <= 2:
    for (topic, encoding), count in sorted(counts.items()):
        print(topic, encoding, count)
