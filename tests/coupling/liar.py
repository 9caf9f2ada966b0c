# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid that says one thing wrong: liar.py WHAT. It prints what it hears of it."""

import math
import os
import sys

import blockweir_fluid as kit

what = sys.argv[1]
window_of_the_lie = 3


class Liar(kit.Fluid):
    def _agree(self, table):
        if what == "digest":
            self._send_frame = self._send_another_digest
        super()._agree(table)

    def _send_another_digest(self, kind, builder, body, columns=()):
        builder.Bytes[:] = builder.Bytes.replace(self.scene_digest.encode(), b"0123456789abcdef")
        super()._send_frame(kind, builder, body, columns)

    def _send_frame(self, kind, builder, body, columns=()):
        lies = kind == kit._LOAD and self._motion.window == window_of_the_lie
        if lies and what == "panel count":
            columns = list(columns)
            columns[1] += columns[1][:8]
            builder = rebuilt(self._motion, columns)
            body = builder.EndObject()
        if lies and what == "damage":
            parts = kit.make_frame(kind, builder, body, columns)
            self._socket.send(parts[0][:40] + b"\xff" + parts[0][41:])
            return
        super()._send_frame(kind, builder, body, columns)


def rebuilt(motion, columns):
    """A table that tells of these columns."""
    builder = kit.flatbuffers.Builder(1024)
    sums = kit._column_sums(builder, columns)
    builder.StartObject(8)
    builder.PrependUint64Slot(0, motion.window, 0)
    builder.PrependFloat64Slot(1, motion.time_s, 0.0)
    builder.PrependUOffsetTRelativeSlot(7, sums, 0)
    return builder


def panel(lies):
    block, edge, pressure = 1, 3, 1000.0
    if lies and what == "block":
        block = 1000
    if lies and what == "edge":
        edge = 7
    if lies and what == "nan":
        pressure = math.nan
    ends = (0.8, 0.2) if lies and what == "backwards" else (0.0, 1.0)
    return (block, edge, *ends, pressure, pressure)


try:
    with Liar("a liar", remembers=False) as fluid:
        while motion := fluid.receive():
            lies = motion.window == window_of_the_lie
            if lies and what == "window":
                fluid._motion = motion._replace(window=99)
            if lies and what == "raise":
                raise ArithmeticError("the pump has failed")
            if lies and what == "leave":
                os._exit(0)
            if lies and what == "die":
                print("out of water", file=sys.stderr, flush=True)
                os._exit(1)
            fluid.send([panel(lies)])
except kit.FluidError as error:
    sys.exit(f"heard: {error}")
