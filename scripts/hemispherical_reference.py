#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bi-hemispherical reference values for facets that are hard to integrate, by a route that shares nothing with the library.

Rays are traced in real space between the two panels (no unfolding, no bounce-count formula); the positions at which the
bounce count changes are found by bisection; Fresnel's equations are used in their textbook complex form; and the
integrals over theta' and psi use tanh-sinh quadrature, which does not mind square roots at the ends of a panel. A panel
is cut wherever the sequence of bounces may change and at the critical angle. Polarised light is a complex field vector,
split at every mirror into its parts normal to and in the plane of incidence.

Prints JSON: rows of aperture_deg, n, k, and the reflectance with at most 1, 2 and any number of bounces ("cap1", "cap2",
"scalar"), that of unpolarised light when its polarisation is followed ("polarized"), with the largest change under a
halved quadrature step as "error".

    python3 scripts/hemispherical_reference.py > tests/data/hemispherical_reference.json
"""
import cmath
import json
import math
import sys

MATERIALS = [(0.7, 0.0), (1.0003, 0.0), (30.0, 90.0), (1.5, 0.0), (0.1249, 3.3391)]
APERTURES_DEG = [45, 60, 90, 120, 150]


def trace(alpha, theta, y):
    """The bounces of a ray in the plane across the groove: first panel (1 or 2) and incidence cosines."""
    sh, ch = math.sin(alpha / 2), math.cos(alpha / 2)
    normals = {1: (ch, sh), 2: (-ch, sh)}
    rims = {1: (-sh, ch), 2: (sh, ch)}
    p = (y * sh, ch)
    d = (-math.sin(theta), -math.cos(theta))
    last, first, cosines = 0, 0, []
    for _ in range(10000):
        best = None
        for panel in (1, 2):
            if panel == last:
                continue
            n, r = normals[panel], rims[panel]
            facing = d[0] * n[0] + d[1] * n[1]
            if facing >= 0:
                continue
            t = -(p[0] * n[0] + p[1] * n[1]) / facing
            s = (p[0] + t * d[0]) * r[0] + (p[1] + t * d[1]) * r[1]
            if t > -1e-15 and -1e-15 <= s <= 1 and (best is None or t < best[0]):
                best = (t, panel, -facing)
        if best is None:
            return first, cosines
        t, last, cosine = best
        first = first or last
        cosines.append(cosine)
        n = normals[last]
        p = (p[0] + t * d[0], p[1] + t * d[1])
        d = (d[0] + 2 * cosine * n[0], d[1] + 2 * cosine * n[1])
    raise RuntimeError("a ray does not leave the groove")


def key(alpha, theta, y):
    first, cosines = trace(alpha, theta, y)
    return first, len(cosines)


def bisect(f, low, high):
    f_low = f(low)
    for _ in range(60):
        middle = (low + high) / 2
        if f(middle) == f_low:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def lobes(alpha, theta):
    """(weight, first panel, incidence cosines at psi = 0) of every lobe."""
    nudge = 1e-13  # stay off the rims and the apex

    def first(y):
        return trace(alpha, theta, y)[0]

    def count(y):
        return len(trace(alpha, theta, y)[1])

    ends = [-1.0, 1.0]
    if first(-1.0 + nudge) != first(1.0 - nudge):
        ends.insert(1, bisect(first, -1.0 + nudge, 1.0 - nudge))
    found = []
    for low, high in zip(ends, ends[1:]):
        inside = low + nudge, high - nudge
        if inside[0] >= inside[1]:
            continue
        a, b = count(inside[0]), count(inside[1])
        if abs(a - b) > 1:
            raise RuntimeError(f"bounce counts {a} and {b} on one side of the groove")
        cuts = [low, high] if a == b else [low, bisect(count, *inside), high]
        found += [((q - p) / 2, *trace(alpha, theta, (p + q) / 2)) for p, q in zip(cuts, cuts[1:]) if q - p > nudge]
    return found


def amplitudes(n, k, c):
    """r_s and r_p, the latter for the axis k x s before and after."""
    eta2 = complex(n, k) ** 2
    w = cmath.sqrt(eta2 - (1 - c * c))
    return (c - w) / (c + w), (eta2 * c - w) / (eta2 * c + w)


def fresnel(n, k, c):
    r_s, r_p = amplitudes(n, k, c)
    return (abs(r_s) ** 2 + abs(r_p) ** 2) / 2


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def polarized(n, k, alpha, theta, psi, first, bounces):
    """Reflectance of unpolarised light, half the sum for two orthogonal fields, followed in space."""
    sh, ch = math.sin(alpha / 2), math.cos(alpha / 2)
    sp, cp, st, ct = math.sin(psi), math.cos(psi), math.sin(theta), math.cos(theta)
    normals = {1: (0.0, ch, sh), 2: (0.0, -ch, sh)}
    travel = (-sp, -cp * st, -cp * ct)
    fields = [(cp, -sp * st, -sp * ct), (0.0, ct, -st)]
    panel = first
    for _ in range(bounces):
        normal = normals[panel]
        cosine = -dot(travel, normal)
        s = cross(travel, normal)
        length = math.sqrt(dot(s, s))
        # Along the normal every s will do.
        s = tuple(x / length for x in s) if length > 1e-12 else (1.0, 0.0, 0.0)
        p = cross(travel, s)
        travel = tuple(t + 2 * cosine * x for t, x in zip(travel, normal))
        q = cross(travel, s)
        r_s, r_p = amplitudes(n, k, cosine)
        split = [(r_s * dot(field, s), r_p * dot(field, p)) for field in fields]
        fields = [tuple(e_s * a + e_p * b for a, b in zip(s, q)) for e_s, e_p in split]
        panel = 3 - panel
    return sum(abs(x) ** 2 for field in fields for x in field) / 2


def tanh_sinh(level):
    """Nodes as distances from the nearer end of [0, 1], so that they keep their digits there: (from_low, distance, weight)."""
    h = 1.0 / level
    nodes = []
    for i in range(-int(3.4 / h), int(3.4 / h) + 1):
        t = i * h
        u = math.pi / 2 * math.sinh(t)
        distance = 1 / (1 + math.exp(2 * abs(u)))
        nodes.append((u <= 0, distance, h * math.pi / 4 * math.cosh(t) / math.cosh(u) ** 2))
    return nodes


def integrate(f, cuts, nodes):
    total = 0.0
    for a, b in zip(cuts, cuts[1:]):
        if b - a < 1e-13:
            continue
        for from_low, distance, weight in nodes:
            x = a + (b - a) * distance if from_low else b - (b - a) * distance
            total += (b - a) * weight * f(x)
    return total


def hemispherical(alpha, n, k, cuts_theta, level):
    nodes = tanh_sinh(level)
    critical = math.sqrt(1 - n * n) if k == 0 and n < 1 else 0.0
    # A pseudo-Brewster angle near grazing needs panels that shrink towards psi = pi/2.
    graded = [math.pi / 2 * (1 - 4.0**-i) for i in range(1, 5)]
    totals = [0.0, 0.0, 0.0, 0.0]
    for a, b in zip(cuts_theta, cuts_theta[1:]):
        for from_low, distance, weight in nodes:
            theta = a + (b - a) * distance if from_low else b - (b - a) * distance
            found = lobes(alpha, theta)
            cuts = {0.0, math.pi / 2, *graded}
            cuts |= {math.acos(critical / c) for _, _, cs in found for c in cs if critical and c > critical}
            psi_cuts = sorted(cuts)
            for lobe_weight, panel, cosines in found:

                def along(psi):
                    c = math.cos(psi)
                    return c * c * math.prod(fresnel(n, k, c * x) for x in cosines)

                def along_polarized(psi):
                    bounces = len(cosines)
                    return math.cos(psi) ** 2 * polarized(n, k, alpha, theta, psi, panel, bounces)

                factor = (b - a) * weight * math.cos(theta) * lobe_weight
                part = factor * integrate(along, psi_cuts, nodes)
                for i, most in enumerate((1, 2, 10**9)):
                    if len(cosines) <= most:
                        totals[i] += part
                totals[3] += factor * integrate(along_polarized, psi_cuts, nodes) if len(cosines) > 1 else part
    return [4 / math.pi * total for total in totals]


def theta_cuts(alpha, n, k):
    """Where the sequence of lobes changes, or a bounce passes the critical angle at psi = 0."""

    # All changes lie at multiples of alpha/4 from 0, pi/2 or pi; needless cuts do no harm.
    grid = {abs(base + i * alpha / 4) for base in (0, math.pi / 2, math.pi) for i in range(-40, 41)}
    cuts = {x for x in grid if 1e-9 < x < math.pi / 2 - 1e-9}
    if k == 0 and n < 1:
        turn = math.asin(math.sqrt(1 - n * n))
        for j in range(1, 40):
            image = (j - 0.5) * alpha
            for x in (turn - image, math.pi - turn - image, image - turn, image + turn - math.pi):
                if 1e-9 < x < math.pi / 2:
                    cuts.add(x)
    cuts = sorted(cuts)
    merged = [c for i, c in enumerate(cuts) if i == 0 or c - cuts[i - 1] > 1e-12]
    return [0.0] + merged + [math.pi / 2]


def main():
    rows = []
    for n, k in MATERIALS:
        for aperture_deg in APERTURES_DEG:
            alpha = math.radians(aperture_deg)
            cuts = theta_cuts(alpha, n, k)
            coarse = hemispherical(alpha, n, k, cuts, 8)
            fine = hemispherical(alpha, n, k, cuts, 16)
            error = max(abs(a - b) for a, b in zip(coarse, fine))
            rows.append({"aperture_deg": aperture_deg, "n": n, "k": k, "scalar": fine[2], "cap1": fine[0],
                         "cap2": fine[1], "polarized": fine[3], "error": error})
            print(rows[-1], file=sys.stderr)
    about = "Bi-hemispherical reflectance, printed by scripts/hemispherical_reference.py (see there for the method)."
    print(json.dumps({"about": about, "bihemispherical": rows}, indent=1))


if __name__ == "__main__":
    main()
