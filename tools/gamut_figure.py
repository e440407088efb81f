#!/usr/bin/env python3
"""Draws docs/images/gamut-mappings.svg: Newton's colours by every gamut mapping, under D65 and A.

Usage: tools/gamut_figure.py build/release/bin/shabon
Needs Python 3 alone; the colours come from `shabon chart newton`.
"""
import base64
import csv
import io
import struct
import subprocess
import sys
import zlib
from pathlib import Path

TARGET = Path(__file__).resolve().parent.parent / "docs" / "images" / "gamut-mappings.svg"
MAPPINGS = ["clip", "reduce-chroma", "keep-hue", "gentle"]
THICKNESS_NM = (0, 2000, 2)
# lamp, side, stops of exposure (None: the brightest colour gets Y = 1), title
SERIES = [
    ("D65", "reflected", None, "reflected, D65, brightened to Y = 1"),
    ("A", "reflected", None, "reflected, A, brightened to Y = 1"),
    ("A", "transmitted", 0, "transmitted, A"),
]
LEFT, WIDTH, STRIP, GAP, TOP = 120, 640, 22, 34, 16


def colours(program, lamp, side, exposure, mapping):
    """The drawn colours over thickness as rows of (r, g, b)."""
    low, high, step = THICKNESS_NM
    command = [program, "chart", "newton", "air | 1.333 0nm | air", "--thickness", f"{low}:{high}:{step}", "--side", side,
               "--illuminant", lamp, "--gamut", mapping, "--format", "csv"]
    if exposure is not None:
        command += ["--exposure", str(exposure)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [bytes.fromhex(row["hex"][1:]) for row in csv.DictReader(io.StringIO("\n".join(lines)))]


def png(pixels):
    """One row of pixels as a PNG file."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(pixels), 1, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"\0" + b"".join(pixels), 9)) +
            chunk(b"IEND", b""))


def main():
    program = sys.argv[1]
    parts, y = [], TOP
    for lamp, side, exposure, title in SERIES:
        y += 14
        parts.append(f'<text x="{LEFT}" y="{y}" font-weight="bold">{title}</text>')
        y += 6
        for mapping in MAPPINGS:
            data = base64.b64encode(png(colours(program, lamp, side, exposure, mapping))).decode()
            parts.append(f'<text x="{LEFT - 8}" y="{y + STRIP - 7}" text-anchor="end">{mapping}</text>')
            parts.append(f'<image x="{LEFT}" y="{y}" width="{WIDTH}" height="{STRIP}" preserveAspectRatio="none" '
                         f'xlink:href="data:image/png;base64,{data}"/>')
            y += STRIP
        y += GAP - 20
    low, high, _ = THICKNESS_NM
    for nm in range(low, high + 1, 250):
        x = LEFT + WIDTH * (nm - low) / (high - low)
        parts.append(f'<line x1="{x:g}" y1="{y - 12}" x2="{x:g}" y2="{y - 7}" stroke="#444"/>')
        parts.append(f'<text x="{x:g}" y="{y + 6}" text-anchor="middle">{nm}</text>')
    parts.append(f'<text x="{LEFT + WIDTH / 2}" y="{y + 24}" text-anchor="middle">thickness (nm), n = 1.333 in air, '
                 'normal incidence</text>')
    size = f'width="{LEFT + WIDTH + 30}" height="{y + 34}"'
    TARGET.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {size} font-size="12" '
        'font-family="DejaVu Sans, Helvetica, Arial, sans-serif" fill="#1a1a1a">\n'
        '<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(parts) + "\n</svg>\n", encoding="utf-8")


if __name__ == "__main__":
    main()
