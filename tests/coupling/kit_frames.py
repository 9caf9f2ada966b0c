# SPDX-License-Identifier: GPL-3.0-or-later
"""Any bytes to the reader of frames of the Python kit: read or refused, nothing else. kit_frames.py COUNT SEED"""

import random
import struct
import sys

import blockweir_fluid as kit
import flatbuffers
import xxhash

count, seed = int(sys.argv[1]), int(sys.argv[2])
chance = random.Random(seed)


def seeds():
    """Frames as a solid sends them: a motion of two blocks, a failure, a hello without blocks."""
    columns = [struct.pack("<12d", *range(12))] * 2
    builder = flatbuffers.Builder(256)
    sums = kit._column_sums(builder, columns)
    builder.StartObject(4)
    builder.PrependUint64Slot(0, 7, 0)
    builder.PrependFloat64Slot(1, 0.5, 0.0)
    builder.PrependUOffsetTRelativeSlot(3, sums, 0)
    yield kit.make_frame(kit._MOTION, builder, builder.EndObject(), columns)[0]
    for kind in (kit._FAILURE, kit._HELLO):
        builder = flatbuffers.Builder(64)
        text = builder.CreateString("solid")
        builder.StartObject(12)
        builder.PrependUint32Slot(0, 10, 0) if kind == kit._HELLO else None
        builder.PrependUOffsetTRelativeSlot(1 if kind == kit._HELLO else 0, text, 0)
        yield kit.make_frame(kind, builder, builder.EndObject())[0]


def spoiled(frame):
    bytes_ = bytearray(frame)
    for _ in range(chance.randint(1, 6)):
        at = chance.randrange(len(bytes_))
        bytes_[at] = chance.choice((0, 1, 0x7F, 0xFF, chance.randrange(256)))
    if chance.random() < 0.2:
        del bytes_[chance.randrange(len(bytes_)):]
    if chance.random() < 0.8 and len(bytes_) > 24:  # with a checksum that makes the reader trust it
        columns = struct.unpack_from("<Q", bytes_, len(bytes_) - 16)[0]
        table = len(bytes_) - 16 - columns
        if 0 < table <= len(bytes_) - 16:
            bytes_[-8:] = struct.pack("<Q", xxhash.xxh3_64_intdigest(bytes(bytes_[:table]), seed=columns))
    return bytes(bytes_)


class Deaf(kit.Fluid):
    """Reads what a line would bring."""

    def __init__(self):
        self.role, self.blocks, self._motion, self.first_window = "fuzz", [None, None], None, 7

    def _send_frame(self, *_):
        pass

    def fail(self, text):
        assert "\n" not in text, text

    def _next_part(self):
        return b""


frames, read, refused = list(seeds()), 0, 0
for _ in range(count):
    frame = spoiled(chance.choice(frames))
    fluid = Deaf()
    try:
        kind, table, _ = kit.read_frame(frame)
        if kind == kit._MOTION:
            fluid._motion_of(table, frame)
        elif kind == kit._HELLO:
            fluid._hear_hello(table)
        elif kind in (kit._FAILURE, kit._PROGRESS, kit._FAREWELL):
            fluid._said(table)
        read += 1
    except kit.FluidError:
        refused += 1
print(f"{count} frames of seed {seed}: {read} read, {refused} refused")
assert read > count / 1000 and refused > count / 10
