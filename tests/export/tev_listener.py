"""Stands in for the viewer tev: takes one connection, decodes the packets, and writes the picture that they leave. Prints how many updates came,
and how many before all pixels had come once. Usage: tev_listener.py PORT_FILE OUT.pfm [HANG_UP_AFTER], a number of packets"""
import os
import socket
import struct
import sys

server = socket.create_server(("127.0.0.1", 0))
server.settimeout(60)
with open(sys.argv[1] + ".new", "w") as file:
    file.write(str(server.getsockname()[1]))
os.rename(sys.argv[1] + ".new", sys.argv[1])
connection, _ = server.accept()
connection.settimeout(60)
stream = connection.makefile("rb")
most = int(sys.argv[3]) if len(sys.argv) > 3 else None


class Packet:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, form, count=1):
        size = struct.calcsize("<" + form * count)
        values = struct.unpack_from("<" + form * count, self.data, self.at)
        self.at += size
        return values if count > 1 else values[0]

    def text(self):
        end = self.data.index(b"\0", self.at)
        word, self.at = self.data[self.at : end].decode(), end + 1
        return word


created, pixels, seen, updates, needed = None, None, set(), 0, None
while most is None or updates < most:
    head = stream.read(4)
    if len(head) < 4:
        break
    packet = Packet(stream.read(struct.unpack("<I", head)[0] - 4))
    kind, _, name = packet.take("B"), packet.take("B"), packet.text()
    if kind == 4:
        assert created is None
        created = name
        width, height, count = packet.take("i", 3)
        assert [packet.text() for _ in range(count)] == ["R", "G", "B"]
        pixels = [[0.0] * (3 * width) for _ in range(height)]
    else:
        assert kind == 6 and name == created
        assert [packet.text() for _ in range(packet.take("i"))] == ["R", "G", "B"]
        x, y, w, h = packet.take("i", 4)
        offsets, strides = packet.take("q", 3), packet.take("q", 3)
        floats = packet.take("f", max(o + (w * h - 1) * s + 1 for o, s in zip(offsets, strides)))
        for i in range(w * h):
            for c in range(3):
                pixels[y + i // w][3 * (x + i % w) + c] = floats[offsets[c] + i * strides[c]]
            seen.add((x + i % w, y + i // w))
        updates += 1
        if len(seen) == width * height and needed is None:
            needed = updates
    assert packet.at == len(packet.data), "bytes are left"
connection.close()
with open(sys.argv[2], "wb") as file:
    file.write(b"PF\n%d %d\n-1.0\n" % (width, height))
    for row in reversed(pixels):
        file.write(struct.pack("<%df" % len(row), *row))
print(f"{created}: {updates} updates, all pixels after {needed}")
