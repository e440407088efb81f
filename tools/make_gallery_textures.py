#!/usr/bin/env python3
"""Draws the textures of the scenes in scenes/: grey PNG files, from noise with a fixed seed.

usage: tools/make_gallery_textures.py

Needs nothing but Python. Run it from the root of the project; it writes
  scenes/wet-asphalt/{stones,oil,wet}.png
  scenes/tempered-blade/{shape,oxide,brushed}.png
"""

import math
import random
import struct
import zlib


class Noise:
    """Smooth noise of period `period` in both directions, -1..1, and sums of octaves of it."""

    def __init__(self, seed):
        self.seed = seed

    def lattice(self, x, y, octave):
        return random.Random(f"{self.seed}/{octave}/{x}/{y}").uniform(-1, 1)

    def grid(self, period, octave):
        return [[self.lattice(x, y, octave) for x in range(period)] for y in range(period)]

    def octaves(self, size, first_period, count, gain=0.5):
        """A size x size picture of the sum, as rows of numbers."""
        rows = [[0.0] * size for _ in range(size)]
        amplitude, period = 1.0, first_period
        for octave in range(count):
            grid = self.grid(period, octave)
            for j in range(size):
                fy = j * period / size
                y0 = int(fy)
                ty = fy - y0
                ty = ty * ty * (3 - 2 * ty)
                upper, lower = grid[y0 % period], grid[(y0 + 1) % period]
                row = rows[j]
                for i in range(size):
                    fx = i * period / size
                    x0 = int(fx)
                    tx = fx - x0
                    tx = tx * tx * (3 - 2 * tx)
                    a, b = x0 % period, (x0 + 1) % period
                    top = upper[a] + tx * (upper[b] - upper[a])
                    bottom = lower[a] + tx * (lower[b] - lower[a])
                    row[i] += amplitude * (top + ty * (bottom - top))
            amplitude *= gain
            period *= 2
        return rows


def write_png(path, rows, bits):
    """Grey values 0..1, rows from the top."""
    most = (1 << bits) - 1
    height, width = len(rows), len(rows[0])
    raw = bytearray()
    for row in rows:
        raw.append(0)
        for value in row:
            n = round(min(1.0, max(0.0, value)) * most)
            raw += struct.pack(">H" if bits == 16 else ">B", n)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, 0, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(bytes(raw), 9)))
        file.write(chunk(b"IEND", b""))
    print("wrote", path)


def smooth(low, high, x):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def stones(size, seed):
    """Small stones in bitumen: the distance to the nearest of many points, each stone with its own grey."""
    rng = random.Random(seed)
    cells = 110
    points = {(x, y): (x + rng.random(), y + rng.random(), rng.random()) for x in range(cells) for y in range(cells)}
    fine = Noise(seed + 1).octaves(size, 64, 3)
    rows = []
    for j in range(size):
        row = []
        for i in range(size):
            px, py = i * cells / size, j * cells / size
            cx, cy = int(px), int(py)
            best = (9.0, 0.0)
            second = 9.0
            for dx in (-1, 0, 1):
                for dy in (-1, 0, 1):
                    x, y, grey = points[((cx + dx) % cells, (cy + dy) % cells)]
                    x += cells * math.floor((cx + dx) / cells)
                    y += cells * math.floor((cy + dy) / cells)
                    d = math.hypot(x - px, y - py)
                    if d < best[0]:
                        second = best[0]
                        best = (d, grey)
                    elif d < second:
                        second = d
            edge = smooth(0.02, 0.22, second - best[0])
            row.append(0.10 + edge * (0.05 + 0.20 * best[1] ** 2) + 0.03 * fine[j][i])
        rows.append(row)
    return rows


def wet_asphalt():
    size = 512
    swirl = Noise(11).octaves(size, 3, 6, 0.55)
    warp = Noise(12).octaves(size, 4, 4)
    edge = Noise(13).octaves(size, 5, 5, 0.6)
    oil, wet = [], []
    for j in range(size):
        oil_row, wet_row = [], []
        for i in range(size):
            x, y = (i + 0.5) / size - 0.5, (j + 0.5) / size - 0.5
            r = math.hypot(x * 1.05, y * 1.15) + 0.05 * warp[j][i] + 0.025 * edge[j][i]
            inside = smooth(0.40, 0.22, r)
            # Thick in the middle, thin at the rim, drawn into streaks by the water below.
            thickness = inside * (0.72 - 1.1 * max(0.0, r - 0.05)) + inside * 0.16 * swirl[j][i]
            oil_row.append(max(0.0, thickness))
            puddle = smooth(0.47, 0.36, r + 0.02 * edge[j][i])
            wet_row.append(1 - puddle)
        oil.append(oil_row)
        wet.append(wet_row)
    write_png("scenes/wet-asphalt/oil.png", oil, 16)
    write_png("scenes/wet-asphalt/wet.png", wet, 8)
    write_png("scenes/wet-asphalt/stones.png", stones(size, 3), 8)


def tempered_blade():
    width, height = 1024, 192
    noise = Noise(21).octaves(256, 8, 4)
    rng = random.Random(22)
    shape, oxide, brushed = [], [], []
    streaks = [rng.random() for _ in range(height)]
    for j in range(height):
        y = (j + 0.5) / height
        shape_row, oxide_row, brushed_row = [], [], []
        for i in range(width):
            x = (i + 0.5) / width
            # The back runs straight and drops to the tip on the right; the edge is a long curve.
            back = 0.12 + 0.62 * max(0.0, (x - 0.72) / 0.28) ** 2.2
            cut = 0.90 - 0.16 * max(0.0, (x - 0.55) / 0.45) ** 2.0
            inside = smooth(-0.012, 0.012, y - back) * smooth(-0.012, 0.012, cut - y) * smooth(0, 0.004, x)
            shape_row.append(inside)
            n = noise[(j * 2) % 256][(i * 256 // width) % 256]
            # Heated at the tang: straw at the tip, then brown, purple, blue and grey towards the left.
            heat = 1 - smooth(0.02, 0.98, x + 0.05 * n - 0.10 * (y - 0.5))
            oxide_row.append(0.08 + 0.92 * heat ** 1.4 + 0.012 * n)
            streak = streaks[j] * 0.6 + 0.4 * streaks[(j + 1) % height]
            brushed_row.append(0.35 + 0.4 * streak + 0.12 * rng.random())
        shape.append(shape_row)
        oxide.append(oxide_row)
        brushed.append(brushed_row)
    write_png("scenes/tempered-blade/shape.png", shape, 8)
    write_png("scenes/tempered-blade/oxide.png", oxide, 16)
    write_png("scenes/tempered-blade/brushed.png", brushed, 8)


if __name__ == "__main__":
    wet_asphalt()
    tempered_blade()
