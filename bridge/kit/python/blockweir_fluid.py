# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid of one's own as the partner of blockweir's solid: bridge/wire/README.md in Python.

    with Fluid("mine") as fluid:            # connects to $BLOCKWEIR_ENDPOINT and shakes hands
        while motion := fluid.receive():    # None: the run is complete
            ...
            fluid.send(panels=[(block, edge, s_from, s_to, pressure_from_pa, pressure_to_pa), ...])

Lengths are in m, times in s, pressures in Pa (compression positive), all per metre of thickness. It needs pyzmq,
flatbuffers and xxhash (Debian: python3-zmq, python3-flatbuffers, python3-xxhash), and nothing to be compiled.
"""

import json
import math
import os
import struct
import time
from collections import namedtuple

import flatbuffers
import flatbuffers.number_types as numbers
import xxhash
import zmq
from flatbuffers.table import Table

PROTOCOL = 10
_HELLO, _MOTION, _LOAD, _FAREWELL, _FAILURE, _PROGRESS = range(1, 7)
_LARGE = 1 << 18  # bytes from which on a column is a part of its own
_TRAILER = struct.Struct("<QQ")  # bytes of columns in the frame, checksum
_UNREADABLE = (struct.error, IndexError, ValueError, TypeError, OverflowError, MemoryError)  # of a table that is none


class FluidError(Exception):
    """The run cannot go on: what the solid said, or why it cannot be talked to. One line for the user."""


class BadMessage(FluidError):
    """Bytes that are no message of this protocol."""


Block = namedtuple("Block", "name vertices")
Block.__doc__ = "A block as the scene draws it: its name, and its vertices [(x, y)], counter-clockwise [m]."


class Motion(namedtuple("Motion", "window time_s save displacement velocity")):
    """Where the blocks are, or will be, at time_s, to which the fluid is to step.

    displacement and velocity: per block (u, v [m], turn [rad], ex, ey, gxy) of its centroid since the scene's outline,
    and their rates. save: the fluid's state before this motion was to be saved; receive() has called `save` already.
    """


def centroid(vertices):
    """Of a polygon [m]."""
    x0, y0 = vertices[0]
    twice, cx, cy = 0.0, 0.0, 0.0
    for (xa, ya), (xb, yb) in zip(vertices, vertices[1:] + vertices[:1]):
        xa, ya, xb, yb = xa - x0, ya - y0, xb - x0, yb - y0
        cross = xa * yb - xb * ya
        twice, cx, cy = twice + cross, cx + (xa + xb) * cross, cy + (ya + yb) * cross
    return x0 + cx / (3 * twice), y0 + cy / (3 * twice)


def place(vertices, displacement):
    """Where the vertices of a block are now [m]: strained, then turned, then shifted with the centroid."""
    u, v, turn, ex, ey, gxy = displacement
    cx, cy = centroid(vertices)
    c, s = math.cos(turn), math.sin(turn)
    now = []
    for x, y in vertices:
        dx, dy = x - cx, y - cy
        dx, dy = dx + ex * dx + gxy / 2 * dy, dy + ey * dy + gxy / 2 * dx
        now.append((cx + u + c * dx - s * dy, cy + v + s * dx + c * dy))
    return now


class Fluid:
    """The line to the solid, from the handshake to the end of the run.

    blocks: list of Block in the order of the scene, by whose index panels name them; window_s, duration_s, schedule,
    scene_digest: as the solid stated them; first_window: 0, or the number of the motion with which a run is resumed.
    save(window): called before the motion of that window where the state is to be saved, into checkpoint_file(window);
    restore(window): called once where a run is resumed. Without them a resumed run is refused, unless
    remembers=False: the pressures depend on place and time alone.
    Raises FluidError.
    """

    def __init__(self, role, endpoint=None, save=None, restore=None, remembers=True, timeout_s=None):
        self.role = role
        self.endpoint = endpoint or os.environ.get("BLOCKWEIR_ENDPOINT", "")
        if not self.endpoint:
            raise FluidError("no endpoint: set BLOCKWEIR_ENDPOINT, or let \"blockweir run\" start this program")
        self.timeout_s = float(timeout_s or os.environ.get("BLOCKWEIR_TIMEOUT_S", 60))
        self.folder = os.environ.get("BLOCKWEIR_FOLDER", "")
        self._save, self._remembers = save, remembers
        self._seconds = {"wait": 0.0, "step": 0.0}
        self._motion, self._answers, self._last_sent, self._trace = None, 0, time.monotonic(), None
        self._context = zmq.Context()
        self._socket = self._context.socket(zmq.PAIR)
        self._socket.setsockopt(zmq.LINGER, 1000)
        self._socket.setsockopt(zmq.RECONNECT_IVL, 5)
        # Beats are answered by ZeroMQ itself, while this program computes. Twice 3e6 ms is below 65,535 tenths of a
        # second, which is as long as ZeroMQ can tell.
        beat_ms = int(max(100, min(250 * self.timeout_s, 3e6)))
        for option, ms in ((zmq.HEARTBEAT_IVL, beat_ms), (zmq.HEARTBEAT_TTL, 2 * beat_ms),
                           (zmq.HEARTBEAT_TIMEOUT, 2 * beat_ms)):
            self._socket.setsockopt(option, ms)
        self._events = self._socket.get_monitor_socket(zmq.EVENT_DISCONNECTED)
        try:
            self._socket.connect(self.endpoint)
            self._shake_hands()
            if self.first_window > 0 and restore is not None:
                restore(self.first_window)
            elif self.first_window > 0 and remembers:
                raise self._failed("this fluid cannot go on from a checkpoint: run it anew")
        except zmq.ZMQError as error:
            self._context.destroy(linger=0)
            raise FluidError(f"cannot connect to {self.endpoint}: {error}") from error
        except BaseException:
            self._context.destroy(linger=1000)
            raise
        self._trace = self._open_trace()

    def __enter__(self):
        return self

    def __exit__(self, kind, error, _):
        if isinstance(error, SystemExit):
            self.fail(error.code if isinstance(error.code, str) else "it left before the run was complete")
        elif error is not None and not isinstance(error, FluidError):
            self.fail(f"{kind.__name__}: {error}")
        self.close()

    def receive(self):
        """The next Motion; None where the run is complete. Raises FluidError where it is not and cannot go on."""
        while True:
            begin = time.monotonic_ns()
            kind, table, frame = self._next("in window %d" % (self._motion.window + 1 if self._motion else self.first_window))
            end = time.monotonic_ns()
            self._seconds["wait"] += (end - begin) / 1e9
            if kind == _FAREWELL:
                self._report()
                return None
            if kind != _MOTION:
                raise self._blamed(f"a message of kind {kind} where a motion was due")
            motion, order = self._motion_of(table, frame)
            self._note("wait", motion.window, begin, end)
            if order > 0 and self._save is not None:
                self._save(motion.window)
            self._motion = motion
            self._stepping_since = time.monotonic()
            if order != 2:
                return motion

    def send(self, panels=(), upstream_level_m=math.nan, downstream_level_m=math.nan, cracks_from=None, breached=False,
             holds_until_s=None, added_mass=()):
        """Answers the last Motion with the pressures at its time.

        panels: (block, edge, s_from, s_to, pressure_from_pa, pressure_to_pa) each, edge i from vertex i to vertex i + 1
        of the block, 0 <= s_from <= s_to <= 1 fractions of it; those in cracks stand last, from index cracks_from on.
        Levels: NaN where there is no pool. holds_until_s: until then the pressures stay while no block moves.
        added_mass: 6 numbers a block (xx, xy, xr, yy, yr, rr), or nothing.
        """
        begin = time.monotonic_ns()
        self._seconds["step"] += time.monotonic() - self._stepping_since
        motion, panels = self._motion, list(panels)
        rows = list(zip(*panels)) if panels else [()] * 6
        columns = [struct.pack(f"<{len(panels)}d", *rows[i]) for i in (2, 3, 4, 5)]
        masses = [number for row in added_mass for number in row]
        columns.append(struct.pack(f"<{len(masses)}d", *masses))
        columns += [struct.pack(f"<{len(panels)}I", *rows[i]) for i in (0, 1)]
        builder = flatbuffers.Builder(1024)
        sums = _column_sums(builder, columns)
        builder.StartObject(8)
        builder.PrependUint64Slot(0, motion.window, 0)
        builder.PrependFloat64Slot(1, motion.time_s, 0.0)
        builder.PrependFloat64Slot(2, float(upstream_level_m), 0.0)
        builder.PrependFloat64Slot(3, float(downstream_level_m), 0.0)
        builder.PrependBoolSlot(4, breached, False)
        builder.PrependUint32Slot(5, len(panels) if cracks_from is None else cracks_from, 0)
        builder.PrependFloat64Slot(6, motion.time_s if holds_until_s is None else float(holds_until_s), 0.0)
        builder.PrependUOffsetTRelativeSlot(7, sums, 0)
        self._send_frame(_LOAD, builder, builder.EndObject(), columns)
        self._answers += 1
        self._note("send", motion.window, begin, time.monotonic_ns())

    def progress(self, text):
        """To be called while a step takes long, whenever it has come further: the solid then waits on."""
        if time.monotonic() - self._last_sent > self.timeout_s / 4:
            self._send_text(_PROGRESS, text)

    def fail(self, text):
        """Tells the solid, and the user, why this fluid cannot go on."""
        self._send_text(_FAILURE, text)

    def checkpoint_file(self, window):
        """Where save(window) is to put the state, and restore(window) finds it."""
        folder = os.path.join(self.folder, "checkpoint")
        os.makedirs(folder, exist_ok=True)
        return os.path.join(folder, f"external-{window}")

    def close(self):
        if self._trace is not None:
            self._trace.close()
        self._socket.disable_monitor()
        self._context.destroy(linger=1000)

    # The rest is the protocol.

    def _shake_hands(self):
        kind, table, _ = self._next("at the handshake")
        if kind != _HELLO:
            raise self._blamed(f"a message of kind {kind} where Hello was due")
        self._hear_hello(table)

    def _hear_hello(self, table):
        try:
            self._agree(table)
        except _UNREADABLE:
            raise self._blamed("a Hello that cannot be read") from None

    def _agree(self, table):
        """Reads the solid's Hello, and says the same, but for role and build."""
        protocol = _scalar(table, 0, numbers.Uint32Flags, 0)
        if protocol != PROTOCOL:
            raise self._failed(f"handshake refused: protocol: solid has {protocol}, {self.role} has {PROTOCOL}")
        digest, schedule, units = (_text(table, slot) for slot in (3, 4, 5))
        self.scene_digest, self.schedule = digest, schedule
        self.window_s, self.duration_s = (_scalar(table, slot, numbers.Float64Flags, 0.0) for slot in (6, 7))
        self.first_window = _scalar(table, 11, numbers.Uint64Flags, 0)
        names, counts, flat = _texts(table, 8), _vector(table, 9, "I"), _vector(table, 10, "d")
        if len(names) != len(counts) or 2 * sum(counts) != len(flat):
            raise self._blamed("blocks whose outlines do not fit their number")
        points = list(zip(flat[0::2], flat[1::2]))
        self.blocks = []
        for name, count in zip(names, counts):
            self.blocks.append(Block(name, points[:count]))
            del points[:count]
        builder = flatbuffers.Builder(1024)
        texts = [builder.CreateString(text) for text in (self.role, "python", digest, schedule, units)]
        listed = [builder.CreateString(name) for name in names]
        builder.StartVector(4, len(listed), 4)
        for offset in reversed(listed):
            builder.PrependUOffsetTRelative(offset)
        vectors = [builder.EndVector(), _numbers(builder, counts, "I"), _numbers(builder, flat, "d")]
        builder.StartObject(12)
        builder.PrependUint32Slot(0, PROTOCOL, 0)
        for slot, offset in zip((1, 2, 3, 4, 5, 8, 9, 10), texts + vectors):
            builder.PrependUOffsetTRelativeSlot(slot, offset, 0)
        builder.PrependFloat64Slot(6, self.window_s, 0.0)
        builder.PrependFloat64Slot(7, self.duration_s, 0.0)
        builder.PrependUint64Slot(11, self.first_window, 0)
        self._send_frame(_HELLO, builder, builder.EndObject())

    def _next(self, moment):
        """The next message that is no progress: kind, table, frame."""
        while True:
            self._wait(moment)
            try:
                kind, table, frame = read_frame(self._socket.recv())
            except BadMessage as bad:
                raise self._blamed(str(bad)) from None
            if kind == _FAILURE:
                raise FluidError(f"the solid stopped {moment}: {self._said(table)}")
            if kind != _PROGRESS:
                return kind, table, frame

    def _wait(self, moment):
        """Until a message is there."""
        poller = zmq.Poller()
        for socket in (self._socket, self._events):
            poller.register(socket, zmq.POLLIN)
        ready = dict(poller.poll(int(min(1000 * self.timeout_s, 2e9))))
        if not ready:
            raise FluidError(f"the solid has been silent for {self.timeout_s:g} s at {self.endpoint} {moment}")
        if self._socket not in ready and not self._socket.poll(100):  # what it sent last may still be on its way
            raise FluidError(f"the solid closed the line {moment}; see its own message for the cause")

    def _said(self, table):
        try:
            return " ".join(_text(table, 0).split())
        except _UNREADABLE:
            raise self._blamed("a text that cannot be read") from None

    def _motion_of(self, table, frame):
        try:
            return self._read_motion(table, frame)
        except _UNREADABLE:
            raise self._blamed("a motion that cannot be read") from None

    def _read_motion(self, table, frame):
        window = _scalar(table, 0, numbers.Uint64Flags, 0)
        due = self._motion.window + 1 if self._motion else self.first_window
        if window != due:
            raise self._blamed(f"window {window} where window {due} was due")
        try:
            columns = read_columns(table, 3, frame, 2, self._next_part)
            rows = [list(struct.iter_unpack("<6d", column)) for column in columns]
        except BadMessage as bad:
            raise self._blamed(f"{bad} in window {window}") from None
        if any(len(row) != len(self.blocks) for row in rows):
            raise self._blamed(f"positions of {len(rows[0])} blocks in window {window}, the handshake was on {len(self.blocks)}")
        order = _scalar(table, 2, numbers.Uint8Flags, 0)
        return Motion(window, _scalar(table, 1, numbers.Float64Flags, 0.0), order > 0, *rows), order

    def _next_part(self):
        return self._socket.recv() if self._socket.getsockopt(zmq.RCVMORE) else b""

    def _send_text(self, kind, text):
        builder = flatbuffers.Builder(256)
        offset = builder.CreateString(text)
        builder.StartObject(1)
        builder.PrependUOffsetTRelativeSlot(0, offset, 0)
        self._send_frame(kind, builder, builder.EndObject())

    def _send_frame(self, kind, builder, body, columns=()):
        parts = make_frame(kind, builder, body, columns)
        try:
            self._socket.send_multipart(parts, flags=zmq.DONTWAIT)
        except zmq.Again:
            pass  # nobody is there to hear it; receive() says so
        self._last_sent = time.monotonic()

    def _failed(self, text):
        self.fail(text)
        return FluidError(text)

    def _blamed(self, what):
        return self._failed(f"the solid sent {what}")

    def _report(self):
        path = os.environ.get("BLOCKWEIR_REPORT", "")
        if path:
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"seconds": self._seconds, "counts": {"answers": self._answers}}, file)

    def _open_trace(self):
        folder = os.environ.get("BLOCKWEIR_TRACE", "")
        if not folder or "/" in self.role:
            return None
        trace = open(os.path.join(folder, self.role + ".csv"), "w", encoding="utf-8")
        trace.write("what,window,from_ns,to_ns\n")
        return trace

    def _note(self, what, window, begin_ns, end_ns):
        if self._trace is not None:
            self._trace.write(f"{what},{window},{begin_ns},{end_ns}\n")


# Frames: a table, its columns, their number of bytes, the checksum of the table.


def make_frame(kind, builder, body, columns=()):
    """The parts of a message: the frame, and its large columns."""
    builder.StartObject(2)
    builder.PrependUint8Slot(0, kind, 0)
    builder.PrependUOffsetTRelativeSlot(1, body, 0)
    builder.Finish(builder.EndObject(), b"BLKW")
    table = bytes(builder.Output())
    inside = b"".join(reversed([column for column in columns if len(column) < _LARGE]))
    padding = b"\0" * (-len(table) % 8)  # so that the columns are aligned
    trailer = _TRAILER.pack(len(inside), xxhash.xxh3_64_intdigest(table + padding, seed=len(inside)))
    return [table + padding + inside + trailer] + [column for column in columns if len(column) >= _LARGE]


def read_frame(frame):
    """Kind, table and the frame itself. Raises BadMessage where it is damaged or no message."""
    damaged = BadMessage(f"{len(frame)} bytes that are damaged, or not of protocol {PROTOCOL}")
    if len(frame) <= _TRAILER.size:
        raise damaged
    columns, checksum = _TRAILER.unpack(frame[-_TRAILER.size:])
    length = len(frame) - _TRAILER.size - columns
    if length < 8 or checksum != xxhash.xxh3_64_intdigest(frame[:length], seed=columns) or frame[4:8] != b"BLKW":
        raise damaged
    try:
        envelope = Table(frame, struct.unpack_from("<I", frame)[0])
        kind, body = _scalar(envelope, 0, numbers.Uint8Flags, 0), envelope.Offset(6)
        if not 1 <= kind <= 6 or body == 0:
            raise BadMessage(f"a message of {len(frame)} bytes without a known body")
        table = Table(frame, envelope.Indirect(envelope.Pos + body))
        table.Offset(4)
    except _UNREADABLE:
        raise damaged from None
    return kind, table, frame


def read_columns(table, slot, frame, count, next_part):
    """The bytes of the `count` columns that the table tells of, all verified. Raises BadMessage."""
    told = _offset(table, slot)
    if told == 0 or table.VectorLen(told) != count:
        raise BadMessage("columns that are missing, or too many")
    start, columns = table.Vector(told), []
    end = len(frame) - _TRAILER.size
    left = _TRAILER.unpack(frame[-_TRAILER.size:])[0]
    for i in range(count):
        size, checksum = _TRAILER.unpack_from(frame, start + i * _TRAILER.size)
        if size >= _LARGE:
            column = next_part()
        elif size <= left:
            column, end, left = frame[end - size:end], end - size, left - size
        else:
            raise BadMessage("columns that are cut short")
        if len(column) != size or xxhash.xxh3_64_intdigest(column) != checksum:
            raise BadMessage("columns that are damaged")
        columns.append(column)
    return columns


def _column_sums(builder, columns):
    builder.StartVector(16, len(columns), 8)
    for column in reversed(columns):
        builder.PrependUint64(xxhash.xxh3_64_intdigest(column))
        builder.PrependUint64(len(column))
    return builder.EndVector()


def _numbers(builder, values, form):
    size = struct.calcsize(form)
    builder.StartVector(size, len(values), size)
    for value in reversed(values):
        builder.PrependUint32(value) if form == "I" else builder.PrependFloat64(value)
    return builder.EndVector()


def _offset(table, slot):
    return table.Offset(4 + 2 * slot)


def _scalar(table, slot, flags, default):
    offset = _offset(table, slot)
    return table.Get(flags, table.Pos + offset) if offset else default


def _text(table, slot):
    offset = _offset(table, slot)
    return table.String(table.Pos + offset).decode("utf-8", "replace") if offset else ""


def _texts(table, slot):
    offset = _offset(table, slot)
    if offset == 0:
        return []
    start = table.Vector(offset)
    return [table.String(start + 4 * i).decode("utf-8", "replace") for i in range(table.VectorLen(offset))]


def _vector(table, slot, form):
    offset = _offset(table, slot)
    return list(struct.unpack_from(f"<{table.VectorLen(offset)}{form}", table.Bytes, table.Vector(offset))) if offset else []
