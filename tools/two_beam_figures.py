#!/usr/bin/env python3
"""The figures and tables of docs/paper.md: the two-beam film of 1989 beside the exact one.

    tools/two_beam_figures.py [--shabon build/release/bin/shabon] [--out docs/images]

writes two-beam-spectra.svg and two-beam-newton.svg and prints the tables as Markdown. All optics and all colours come
from the program; this file only differences, tabulates and draws them. Standard library alone.
"""
import argparse
import json
import math
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

MODELS = ("airy", "two-beam")
NAMES = {"airy": "exact", "two-beam": "two-beam"}
INDEX = "1.3333333333333333"
CHART_ANGLES, CHART_THICKNESS_NM = (0, 60, 85), 400
TABLE_ANGLES = (0, 20, 35, 40, 60, 75, 85)
STRIP_BRIGHTNESS = {0: 10, 60: 3.5, 85: 1}  # films reflect little at small angles; the same for both models
THICKNESSES_NM = range(0, 2001, 10)
ROOM_RADII = (0, 0.2, 0.4, 0.6, 0.7, 0.8, 0.85, 0.9, 0.94, 0.97, 0.99)

WHITE_ROOM = """shabon: 1
camera: {position: [0, 0, 4.5], look_at: [0, 0, 0], up: [0, 1, 0], vertical_fov_deg: 32}
environment: {constant: {illuminant: D65, scale: 1}}
objects:
  - bubble:
      center: [0, 0, 0]
      radius: 1
      film: {medium: 1.3333333333333333, thickness: {linear: {top_nm: 150, bottom_nm: 900}}}
"""


def ciede2000(first, second):
    """Equation (21) of docs/physics.md."""
    (L1, a1, b1), (L2, a2, b2) = first, second
    chroma = (math.hypot(a1, b1) + math.hypot(a2, b2)) / 2
    stretch = 1 + 0.5 * (1 - math.sqrt(chroma**7 / (chroma**7 + 25**7)))
    C1, C2 = math.hypot(stretch * a1, b1), math.hypot(stretch * a2, b2)
    h1, h2 = (math.degrees(math.atan2(b, stretch * a)) % 360 for a, b in ((a1, b1), (a2, b2)))
    grey = C1 * C2 == 0
    dh = 0 if grey else (h2 - h1 + 180) % 360 - 180
    if not grey and h2 - h1 == 180:
        dh = 180
    h = h1 + h2 if grey else h1 + dh / 2
    L, C, rad = (L1 + L2) / 2, (C1 + C2) / 2, math.radians
    dL, dC, dH = L2 - L1, C2 - C1, 2 * math.sqrt(C1 * C2) * math.sin(rad(dh / 2))
    theta = (1 - 0.17 * math.cos(rad(h - 30)) + 0.24 * math.cos(rad(2 * h))
             + 0.32 * math.cos(rad(3 * h + 6)) - 0.20 * math.cos(rad(4 * h - 63)))
    S_L = 1 + 0.015 * (L - 50)**2 / math.sqrt(20 + (L - 50)**2)
    S_C, S_H = 1 + 0.045 * C, 1 + 0.015 * C * theta
    h %= 360
    R_T = (-2 * math.sqrt(C**7 / (C**7 + 25**7))
           * math.sin(rad(60 * math.exp(-((h - 275) / 25)**2))))
    l, c, k = dL / S_L, dC / S_C, dH / S_H
    return math.sqrt(l * l + c * c + k * k + R_T * c * k)


class Program:
    def __init__(self, path):
        self.path = path

    def json(self, *arguments):
        command = [self.path, *map(str, arguments), "--format", "json"]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

    def colours(self, angle, model, transmitted):
        """What `shabon color` says of every thickness."""
        extra = ("--transmitted",) if transmitted else ()
        with ThreadPoolExecutor(2) as pool:
            return list(pool.map(lambda d: self.json("color", f"air | {INDEX} {d}nm | air", "--angle", angle,
                                                     "--interference", model, *extra), THICKNESSES_NM))


# --- drawing -----------------------------------------------------------------------------------------------------

def text(x, y, words, anchor="start", size=13):
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}" font-size="{size}">{words}</text>'


def svg(width, height, parts):
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="sans-serif" fill="#222">')
    return "\n".join([head, f'<rect width="{width}" height="{height}" fill="#fff"/>', *parts, "</svg>"]) + "\n"


def spectra_chart(program):
    """Reflectance over wavelength, one panel an angle, both models, the mean of s and p."""
    wide, high, left, top, step = 240, 190, 48, 58, 300
    parts = [text(left, 22, f"R of a film of {CHART_THICKNESS_NM} nm, n = 4/3, unpolarised", size=15)]
    for i, (model, dash) in enumerate((("airy", ""), ("two-beam", ' stroke-dasharray="5 4"'))):
        x = left + 420 + 150 * i
        parts += [f'<path d="M{x} 17h30" stroke="{COLOUR[model]}" stroke-width="2" fill="none"{dash}/>',
                  text(x + 36, 22, NAMES[model])]
    for panel, angle in enumerate(CHART_ANGLES):
        x0 = left + panel * step
        curves = {}
        for model in MODELS:
            rows = subprocess.run([program.path, "spectrum", f"air | {INDEX} {CHART_THICKNESS_NM}nm | air", "--angle",
                                   str(angle), "--interference", model, "--wavelengths", "380:780:2"],
                                  check=True, capture_output=True, text=True).stdout.splitlines()[1:]
            curves[model] = [(float(v[0]), (float(v[1]) + float(v[2])) / 2) for v in (r.split(",") for r in rows)]
        highest = max(R for curve in curves.values() for _, R in curve)
        unit = next(u for u in (0.02, 0.05, 0.1, 0.2, 0.25) if highest / u <= 6)
        limit = unit * math.ceil(highest / unit)
        px = lambda nm: x0 + wide * (nm - 380) / 400
        py = lambda R: top + high * (1 - R / limit)
        parts.append(text(x0 + wide / 2, top - 10, f"{angle}°", "middle", 14))
        for k in range(round(limit / unit) + 1):
            y = py(k * unit)
            parts += [f'<path d="M{x0} {y:.1f}h{wide}" stroke="#ddd"/>',
                      text(x0 - 6, y + 4, f"{k * unit:g}", "end", 11)]
        for nm in (400, 500, 600, 700):
            parts.append(text(px(nm), top + high + 17, str(nm), "middle", 11))
        parts.append(text(x0 + wide / 2, top + high + 36, "wavelength (nm)", "middle", 12))
        for model, dash in (("airy", ""), ("two-beam", ' stroke-dasharray="5 4"')):
            points = " ".join(f"{px(nm):.1f},{py(R):.1f}" for nm, R in curves[model])
            parts.append(f'<polyline points="{points}" fill="none" stroke="{COLOUR[model]}" stroke-width="2"{dash}/>')
    return svg(left + 3 * step - 40, top + high + 48, parts)


COLOUR = {"airy": "#1f5fa8", "two-beam": "#c4541a"}


def brightened(encoded, factor):
    """(19) undone, multiplied, and done again; as #rrggbb."""
    def component(v):
        linear = v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055)**2.4
        linear = min(1, factor * linear)
        return math.floor(255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear**(1 / 2.4) - 0.055) + 0.5)
    return "#" + "".join(f"{component(v):02x}" for v in encoded)


def newton_strips(reflected):
    """The reflected colour over thickness, one pair of strips an angle."""
    left, top, bar, width, gap = 118, 34, 34, 804, 18
    each = width / len(THICKNESSES_NM)
    parts = [text(left, 20, "Light reflected by a film of n = 4/3 under D65, brought into sRGB", size=15)]
    y = top
    for angle, factor in STRIP_BRIGHTNESS.items():
        for model in MODELS:
            parts.append(text(left - 8, y + bar / 2 + 5, f"{angle}° {NAMES[model]}", "end"))
            parts.append('<g shape-rendering="crispEdges" stroke="none">' + "".join(
                f'<path fill="{brightened(colour["srgb_mapped"], factor)}" '
                f'd="M{left + i * each:g} {y}h{each:g}v{bar}h-{each:g}z"/>'
                for i, colour in enumerate(reflected[angle, model])) + "</g>")
            y += bar
        if factor != 1:
            parts.append(text(left + width + 8, y - bar + 5, f"× {factor:g}"))
        y += gap
    for nm in range(0, 2001, 250):
        parts.append(text(left + (nm / 10 + 0.5) * each, y, str(nm), "middle", 11))
    parts.append(text(left + width / 2, y + 18, "thickness (nm)", "middle", 12))
    return svg(left + width + 48, y + 28, parts)


# --- tables ------------------------------------------------------------------------------------------------------

def difference_table(colours):
    print("| angle | reflected: mean | most | transmitted: mean | most |\n|---|---|---|---|---|")
    for angle in TABLE_ANGLES:
        cells = []
        for transmitted in (False, True):
            pairs = zip(colours[transmitted][angle, "airy"], colours[transmitted][angle, "two-beam"])
            apart = [ciede2000(a["Lab"], b["Lab"]) for a, b in pairs]
            cells += [f"{sum(apart) / len(apart):.1f}", f"{max(apart):.1f}"]
        print(f"| {angle}° | " + " | ".join(cells) + " |")


def room_table(program):
    print("\n| distance from the middle | angle at the wall | airy: Y | two-beam: Y | two-beam: linear sRGB |\n"
          "|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "white-room.yaml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(WHITE_ROOM)
        for r in ROOM_RADII:
            seen = {m: program.json("probe", scene, "--ray", r, 0, 5, 0, 0, -1, "--interference", m) for m in MODELS}
            rgb = ", ".join(f"{v:.3f}" for v in seen["two-beam"]["linear_srgb"])
            print(f"| {r} | {math.degrees(math.asin(r)):.0f}° | {seen['airy']['XYZ'][1]:.6f} | "
                  f"{seen['two-beam']['XYZ'][1]:.3f} | {rgb} |")


def main():
    options = argparse.ArgumentParser(description="The figures and tables of docs/paper.md.")
    options.add_argument("--shabon", default="build/release/bin/shabon", help="the program [%(default)s]")
    options.add_argument("--out", default="docs/images", help="folder of the figures [%(default)s]")
    chosen = options.parse_args()
    program = Program(chosen.shabon)
    colours = {transmitted: {(angle, model): program.colours(angle, model, transmitted)
                             for angle in TABLE_ANGLES for model in MODELS} for transmitted in (False, True)}
    for name, drawing in (("two-beam-spectra.svg", spectra_chart(program)),
                          ("two-beam-newton.svg", newton_strips(colours[False]))):
        with open(os.path.join(chosen.out, name), "w", encoding="utf-8") as file:
            file.write(drawing)
    difference_table(colours)
    room_table(program)


if __name__ == "__main__":
    main()
