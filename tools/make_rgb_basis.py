#!/usr/bin/env python3
"""Computes data/rgb_basis.csv: three smooth spectra that stand for the sRGB primaries. Run it from the project's root.

The sum over the three spectra of the squared second differences is least, subject to
  0 <= basis <= 1 and r + g + b = 1 at every nanometre, and
  the linear sRGB colours (w_r, 0, 0), (0, w_g, 0), (0, 0, w_b) under the tabulated D65, where w is the colour of the
  perfect reflector there (1.00016, 0.99998, 0.99976): equation (22) of docs/physics.md.
b = 1 - r - g leaves a convex quadratic programme in r and g with six equations. It is solved by a primal-dual
interior-point method with Mehrotra's corrector (J. Nocedal, S. Wright, Numerical Optimization, 2nd edition, chapter
16.6); with r and g interleaved the matrix has four diagonals on either side, so plain Python takes seconds.
"""

import csv
import sys

BAND = 5  # second differences reach two wavelengths, that is four places of the interleaved vector, plus r beside g
DIGITS = 15  # of every value written; the three of a row then sum to 1 exactly


def read_columns(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
    return [[float(text) for text in column] for column in zip(*rows)]


def invert(m):
    """The inverse of a 3 by 3 matrix, by cofactors."""
    def cofactor(i, j):
        a, b = [k for k in range(3) if k != i]
        c, d = [k for k in range(3) if k != j]
        return (-1) ** (i + j) * (m[a][c] * m[b][d] - m[a][d] * m[b][c])

    determinant = sum(m[0][j] * cofactor(0, j) for j in range(3))
    return [[cofactor(j, i) / determinant for j in range(3)] for i in range(3)]


def xyz_to_srgb():
    """From the primaries and the white of IEC 61966-2-1."""
    columns = [(x / y, 1.0, (1 - x - y) / y) for x, y in ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06), (0.3127, 0.3290))]
    primaries, white = [list(row) for row in zip(*columns[:3])], columns[3]
    scale = [sum(a * b for a, b in zip(row, white)) for row in invert(primaries)]
    return invert([[value * s for value, s in zip(row, scale)] for row in primaries])


def colour_weights():
    """weights[k][i]: what reflectance 1 at wavelength i adds to component k of linear sRGB."""
    _, x, y, z = read_columns("data/observer_cie_1931.csv")
    wavelengths, power = read_columns("data/illuminant_d65.csv")
    total = sum(s * v for s, v in zip(power, y))
    matrix = xyz_to_srgb()
    weights = [[s * (row[0] * a + row[1] * b + row[2] * c) / total for s, a, b, c in zip(power, x, y, z)]
               for row in matrix]
    return [int(w) for w in wavelengths], weights


def roughness_bands(count):
    """The lower bands of the Hessian of the objective in the interleaved unknowns: bands[k][i] is entry (i + k, i)."""
    size = 2 * count
    bands = [[0.0] * size for _ in range(BAND + 1)]
    for i in range(1, count - 1):
        for p, u in ((i - 1, 1.0), (i, -2.0), (i + 1, 1.0)):
            for q, v in ((i - 1, 1.0), (i, -2.0), (i + 1, 1.0)):
                for row, column, share in ((0, 0, 4.0), (1, 1, 4.0), (0, 1, 2.0), (1, 0, 2.0)):
                    a, b = 2 * p + row, 2 * q + column
                    if a >= b:  # the lower half
                        bands[a - b][b] += share * u * v
    return bands


def multiply(bands, vector):
    result = [d * v for d, v in zip(bands[0], vector)]
    for k in range(1, BAND + 1):
        band = bands[k]
        for i in range(len(vector) - k):
            result[i + k] += band[i] * vector[i]
            result[i] += band[i] * vector[i + k]
    return result


def factor(bands):
    """Cholesky's factor of a symmetric banded matrix, in the same storage."""
    size = len(bands[0])
    lower = [list(band) for band in bands]
    for j in range(size):
        for k in range(1, min(BAND, j) + 1):
            left = lower[k][j - k]
            if left == 0.0:
                continue
            for m in range(k, BAND + 1):
                if j - k + m < size:
                    lower[m - k][j] -= left * lower[m][j - k]
        pivot = lower[0][j] ** 0.5
        lower[0][j] = pivot
        for m in range(1, BAND + 1):
            lower[m][j] /= pivot
    return lower


def solve_factored(lower, right):
    size, x = len(right), list(right)
    for i in range(size):
        for k in range(1, min(BAND, i) + 1):
            x[i] -= lower[k][i - k] * x[i - k]
        x[i] /= lower[0][i]
    for i in reversed(range(size)):
        for k in range(1, min(BAND, size - 1 - i) + 1):
            x[i] -= lower[k][i] * x[i + k]
        x[i] /= lower[0][i]
    return x


def solve_dense(matrix, right):
    """Gauss with row pivots; six unknowns."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    size = len(rows)
    for j in range(size):
        pivot = max(range(j, size), key=lambda i: abs(rows[i][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        for i in range(size):
            if i != j:
                share = rows[i][j] / rows[j][j]
                rows[i] = [a - share * b for a, b in zip(rows[i], rows[j])]
    return [rows[i][size] / rows[i][i] for i in range(size)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def slack(x):
    """r, g and b at every wavelength; all must stay positive."""
    return [v for r, g in zip(x[::2], x[1::2]) for v in (r, g, 1 - r - g)]


def slack_change(dx):
    return [v for r, g in zip(dx[::2], dx[1::2]) for v in (r, g, -r - g)]


def slack_transposed(z):
    return [v for i in range(0, len(z), 3) for v in (z[i] - z[i + 2], z[i + 1] - z[i + 2])]


def largest_step(values, changes):
    return min([1.0] + [-v / d for v, d in zip(values, changes) if d < 0])


def solve(hessian, equations, targets):
    """The x that makes x H x / 2 least subject to equations x = targets and slack(x) >= 0."""
    size = len(hessian[0])
    x = [1 / 3] * size
    s = slack(x)
    z = [1.0] * len(s)
    y = [0.0] * len(equations)
    for iteration in range(200):
        hx = multiply(hessian, x)
        dual = [h - gz - sum(yi * row[i] for yi, row in zip(y, equations))
                for i, (h, gz) in enumerate(zip(hx, slack_transposed(z)))]
        primal = [dot(row, x) - t for row, t in zip(equations, targets)]
        mu = dot(s, z) / len(s)
        print(f"{iteration:3d}  gap {mu:.1e}  equations {max(map(abs, primal)):.1e}  "
              f"gradient {max(map(abs, dual)):.1e}  roughness {dot(x, hx) / 2:.9e}", file=sys.stderr)
        if mu < 1e-16 and max(map(abs, primal)) < 1e-13:
            return x
        bands = [list(band) for band in hessian]
        for i in range(size // 2):
            dr, dg, db = (z[3 * i + k] / s[3 * i + k] for k in range(3))
            bands[0][2 * i] += dr + db
            bands[0][2 * i + 1] += dg + db
            bands[1][2 * i] += db
        lower = factor(bands)
        columns = [solve_factored(lower, row) for row in equations]
        schur = [[dot(row, column) for column in columns] for row in equations]

        def newton(complement):
            """The step for which s dz + z ds = complement."""
            right = [a - b for a, b in zip(slack_transposed([c / v for c, v in zip(complement, s)]), dual)]
            free = solve_factored(lower, right)
            dy = solve_dense(schur, [-p - dot(row, free) for p, row in zip(primal, equations)])
            dx = [v + sum(d * column[i] for d, column in zip(dy, columns)) for i, v in enumerate(free)]
            ds = slack_change(dx)
            return dx, ds, [(c - zz * d) / v for c, zz, d, v in zip(complement, z, ds, s)], dy

        _, ds, dz, _ = newton([-a * b for a, b in zip(s, z)])
        step = min(largest_step(s, ds), largest_step(z, dz))
        after = dot([a + step * d for a, d in zip(s, ds)], [a + step * d for a, d in zip(z, dz)]) / len(s)
        centre = (after / mu) ** 3 * mu
        dx, ds, dz, dy = newton([centre - a * b - c * d for a, b, c, d in zip(s, z, ds, dz)])
        step = 0.995 * min(largest_step(s, ds), largest_step(z, dz))
        x = [a + step * d for a, d in zip(x, dx)]
        s = slack(x)
        z = [a + step * d for a, d in zip(z, dz)]
        y = [a + step * d for a, d in zip(y, dy)]
    raise SystemExit("no convergence")


def main():
    wavelengths, weights = colour_weights()
    count = len(wavelengths)
    white = [sum(row) for row in weights]
    equations, targets = [], []
    for basis in range(2):
        for k in range(3):
            row = [0.0] * (2 * count)
            row[basis::2] = weights[k]
            equations.append(row)
            targets.append(white[k] if k == basis else 0.0)
    x = solve(roughness_bands(count), equations, targets)

    unit = 10**DIGITS
    with open("data/rgb_basis.csv", "w", encoding="utf-8") as file:
        file.write("# name: rgb_basis\n"
                   "# description: smooth spectra of the sRGB primaries under the tabulated D65; they sum to 1\n"
                   "# unit: dimensionless; wavelengths in nm\n"
                   "# source: computed by tools/make_rgb_basis.py from observer_cie_1931.csv and illuminant_d65.csv\n"
                   "# licence: Apache-2.0, as the project itself\n"
                   "wavelength_nm,r,g,b\n")
        for wavelength, r, g in zip(wavelengths, x[::2], x[1::2]):
            r, g = round(r * unit), round(g * unit)
            values = [f"{v // unit}.{v % unit:0{DIGITS}d}" for v in (r, g, unit - r - g)]
            file.write(f"{wavelength},{','.join(values)}\n")


if __name__ == "__main__":
    main()
