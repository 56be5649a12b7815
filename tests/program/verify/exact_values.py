"""Computes the exact values of cases of `spoke verify` anew, by closed forms, roots of equations and
integrations with SciPy, and compares them with those of the case files.

    exact_values.py FOLDER_OF_CASES

Values that were published and cannot be computed here are left out; the others may differ by a part
in a million, or by what the case allows, whichever is less.
"""

import sys
import tomllib
from math import acos, cos, cosh, pi, sin, sinh, sqrt, tan
from pathlib import Path

import numpy as np
from scipy.integrate import solve_bvp, solve_ivp
from scipy.linalg import eig, expm
from scipy.optimize import brentq, fsolve
from scipy.special import ellipk, jv

TOLERANCE = 1e-6
EXACT = {}  # "case / figure": value
ORDINALS = ("first", "second", "third")


def roots(function, count, start=0.5, step=0.01):
    """Returns the first roots beyond `start`."""
    found, x = [], start
    while len(found) < count:
        if function(x) * function(x + step) < 0:
            found.append(brentq(function, x, x + step, xtol=1e-14))
        x += step
    return found


def differentiation(count):
    """Returns Chebyshev's points on [0, 1], descending, and the matrix of differentiation on them."""
    k = np.arange(count + 1)
    x = np.cos(pi * k / count)
    c = np.where((k == 0) | (k == count), 2.0, 1.0) * (-1.0) ** k
    gap = x[:, None] - x[None, :] + np.eye(count + 1)
    D = np.outer(c, 1.0 / c) / gap
    D -= np.diag(D.sum(axis=1))
    return (x + 1) / 2, 2.0 * D


def collocate(along, slope, count=22, length=1.0, hinged=False):
    """Returns the squares of the frequencies of a beam of unit mass and stiffness with the fourth
    derivative + along(x) the second + slope(x) the first of its deflection, ascending. Its root is
    clamped or hinged."""
    x, D = differentiation(count)
    x, D = length * x, D / length
    D2 = D @ D
    A = D2 @ D2 + np.diag(along(x)) @ D2 + np.diag(slope(x)) @ D
    B = np.eye(count + 1)
    for row, condition in {-1: np.eye(count + 1)[-1], -2: (D2 if hinged else D)[-1], 0: D2[0], 1: (D2 @ D)[0]}.items():
        A[row], B[row] = condition, 0.0
    values = eig(A, B, right=False)
    values = values[np.isfinite(values) & (np.abs(values) < 1e6)]
    return np.sort_complex(values)


def set_beams():
    bending = [k * k for k in roots(lambda k: cos(k) * cosh(k) + 1, 3)]
    for n, (name, value) in enumerate(zip(ORDINALS, bending), 1):
        EXACT[f"cantilever_modes / {name} bending"] = value
        EXACT[f"hinged_hinged_modes / {name} bending"] = (n * pi) ** 2
    EXACT["cantilever_modes / first bending, four times as stiff"] = 2 * bending[0]
    EXACT["cantilever_torsion / first torsion"] = pi / 2 * sqrt(1e-6 / 2e-8)
    EXACT["cantilever_torsion / second torsion"] = 3 * pi / 2 * sqrt(1e-6 / 2e-8)
    EXACT["cantilever_axial / first axial"] = pi / 2 * 10
    clamped = roots(lambda k: sin(k) * cosh(k) - cos(k) * sinh(k), 2, start=1.0)
    free = roots(lambda k: cos(k) * cosh(k) - 1, 2, start=2.0)
    tip = roots(lambda k: 1 + cos(k) * cosh(k) + k * (cos(k) * sinh(k) - sin(k) * cosh(k)), 2)
    for case, ks in {"clamped_hinged": clamped, "clamped_clamped": free, "free_free": free,
                     "tip_mass": tip}.items():
        for name, k in zip(ORDINALS, ks):
            EXACT[f"{case}_modes / {name} bending"] = k * k
    hanging = np.sqrt(collocate(lambda x: -20 * (1 - x), lambda x: 20 + 0 * x).real)
    for name, value in zip(ORDINALS[:2], hanging):
        EXACT[f"hanging_beam_modes / {name} bending"] = value


def set_timoshenko(shear=100.0, inertia=0.004):
    def determinant(w):
        A = np.zeros((4, 4))  # of deflection, rotation, shear force, moment
        A[0, 1], A[0, 2], A[1, 3] = 1.0, 1.0 / shear, 1.0
        A[2, 0], A[3, 1], A[3, 2] = -w * w, -inertia * w * w, -1.0
        return np.linalg.det(expm(A)[2:, 2:])

    for name, w in zip(ORDINALS, roots(determinant, 2, step=0.5)):
        EXACT[f"timoshenko_modes / {name} bending"] = w


def set_stability():
    EXACT["euler_cantilever / critical load"] = pi**2 / 4
    EXACT["euler_hinged / critical load"] = pi**2
    EXACT["euler_clamped_hinged / critical load"] = brentq(lambda k: sin(k) - k * cos(k), 4.2, 4.7) ** 2
    EXACT["euler_clamped / critical load"] = 4 * pi**2
    EXACT["quasitangential_moment / critical moment"] = pi / 2
    EXACT["semitangential_moment / critical moment"] = pi
    # Greenhill: J(-1/3, 2/3 sqrt q) = 0; Prandtl: J(-1/4, p/2) = 0 with p = P L^2/sqrt(EI GJ).
    EXACT["greenhill_column / critical weight"] = (1.5 * roots(lambda z: jv(-1 / 3, z), 1)[0]) ** 2
    EXACT["lateral_buckling / critical force"] = 2 * roots(lambda z: jv(-0.25, z), 1)[0] * sqrt(100 * 80)
    for case, low, high, along in (("beck_column", 18.0, 22.0, lambda x: 1 + 0 * x),
                                   ("leipholz_column", 38.0, 42.0, lambda x: 1 - x)):
        for _ in range(40):  # beyond, the two lowest squares are conjugate
            middle = 0.5 * (low + high)
            pair = collocate(lambda x: middle * along(x), lambda x: 0 * x)[:2]
            low, high = (low, middle) if abs(pair[0].imag) > 1e-3 else (middle, high)
        EXACT[f"{case} / critical load"] = low
        if case == "beck_column":
            EXACT[f"{case} / frequency of flutter"] = sqrt(pair.real.mean())


def set_rotating():
    for speed in (2, 6, 12):
        squares = collocate(lambda x: -0.5 * speed**2 * (1 - x * x), lambda x: speed**2 * x).real
        for name, square in zip(ORDINALS, squares):
            EXACT[f"wright_beam_{speed} / {name} across the plane"] = sqrt(square)
            EXACT[f"wright_beam_{speed} / {name} in the plane"] = sqrt(square - speed**2)
    for e in (0.05, 0.3):
        squares = collocate(lambda x: -50 * (1 - (e + x) ** 2), lambda x: 100 * (e + x), length=1 - e, hinged=True).real
        case = f"hinged_elastic_blade_{e}".replace(".", "_")
        EXACT[f"{case} / first flap"], EXACT[f"{case} / second flap"] = np.sqrt(squares[:2])
        EXACT[f"{case} / first lag"] = sqrt(squares[0] - 100)
    EXACT["hinged_blade / lag"] = 10 * sqrt(1.5 * 0.05)
    EXACT["hinged_blade / flap"] = 10 * sqrt(1 + 1.5 * 0.05)
    w0 = pi / 2 * sqrt(0.004 / 2.2e-4)
    for speed in (5, 10):
        EXACT[f"propeller_moment_{speed} / torsion"] = sqrt(w0**2 + speed**2 * 1.8 / 2.2)
    k = 6 * sqrt(1.2 / 2.8e7)
    EXACT["simo_vu_quoc_extension / steady extension"] = 1e3 * (tan(10 * k) / k - 10)


def set_elastica():
    for force in (1, 2, 5, 10):
        found = solve_bvp(lambda s, y: [y[1], -force * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])],
                          lambda a, b: [a[0], b[1], a[2], a[3]],
                          np.linspace(0, 1, 41), np.zeros((4, 41)), tol=1e-10, max_nodes=100000)
        EXACT[f"elastica_{force} / deflection"] = found.y[3, -1]
        EXACT[f"elastica_{force} / shortening"] = found.y[2, -1] - 1
        EXACT[f"elastica_{force} / slope"] = found.y[0, -1]
    EXACT["roll_up / deflection"] = 2 / pi
    EXACT["roll_up / shortening"] = 2 / pi - 1
    # In rotation, in the plane of flap: angle, moment, forces along x and z, x, z.
    speed, load = 6.0, 20.0

    def slope(s, y):
        return [y[1], y[2] * np.sin(y[0]) - y[3] * np.cos(y[0]), -speed**2 * y[4], -load + 0 * s,
                np.cos(y[0]), np.sin(y[0])]

    s = np.linspace(0, 1, 41)
    guess = np.array([0.5 * s, 0 * s, 18 * (1 - s), 20 * (1 - s), s, 0.5 * s])
    found = solve_bvp(slope, lambda a, b: [a[0], a[4], a[5], b[1], b[2], b[3]], s, guess, tol=1e-9,
                      max_nodes=100000)
    EXACT["flapped_in_rotation / across the plane"] = found.y[5, -1]
    EXACT["flapped_in_rotation / inward"] = found.y[4, -1] - 1


def solve_rod(axial, stiffness, force, length, curvature=(0.0, 0.0, 0.0)):
    """Returns the place of the tip of a rod along x that is clamped at its root, under a dead force at
    its tip, by shooting for the moment at the root."""

    def slope(_, y, n):
        Q, m = y[3:12].reshape(3, 3), y[12:]
        stretch = 1 + (Q.T @ n)[0] / axial
        k = (Q.T @ m) / stiffness + curvature
        spin = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
        tangent = Q[:, 0] * stretch
        return np.concatenate([tangent, (Q @ spin).ravel(), -np.cross(tangent, n)])

    def end(m, n):
        y = np.concatenate([np.zeros(3), np.eye(3).ravel(), m])
        return solve_ivp(slope, (0, length), y, args=(n,), rtol=1e-10, atol=1e-11, method="DOP853").y[:, -1]

    moment = np.zeros(3)
    for share in np.linspace(0.1, 1.0, 10):
        n = share * np.array(force)
        moment = fsolve(lambda m: end(m, n)[12:], moment * share / max(share - 0.1, 0.1), xtol=1e-12)
    return end(moment, np.array(force))[:3]


def set_rods():
    tip = solve_rod(1e7, np.array([7.02885e5, 1e7 / 12, 1e7 / 12]), [0, 0, 600], 25 * pi, [0, 0, 0.01])
    tip -= [100 * sin(pi / 4), 100 - 100 * cos(pi / 4), 0]
    for name, value in zip(("along the root", "to the centre", "across the plane"), tip):
        EXACT[f"bathe_bend / {name}"] = value

    # Half of a beam held at both ends: angle, curvature, place; H the tension, V the force across.
    def slope(s, y, p):
        shear = 20 * (0.5 - s)
        along = p[0] * np.cos(y[0]) + shear * np.sin(y[0])
        stretch = 1 + along / 1e4
        return [y[1], stretch * (p[0] * np.sin(y[0]) - shear * np.cos(y[0])), stretch * np.cos(y[0]),
                stretch * np.sin(y[0])]

    s = np.linspace(0, 0.5, 41)
    guess = np.array([0.1 * np.sin(2 * pi * s), 0 * s, s, 0.03 * np.sin(pi * s)])
    found = solve_bvp(slope, lambda a, b, p: [a[0], a[2], a[3], b[0], b[2] - 0.5], s, guess, p=[20.0],
                      tol=1e-9, max_nodes=100000)
    EXACT["held_beam / deflection of the middle"] = found.y[3, -1]
    EXACT["held_beam / tension at the end"] = found.p[0]
    tip = solve_rod(2.8910334e6, np.array([3.102, 2.4286, 38.858]), [0, -9.4363, -9.4363], 0.508)
    for name, value in zip(("along the beam", "along the broad side", "across it"), tip - [0.508, 0, 0]):
        EXACT[f"princeton_beam / {name}"] = value


def set_motions():
    for name, start in (("30", pi / 6), ("90", pi / 2), ("170", 170 * pi / 180)):
        EXACT[f"pendulum_{name} / period"] = 4 * sqrt(2 / (3 * 9.81)) * ellipk(sin(start / 2) ** 2)


def set_top():
    # Euler's equations about the tip in the body's axes, and its rotation matrix.
    inertia = np.array([15.234375, 0.46875, 15.234375])

    def slope(_, y):
        Q, w = y[:9].reshape(3, 3), y[9:]
        spin = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        weight = Q.T @ [0, 0, -15 * 9.81]
        moment = np.cross([0, 1, 0], weight) - np.cross(w, inertia * w)
        return np.concatenate([(Q @ spin).ravel(), moment / inertia])

    start = np.concatenate([np.eye(3).ravel(), [0, 150, -4.61538]])
    end = solve_ivp(slope, (0, 0.2), start, rtol=1e-12, atol=1e-13, method="DOP853").y[:, -1]
    Q = end[:9].reshape(3, 3)
    angle = np.arccos((np.trace(Q) - 1) / 2)
    vector = angle / (2 * sin(angle)) * np.array([Q[2, 1] - Q[1, 2], Q[0, 2] - Q[2, 0], Q[1, 0] - Q[0, 1]])
    for axis, value in zip("xyz", vector):
        EXACT[f"heavy_top / rotation vector at 0.2 s, {axis}"] = value


def set_linkages():
    # Two linkages: ((N + 1)/3 + N) angle'' = -g ((N + 1)/2 + N) cos(angle).
    def slope(_, y):
        return [y[1], -9.81 * 3.5 / 3 * cos(y[0])]

    angle = solve_ivp(slope, (0, 10), [pi / 2, -1.0], rtol=1e-12, atol=1e-13, method="DOP853").y[0, -1]
    EXACT["four_bars / first corner, along"] = cos(angle)
    EXACT["four_bars / first corner, down"] = sin(angle) - 1
    carrier, planet = 24 / 108, 24 / 108 - 28 / 45
    inertia = 0.02 + carrier**2 * (0.1 + 3 * 0.8 * 0.135**2) + 3 * 0.003 * planet**2
    EXACT["epicyclic_gear / speed of the carrier"] = 10 / inertia * carrier


def set_rotors():
    # Disc on a massless shaft: place and slope in the complex plane.
    length, bending, mass, polar, across, speed = 0.6, 1600.0, 10.0, 0.20001, 0.1 + 5e-6, 200.0
    K = bending / length**3 * np.array([[12, -6 * length], [-6 * length, 4 * length**2]])
    M, G = np.diag([mass, across]), np.diag([0.0, polar * speed])
    Z, one = np.zeros((2, 2)), np.eye(2)
    whirls = np.sort(eig(np.block([[Z, one], [K, G]]), np.block([[one, Z], [Z, M]]), right=False).real)
    for name, value in zip(("second backward", "first backward", "first forward", "second forward"), whirls):
        EXACT[f"overhung_disc / {name} whirl"] = abs(value)
    for name, speed in (("below", 90.0), ("above", 250.0)):
        EXACT[f"jeffcott_{name} / deflection"] = speed**2 / (1e4 - speed**2)
    set_ground_resonance()
    flat = sqrt((1 + 0.25) ** (1 / 3) - 1)
    EXACT["mises_truss / force of the limit point"] = 100 * flat * (sqrt(1.25 / (1 + flat**2)) - 1)
    M, C, K = (np.array(m) for m in ([[3.0, 2.0], [2.0, 2.0]], [[0.5, 0.0], [0.0, 0.2]], [[100.0, 0.0], [0.0, 50.0]]))
    for w in (3, 5, 13):  # both coordinates are moved by a force on the second mass
        answer = np.linalg.solve(K + 1j * w * C - w * w * M, [1.0, 1.0])
        EXACT[f"two_masses / at {w} rad/s"] = abs(answer[0])


def set_ground_resonance():
    # Place x, y of the bearing, and the sums of lag times cosine and sine of the azimuth, as
    # e = sum lag exp(i azimuth): I (e'' - 2 i W e' - W^2 e) + (k + W^2 r S) e - i N S/2 (x + i y)'' = 0.
    speed, mass, S, spring, offset = 25.0, 660.0, 50.0, 400.0, 0.3
    inertia = 41.6667 + 20 * 2.5**2
    stay = spring + speed**2 * offset * S - inertia * speed**2
    M = np.array([[mass, 0, 0, -S], [0, mass, S, 0], [0, 1.5 * S, inertia, 0], [-1.5 * S, 0, 0, inertia]])
    C = np.array([[2000, 0, 0, 0], [0, 1500, 0, 0], [0, 0, 0, 2 * inertia * speed], [0, 0, -2 * inertia * speed, 0]])
    K = np.diag([2e5, 1.4e5, stay, stay])
    A = np.block([[np.zeros((4, 4)), np.eye(4)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    root = max(np.linalg.eigvals(A), key=lambda s: s.real)
    EXACT["ground_resonance / growth"] = root.real
    EXACT["ground_resonance / frequency"] = abs(root.imag)


def set_air():
    density, slope, chord, radius, mass, speed = 1.2, 5.7, 0.2, 5.0, 3.0, 20.0
    lock = density * slope * chord * radius**4 / (mass * radius**3 / 3)
    turning = density * slope * chord**2 / (4 * mass)
    EXACT["lock_coning / coning angle"] = lock / 8 * 0.02 / (1 - turning)
    EXACT["lock_damping / growth"] = -lock / 16 * speed
    EXACT["lock_damping / magnitude"] = speed * sqrt(1 - turning)
    EXACT["thrust_without_induction / thrust"] = 3 * density * chord * slope * 0.05 * speed**2 * radius**3 / 6


def set_points():
    EXACT["double_pendulum / first"] = sqrt(9.81 * (2 - sqrt(2)))
    EXACT["double_pendulum / second"] = sqrt(9.81 * (2 + sqrt(2)))
    angle = acos(9.81 / 25)
    EXACT["governor_angle / angle"] = angle
    EXACT["governor_frequency / frequency"] = 5 * sin(angle)
    place, rate = 0.1 * cosh(3.0), 0.2 * sinh(3.0)
    EXACT["mass_in_tube / place"] = place
    EXACT["mass_in_tube / torque"] = 2 * place * rate * 2.0
    zeros = roots(lambda z: jv(0, z), 2)
    EXACT["hanging_chain / first"], EXACT["hanging_chain / second"] = (0.5 * z * sqrt(9.81) for z in zeros)
    EXACT["turning_chain / first"], EXACT["turning_chain / second"] = 10.0, 10 * sqrt(6)
    springs = np.array([[1e4, -1e4, 0], [-1e4, 3e4, -2e4], [0, -2e4, 2e4]])
    squares = np.sort(eig(springs, np.diag([2.0, 3.0, 5.0]), right=False).real)
    EXACT["three_discs / first torsion"], EXACT["three_discs / second torsion"] = np.sqrt(squares[1:])


def set_critical_speeds():
    length = 0.5
    K = 700 / length**3 * np.array([[12, -6 * length], [-6 * length, 4 * length**2]])
    squares = eig(K, np.diag([2.0, 0.03 - 0.05]), right=False).real
    EXACT["shaft_disc_critical / critical speed"] = sqrt(max(squares))
    EXACT["coleman_whirl / critical speed"] = sqrt(0.35 / 0.85)

    def grows(speed):  # of (7 s^2 + 7) ((s^2 - 2 i W s - W^2)/3 + 0.05 W^2) - s^4/2
        quadratic = np.array([1 / 3, -2j * speed / 3, (0.05 - 1 / 3) * speed**2])
        quartic = np.polymul([7, 0, 7], quadratic) - np.array([0.5, 0, 0, 0, 0])
        return max(np.roots(quartic).real) > 1e-5

    low, high = 0.7, 1.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if grows(middle) else (middle, high)
    EXACT["coleman_onset / speed of onset"] = low


def set_slider_crank(r=0.2, rod=0.5, speed=10.0, mass=2.0):
    angle = speed * 1.0
    root = sqrt(rod**2 - (r * sin(angle)) ** 2)
    EXACT["slider_crank / slider"] = r * cos(angle) + root - r - rod
    # By the angle: first and second derivative of the place.
    first = -r * sin(angle) - r**2 * sin(angle) * cos(angle) / root
    second = (-r * cos(angle) - r**2 * cos(2 * angle) / root
              - (r**2 * sin(angle) * cos(angle)) ** 2 / root**3)
    EXACT["slider_crank / torque"] = mass * speed**2 * first * second


def set_hover(radius=6.0, root=0.6, speed=80.0, chords=1.2, pitch=0.02, density=1.2):
    part = chords / (pi * radius) * 2 * pi  # solidity times lift slope
    inflow = part / 16 * (sqrt(1 + 32 * pitch / part) - 1)
    area, share = pi * radius**2, 1 - (root / radius) ** 2
    thrust = part / 4 * (pitch - inflow) * share * density * area * (speed * radius) ** 2
    EXACT["ideal_hover / thrust"] = 1e-3 * thrust


def set_all():
    for function in (set_beams, set_timoshenko, set_stability, set_rotating, set_elastica, set_rods,
                     set_motions, set_top, set_linkages, set_rotors, set_air, set_points,
                     set_critical_speeds, set_slider_crank, set_hover):
        function()


def main(folder):
    set_all()
    wrong = compared = 0
    for file in sorted(Path(folder).glob("*.toml")):
        for case in tomllib.loads(file.read_text())["case"]:
            for figure in case["figure"]:
                key = f"{case['name']} / {figure['name']}"
                if key not in EXACT:
                    continue
                compared += 1
                exact, scale = EXACT.pop(key), figure.get("scale", abs(figure["exact"]))
                if not abs(figure["exact"] - exact) <= min(TOLERANCE, figure["error"]) * scale:
                    print(f"{file.name}: {key}: is {figure['exact']}, expected {exact:.10g}")
                    wrong += 1
    for key, value in EXACT.items():
        print(f"there is no case {key}: {value:.10g}")
    print(f"{compared} values compared, {wrong} differ")
    return 1 if wrong or EXACT or not compared else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
