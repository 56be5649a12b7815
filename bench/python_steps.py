"""What does Python cost beside the C++ that it calls?

    PYTHONPATH=build/release/python python3 bench/python_steps.py build/release/program/cli/spoke

A step: the time of a call that does nothing but go through the same binding as `step()`, by median,
beside the time of a step. The target is 1 us at most.
A run: the time of `run(report=False)`, from call to return, by the time that `spoke run` says its
integration took, in turns; each as the best of the rounds. And that of `run()`, which records
what its page shows, as `spoke run` does beside that time.
Threads: what two simulations in two Python threads do, by what two processes `spoke run` do at
once, in turns, by median. The target is 0.9.
An array: the time to read one of a result, for 100 rows and for 100,000.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

import spoke

PROGRAM = sys.argv[1]
ROTOR = str(pathlib.Path(__file__).parents[1] / "models/wu_haug_rotor.toml")
ROUNDS = 9


def time_call(call, repeats):
    """Median over some batches [s]."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(repeats):
            call()
        times.append((time.perf_counter() - start) / repeats)
    return statistics.median(times)


def start_program(folder):
    return subprocess.Popen([PROGRAM, "run", ROTOR, "--executor", "serial", "--quiet", "--out",
                             folder])


def took(folder):
    """What the steps of a run took [s]."""
    return json.loads((pathlib.Path(folder) / "summary.json").read_text())["wall_time_s"]


def run(_=None):
    return spoke.Simulation(ROTOR, executor="serial").run().wall_time


def run_program():
    with tempfile.TemporaryDirectory() as folder:
        start_program(folder).wait()
        return took(folder)


def run_programs():
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
        for process in [start_program(one), start_program(other)]:
            process.wait()
        return max(took(one), took(other))


def run_threads():
    with ThreadPoolExecutor(2) as pool:
        return max(pool.map(run, range(2)))


def ask_steps():
    sim = spoke.Simulation(ROTOR, executor="serial")
    sim.run(until=5.0)
    call = time_call(lambda: sim.done, 20000) - time_call(lambda: None, 20000)
    step = time_call(sim.step, 200)
    print(f"a call through the binding {1e6 * call:.3f} us, beside a step of {1e6 * step:.2f} us")


def time_run(report):
    sim = spoke.Simulation(ROTOR, executor="serial")
    start = time.perf_counter()
    sim.run(report=report)
    return time.perf_counter() - start


def ask_runs():
    bare, reported, programs = [], [], []
    for _ in range(3 * ROUNDS):
        bare.append(time_run(report=False))
        reported.append(time_run(report=True))
        programs.append(run_program())
    print(f"a run of 20 s {1e3 * min(bare):.1f} ms, with report {1e3 * min(reported):.1f} ms, of "
          f"the program {1e3 * min(programs):.1f} ms: ratio {min(bare) / min(programs):.3f}")


def ask_threads():
    ratios = []
    for k in range(ROUNDS):
        pair = [run_threads, run_programs]
        times = {work: work() for work in (pair if k % 2 else pair[::-1])}
        ratios.append(times[run_programs] / times[run_threads])
    print(f"two threads do {statistics.median(ratios):.3f} of what two processes do "
          f"({min(ratios):.3f} to {max(ratios):.3f})")


def ask_arrays():
    sim = spoke.Simulation(ROTOR, executor="serial")
    few = sim.run(until=0.495, every=0)
    many = spoke.Simulation(ROTOR, set={"integration.step": 2e-4}, executor="serial").run(every=0)
    times = [time_call(lambda: result["hub.torque"], 20000) for result in (few, many)]
    print(f"an array of {len(few.t)} rows is read in {1e6 * times[0]:.2f} us, of {len(many.t)} "
          f"rows in {1e6 * times[1]:.2f} us")


ask_steps()
ask_runs()
ask_threads()
ask_arrays()
