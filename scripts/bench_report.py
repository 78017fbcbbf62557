#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks and prints what they measured as Markdown; scripts/bench.sh builds them and calls this.

Times are medians of repetitions that are interleaved at random, so that a ratio is not one of quiet and busy minutes.
"""

import argparse
import csv
import importlib.util
import json
import math
import os
import pathlib
import re
import subprocess
import sys
from time import monotonic

BEGIN = "<!-- printed by scripts/bench.sh: begin -->\n"
END = "<!-- printed by scripts/bench.sh: end -->\n"
COMPUTATIONS = "^(fresnel|reflectance|profile|known_ways|new_groove|plain_loop|growth|bihemispherical|kernel|bare)"
COMMANDS = "^(map|paper)"
TOLERANCES = ("1e-3", "1e-5", "1e-7", "1e-10", "1e-13")


class Results:
    """Medians by the name of the benchmark."""

    def __init__(self, runs):
        self.rows = {}
        for cores, run in runs:
            for row in run["benchmarks"]:
                name = row["run_name"].removesuffix("/real_time")
                self.rows[f"{name}@{cores}"] = row

    def names(self, pattern):
        """The groups of `pattern` in every name that it matches, in the order of the benchmarks."""
        matches = (re.fullmatch(pattern + "@1", name) for name in self.rows)
        return [match.groups() for match in matches if match]

    def row(self, *words, cores=1):
        return self.rows["/".join(words) + f"@{cores}"]

    def has(self, *words):
        return "/".join(words) + "@1" in self.rows

    def nanoseconds(self, *words):
        """Time for one item; of computations processor time."""
        return 1e9 / self.row(*words)["items_per_second"]

    def milliseconds(self, *words, cores):
        """Wall-clock time of one run."""
        row = self.row(*words, cores=cores)
        return row["real_time"] * {"ns": 1e-6, "us": 1e-3, "ms": 1}[row["time_unit"]]


def table(heading, rows):
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def digits(value):
    """Two decimals, or at least three digits."""
    return f"{value:.2f}" if value < 10 else f"{value:.1f}" if value < 100 else f"{value:,.0f}"


def short_time(seconds):
    return f"{seconds * 1e3:.2g} ms" if seconds > 1e-3 else f"{seconds * 1e6:.3g} µs"


def times(factor):
    """A factor that is known roughly."""
    return f"{factor:.2g}" if factor < 100 else f"{factor:,.0f}" if factor < 1e5 else power_of_ten(factor)


def power_of_ten(value):
    """One digit and an exponent, such as 3e6."""
    return re.sub(r"e([-+])0?", lambda match: "e" + match.group(1).strip("+"), f"{value:.0e}")


def lanes_in_words(lanes):
    return "one by one" if lanes == "1" else f"packs of {lanes}"


def fresnel(results):
    rows = []
    for material, number, lanes in results.names(r"fresnel/(\w+)/(\w+)/(\d+)"):
        time = results.nanoseconds("fresnel", material, number, lanes)
        one = results.nanoseconds("fresnel", material, "double", "1")
        rows.append([material, number, lanes_in_words(lanes), digits(time), digits(one / time)])
    return ("## Fresnel's formula alone\n\nAt the cosines of a groove of 60°. Packs are in registers of 16 bytes, which every x86-64 processor has.\n\n" +
            table(["facet", "numbers", "computed", "ns per evaluation", "throughput against double, one by one"], rows))


def reflectance(results):
    rows = []
    for material, aperture, number, lanes in results.names(r"reflectance/(\w+)/(\d+)/(\w+)/(\d+)/none"):
        case = (material, aperture, number, lanes)

        def ratio(group, to):
            name = (group, *case, "none")
            return digits(results.nanoseconds(*name) / to) if results.has(*name) else ""

        facet = results.nanoseconds("fresnel_of_reflectance", *case, "none")
        evaluations = results.row("reflectance", *case, "none")["evaluations"]
        none, separate, full = (results.nanoseconds("reflectance", *case, model)
                                for model in ("none", "separate", "full"))
        rows.append([material, f"{aperture}°", number, lanes_in_words(lanes), f"{evaluations:.2f}", digits(none),
                     digits(none / facet), ratio("plain_loop", facet), ratio("known_ways", facet),
                     digits(separate / none), digits(full / none)])
    return ("## Directional reflectance\n\nTime per direction, over the directions of a map. *Evaluations*: of the facet, "
            "for one direction. *Overhead*: the time against that of nothing but these evaluations, at the same "
            "cosines; *of a plain loop*: of the same written by hand for numbers, with no thought of polarisation, "
            "colour, packs or narrow grooves; *of known ways*: if number and cosines of the bounces and the weights of "
            "the lobes are known beforehand. *separate* and *full*: the models of polarisation against none.\n\n" +
            table(["facet", "aperture", "numbers", "computed", "evaluations", "ns", "overhead", "of a plain loop",
                   "of known ways", "separate", "full"], rows))


def new_grooves(results):
    models = ("shared", "from_aperture", "by_addition", "from_normal")
    rows = [[material, f"{aperture}°", number,
             *(digits(results.nanoseconds("new_groove", material, aperture, number, model)) for model in models)]
            for material, aperture, number in results.names(r"new_groove/(\w+)/(\d+)/(\w+)/shared")]
    return ("## A new groove per direction\n\nTime per direction in nanoseconds, with one groove for all directions, with "
            "a new one for each from its aperture, from the same by addition, and from the normal of its facets without "
            "trigonometric functions.\n\n" +
            table(["facet", "aperture", "numbers", "one groove", "from the aperture", "by addition", "from the normal"],
                  rows))


def profiles(results):
    rows = []
    symmetric = results.nanoseconds("profile", "symmetric")
    for shape, in results.names(r"profile/(.+)"):
        time = results.nanoseconds("profile", shape)
        rows.append([shape, digits(time), digits(time / symmetric)])
    return ("## Other shapes and films\n\nDirectional reflectance of silver, 60° where nothing else is said, in double, one by "
            "one but for packs: time per direction in nanoseconds, and against the symmetric groove of `Cavity`.\n\n" +
            table(["surface", "ns", "against symmetric"], rows))


def growth(results):
    rows = []
    for aperture, in results.names(r"growth/silver/([\d.]+)"):
        row = results.row("growth/silver", aperture)
        time = results.nanoseconds("growth/silver", aperture)
        rows.append([f"{aperture}°", f"{row['bounces']:.0f}", f"{row['evaluations']:.1f}", digits(time / 1e3),
                     digits(time / 1e3 * float(aperture))])
    return ("## Narrow grooves\n\nDirectional reflectance of silver in double, one by one. *Bounces*: at most. "
            "*Evaluations*: of the facet for one direction, fewer than the bounces where many are done at once. The last "
            "column would be constant if time grew like 1/α.\n\n" +
            table(["aperture α", "bounces", "evaluations", "µs", "µs × α/1°"], rows))


def evaluations_of_apertures(rows):
    """How many apertures need how many evaluations."""
    counts = [row["fresnel_evaluations"] for row in rows]
    few = sum(count < 3000 for count in counts)
    worst = rows[counts.index(max(counts))]
    return (f"{few} of {len(rows)} need fewer than 3,000, half of them at most {sorted(counts)[len(counts) // 2]:,}, "
            f"{worst['aperture_deg']:g}° as many as {max(counts):,}")


def bihemispherical(results, sweeps):
    def cell(material, aperture, tolerance):
        row = results.row("bihemispherical", material, aperture, tolerance)
        return f"{row['cpu_time'] / 1e3:.1f} µs, {row['evaluations']:.0f}"

    rows = [[material, f"{aperture}°", *(cell(material, aperture, tolerance) for tolerance in TOLERANCES)]
            for material, aperture in results.names(r"bihemispherical/(\w+)/(\d+)/1e-10")]
    return ("## Bi-hemispherical reflectance\n\nTime and number of Fresnel evaluations for a tolerance.\n\n" +
            table(["facet", "aperture", *TOLERANCES], rows) +
            "\nEvaluations for 1e-10 at all apertures from 45° to 180° in steps of half a degree (`vcavity_maps table "
            "--tolerance 1e-10 --aperture 45:180:0.5`): " +
            "; ".join(f"{material}: {evaluations_of_apertures(rows)}" for material, rows in sweeps.items()) + ".\n")


def maps(results, core_counts):
    rows = []
    for count in ("1", "31"):
        for cores in core_counts:
            def time(part):
                return results.milliseconds("map", count, part, cores=cores)

            computing, command = time("values_and_colour"), time("command")
            colour = time("colour") if count != "1" else 0
            storing, writing = time("writing_uncompressed"), time("writing")
            rows.append([count, cores, digits(computing - colour), digits(colour) if colour else "",
                         *map(digits, (writing - storing, storing, command, command / writing))])
    papers = [[cores, digits(results.milliseconds("paper", "command", cores=cores) / 1e3)] for cores in core_counts]
    return ("## Maps\n\n`vcavity_maps map` of copper, 60°, 1024 × 1024, to OpenEXR (PIZ), and its parts run alone, in "
            "milliseconds. *Compression*: the file with it less the file without. *Ratio*: the command against writing "
            "the same file alone, compression included.\n\n" +
            table(["wavelengths", "cores", "values", "colour", "compression", "writing", "command", "ratio"], rows) +
            "\n`vcavity_maps paper --size 256`: all figures, tables and the report.\n\n" + table(["cores", "seconds"], papers))


def map_growth(results):
    def rows(kind):
        return [[f"{int(number):,}", digits(results.milliseconds("map_growth", kind, number, cores=1)),
                 digits(results.nanoseconds("map_growth", kind, number))]
                for number, in results.names(rf"map_growth/{kind}/(\d+)")]

    return ("## Growth of maps\n\nValues of a map of copper, 60°, on one core, with their colour: one wavelength at any size, "
            "and 512 × 512 at any number of wavelengths. The last column, the time for a pixel and wavelength, would be "
            "constant if time grew in proportion.\n\n" +
            table(["pixels along one side", "ms", "ns"], rows("pixels")) + "\n" +
            table(["wavelengths", "ms", "ns"], rows("wavelengths")))


def power_law(rows, exponent=None):
    """The straight line through the logarithms: seconds as a function of the error."""
    points = [(math.log(row["error"]), math.log(row["seconds"])) for row in rows]
    x, y = (sum(values) / len(points) for values in zip(*points))
    slope = exponent or (sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points))
    return lambda error: math.exp(y + slope * (math.log(error) - x))


def other_ways(cost):
    methods = {}
    for row in cost["sections"][0]["rows"]:
        methods.setdefault(row["method"], []).append(row)
    # Random methods: the error falls like the square root of the number of rays, known better than two points say.
    others = {name: power_law(methods[name], None if name == "the paper's midpoint rule" else -2)
              for name in ("the paper's midpoint rule", "Monte Carlo", "Embree ray tracer") if name in methods}
    rows = []
    for error in (1e-3, 1e-4, 1e-6, 1e-10):
        adaptive = min(row["seconds"] for row in methods["adaptive"] if row["error"] <= error)
        rows.append([power_of_ten(error), short_time(adaptive),
                     *(times(time(error) / adaptive) for time in others.values())])
    return ("## Against other ways to the same number\n\nBi-hemispherical reflectance of silver, 60°: time for an error, "
            "and how many times as long the others take, extrapolated along the slope of what was measured "
            "(`vcavity_maps cost --material Ag --aperture 60`). The Embree tracer follows rays through a mesh.\n\n" +
            table(["error", "vcavity", *others], rows))


def kernels(results):
    rows = []
    for instructions, number, wavelengths in results.names(r"kernel/([^/]+)/(\w+)/(\d+)"):
        case = (instructions, number, wavelengths)
        bare, kernel = results.nanoseconds("bare", *case), results.nanoseconds("kernel", *case)
        rows.append([instructions, number, wavelengths, digits(bare), digits(kernel), digits(bare / kernel)])
    return ("## The kernel of maps\n\nTime per Fresnel evaluation: a bare loop over evaluations, compiled for the same "
            "instructions, and the kernel with all that it does besides. Silver, 60°.\n\n" +
            table(["instructions", "numbers", "wavelengths", "bare loop, ns", "kernel, ns", "throughput against it"],
                  rows))


def targets(results, core_counts):
    def worst(cases, value):
        return max(value(*case) for case in cases)

    def best_kernel(wavelengths):
        instructions = results.names(r"kernel/([^/]+)/double/31")[-1][0]
        return [(number, results.nanoseconds("bare", instructions, number, wavelengths) /
                 results.nanoseconds("kernel", instructions, number, wavelengths)) for number in ("double", "float")]

    def overhead(*case):
        return results.nanoseconds("reflectance", *case) / results.nanoseconds("fresnel_of_reflectance", *case)

    def in_words(pairs):
        return ", ".join(f"{name}: {digits(value)}" for name, value in pairs)

    apertures = [aperture for aperture, in results.names(r"reflectance/silver/(\d+)/double/1/none")]
    scalar = [("silver", aperture, "double", "1") for aperture in apertures]
    tight = [("bihemispherical", *case, "1e-10") for case in results.names(r"bihemispherical/(\w+)/(\d+)/1e-10")]
    rows = [
        ["spectral map, throughput against a bare Fresnel loop", "≥ 0.8", in_words(best_kernel("31"))],
        ["map of one wavelength, the same", "≥ 0.6", in_words(best_kernel("1"))],
        ["directional reflectance, double, against its Fresnel evaluations", "≤ 1.3",
         in_words((f"{case[1]}°", overhead(*case, "none")) for case in scalar)],
        ["polarisation `full` against `none`", "≤ 3",
         in_words((f"{case[1]}°", results.nanoseconds("reflectance", *case, "full") /
                   results.nanoseconds("reflectance", *case, "none")) for case in scalar)],
        ["bi-hemispherical, 1e-10, α in the table below: evaluations", "< 3,000",
         f"{worst(tight, lambda *case: results.row(*case)['evaluations']):,.0f} at most"],
        ["the same: time", "< 50 µs",
         f"{worst(tight, lambda *case: results.row(*case)['cpu_time']) / 1e3:.1f} µs at most"],
        ["map command against writing its file", "≤ 1.3",
         in_words((f"{label} on {cores} {'core' if cores == 1 else 'cores'}",
                   results.milliseconds("map", count, "command", cores=cores) /
                   results.milliseconds("map", count, "writing", cores=cores))
                  for count, label in (("1", "one wavelength"), ("31", "31 wavelengths")) for cores in core_counts)],
        ["time from 1° to 0.1°, against 10 for 1/α", "sub-linear",
         digits(results.nanoseconds("growth/silver/0.1") / results.nanoseconds("growth/silver/1"))],
    ]
    if len(core_counts) > 1:
        rows.insert(7, ["values of a map of 31 wavelengths, speed-up on 2 cores", "near 2", digits(
            results.milliseconds("map", "31", "values_and_colour", cores=1) /
            results.milliseconds("map", "31", "values_and_colour", cores=2))])
    return "## Targets\n\n" + table(["", "target", "reached"], rows)


def plot(results, path):
    """The limits and what is reached, in one picture."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams.update({"font.size": 8, "svg.hashsalt": "vcavity", "axes.spines.top": False,
                                "axes.spines.right": False})
    from matplotlib import pyplot

    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(10, 3.2))

    cases = results.names(r"kernel/([^/]+)/(double)/(\d+)")
    for shift, wavelengths, colour, target in ((-0.2, "31", "#4477aa", 0.8), (0.2, "1", "#ee6677", 0.6)):
        shown = [case for case in cases if case[2] == wavelengths]
        ratios = [results.nanoseconds("bare", *case) / results.nanoseconds("kernel", *case) for case in shown]
        left.bar([i + shift for i in range(len(shown))], ratios, 0.36, color=colour,
                 label="one wavelength" if wavelengths == "1" else f"{wavelengths} wavelengths")
        left.axhline(target, color=colour, linewidth=0.8, linestyle="--")
        left.set_xticks(range(len(shown)), [case[0] for case in shown])
    left.set(ylim=(0, 1.18), ylabel="throughput against a bare Fresnel loop", title="Map kernel, double (dashed: target)")
    left.legend(frameon=False, loc="upper center", ncols=2)

    for aperture, colour in (("45", "#4477aa"), ("90", "#228833"), ("150", "#ccbb44")):
        for material, style in (("silver", "-"), ("glass", "--")):
            time = [results.row("bihemispherical", material, aperture, tolerance)["cpu_time"] / 1e3
                    for tolerance in TOLERANCES]
            middle.plot([float(tolerance) for tolerance in TOLERANCES], time, style, color=colour, marker=".",
                        label=f"{material}, {aperture}°")
    middle.set(xscale="log", ylim=(0, None), xlabel="tolerance", ylabel="µs", title="Bi-hemispherical value, one core")
    middle.invert_xaxis()
    middle.legend(frameon=False)

    apertures = [float(aperture) for aperture, in results.names(r"growth/silver/([\d.]+)")]
    time = [results.nanoseconds("growth/silver", f"{aperture:g}") / 1e3 for aperture in apertures]
    right.loglog(apertures, time, marker=".", color="#4477aa", label="silver, double")
    one = apertures.index(1)
    right.loglog(apertures, [time[one] / aperture for aperture in apertures], ":", color="gray", label="like 1/α")
    right.set(xlabel="aperture α in degrees", ylabel="µs per direction", title="Narrow grooves")
    right.invert_xaxis()
    right.legend(frameon=False)

    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def other_work():
    """A function that returns how many cores other programs have kept busy since this call."""
    def seconds():
        with open("/proc/stat", encoding="utf-8") as file:
            ticks = [int(word) for word in file.readline().split()[1:9]]
        idle = ticks[3] + ticks[4]
        return (sum(ticks) - idle) / os.sysconf("SC_CLK_TCK") - sum(os.times()[:4]), monotonic()

    busy_before, before = seconds()

    def cores():
        busy, now = seconds()
        return max(busy - busy_before, 0) / (now - before)

    return cores


def machine(context, others):
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        model = re.search(r"model name\s*:\s*(.*)", file.read())
    return (f"vcavity {context['vcavity']}, {context['compiler']}, -O3, {os.uname().sysname}, "
            f"{model.group(1) if model else os.uname().machine}, {len(os.sched_getaffinity(0))} cores, of which other "
            f"programs kept {others:.1f} busy.\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="the build folder of bench.sh")
    parser.add_argument("--csv", type=pathlib.Path, help="also write every median to this file")
    parser.add_argument("--plot", type=pathlib.Path, help="also draw a picture of them, an SVG")
    parser.add_argument("--into", type=pathlib.Path, help="replace the tables of this page instead of printing them")
    options = parser.parse_args()
    if options.plot and not importlib.util.find_spec("matplotlib"):
        parser.error(f"--plot draws with matplotlib, which {sys.executable} does not have")

    def output(cores, *command):
        """What a command prints if it may use the first so many cores."""
        some = sorted(os.sched_getaffinity(0))[:cores]
        return subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True,
                              preexec_fn=lambda: os.sched_setaffinity(0, some)).stdout

    def benchmark(cores, names, min_time):
        print(f"running {names} on {cores}", file=sys.stderr)
        return cores, json.loads(output(
            cores, options.build / "bench/vcavity_bench", f"--benchmark_filter={names}", "--benchmark_repetitions=9",
            f"--benchmark_min_time={min_time}", "--benchmark_enable_random_interleaving=true",
            "--benchmark_report_aggregates_only=true", "--benchmark_format=json"))

    busy_with_others = other_work()
    core_counts = [1, 2] if len(os.sched_getaffinity(0)) > 1 else [1]
    runs = [benchmark(1, COMPUTATIONS, 0.02)] + [benchmark(cores, COMMANDS, 0.01) for cores in core_counts]
    for _, run in runs:
        medians = (row for row in run["benchmarks"] if row["aggregate_name"] == "median")
        run["benchmarks"] = sorted(medians, key=lambda row: row["family_index"])
    results = Results(runs)
    cost = json.loads(output(1, options.build / "bin/vcavity_maps", "cost", "--material", "Ag", "--aperture", "60",
                             "--format", "json"))
    sweeps = {label: json.loads(output(1, options.build / "bin/vcavity_maps", "table", "--material", material,
                                       "--aperture", "45:180:0.5", "--tolerance", "1e-10", "--format", "json"))["rows"]
              for label, material in (("silver", "Ag"), ("glass", "1.5"))}
    bsdf = ("## BSDF\n\nNanoseconds per call in float (`bsdf_cost`).\n\n" + output(1, options.build / "bench/bsdf_cost"))

    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["benchmark", "cores", "real_time", "cpu_time", "unit", "items_per_second", "evaluations"])
            for name, row in results.rows.items():
                writer.writerow([*name.rsplit("@", 1), row["real_time"], row["cpu_time"], row["time_unit"],
                                 row.get("items_per_second", ""), row.get("evaluations", "")])
    if options.plot:
        plot(results, options.plot)
    text = "\n".join([machine(runs[0][1]["context"], busy_with_others()), targets(results, core_counts),
                      kernels(results), maps(results, core_counts), map_growth(results), reflectance(results),
                      profiles(results), new_grooves(results), bihemispherical(results, sweeps), growth(results),
                      other_ways(cost), fresnel(results), bsdf])
    if not options.into:
        print(text)
        return
    page = options.into.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    options.into.write_text(before + BEGIN + "\n" + text + "\n" + END + after, encoding="utf-8")


if __name__ == "__main__":
    main()
