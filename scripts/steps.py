"""The price of implicit steps, beside Bullet's, as tables: of build/step_benchmark and
build/bullet_step, which take turns. scripts/benchmark says how to run it."""

import statistics
import subprocess
import sys

# Steps by the number of cells along the cube's edge: to the peak of the traction where Bullet's
# time allows it.
STEPS = {8: 25, 16: 25, 32: 13}
TURNS = {8: 5, 16: 3, 32: 1}
ALIKE = 0.1


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          check=True).stdout


def peer(program, *arguments):
    """Milliseconds per step and the displacement of the loaded face, m."""
    words = run(program, *arguments).split()
    return float(words[3]), float(words[4])


def comparison(build):
    print("| n | steps | Bullet, ms per step | springfit, ms per step | ratio | "
          "displacement, mm: Bullet | springfit |")
    print("|---|---|---|---|---|---|---|")
    for n, n_steps in STEPS.items():
        theirs, ours = [], []
        for _ in range(TURNS[n]):
            theirs.append(peer(f"{build}/bullet_step", n, n_steps))
            ours.append(peer(f"{build}/step_benchmark", "peer", n, n_steps))
        (_, their_end), (_, our_end) = theirs[0], ours[0]
        if abs(our_end - their_end) > ALIKE * abs(their_end):
            sys.exit(f"n = {n}: the displacements {their_end} m and {our_end} m differ: "
                     "times of different motions are not compared.")
        their_time = statistics.median(time for time, _ in theirs)
        our_time = statistics.median(time for time, _ in ours)
        print(f"| {n} | {n_steps} | {their_time:.1f} | {our_time:.2f} | "
              f"{their_time / our_time:.1f} | {1e3 * their_end:.4f} | {1e3 * our_end:.4f} |",
              flush=True)


def main(build):
    print("A cube pulled by implicit Euler's method, one linearisation per step, relative "
          "residual 1e-6, CPU time on one core.\n\nAll springs alike, beside Bullet 3.24 in "
          "double precision, from rest on:\n")
    comparison(build)
    print("\nBy model, a period of 50 steps:\n")
    print(run(f"{build}/step_benchmark", "times"))
    print(run(f"{build}/step_benchmark", "forces", 32))


if __name__ == "__main__":
    main(*sys.argv[1:])
