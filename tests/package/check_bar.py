"""Compares what examples/bar.cc prints with the law of its material, stable neo-Hookean under
uniaxial tension: P = mu (a - b^2 / a) along the bar, whose sides are free if
(lambda + mu) (a b^2 - 1) = mu (1 - 1 / a), with stretches a along it and b across.

    check_bar.py OUTPUT
"""

import re
import sys

E, NU, TRACTION = 1e4, 0.45, 2e3  # Pa
MU = E / (2 * (1 + NU))
LAMBDA = E * NU / ((1 + NU) * (1 - 2 * NU))


def across(a):
    return ((1 + MU / (LAMBDA + MU) * (1 - 1 / a)) / a) ** 0.5


def stretch(traction):
    low, high = 1., 2.
    for _ in range(60):
        a = (low + high) / 2
        if MU * (a - across(a) ** 2 / a) < traction:
            low = a
        else:
            high = a
    return a


number = r"([-+.\de]+)"
text = open(sys.argv[1]).read()
a, b, least, most = (float(word) for word in re.fullmatch(
    rf"stretch {number}\nacross {number}\nenergy from {number} to {number} of .*\n", text).groups())
expected = stretch(TRACTION)
print(f"expected: stretch {expected:.6g}, across {across(expected):.6g}")
assert abs(a - expected) < 1e-5
assert abs(b - across(expected)) < 1e-5
assert 1.1 < a < 1.5  # it is a large deformation
assert 0.98 < least <= 1 <= most < 1.02  # forces are the slope of the energy
