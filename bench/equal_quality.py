#!/usr/bin/env python3
"""equal_quality.py BENCH_PATH ASSETS [SECONDS [REFERENCE_SAMPLES [FOLDER]]]: how long Lustro's path tracer and Mitsuba 3 take to the same error on the Cornell box. One line of JSON for
each of Mitsuba's variants, as the programs of bench/ print it; the scene file stays in FOLDER. Runs in the environment of scripts/setup mitsuba.

The error is the root mean square over pixels and channels against a reference of 16384 samples a pixel, drawn by Mitsuba where its LLVM variant runs, else by
ours; those of several seeds are averaged. Mitsuba draws a fixed number of samples; ours the least number that is no worse. Both use all cores, and draw the
scene once before they are timed: loaded, compiled. The two draw in turns.
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/peers"))
PIXELS, SAMPLES, SEEDS = 128, {"scalar_rgb": 128, "llvm_ad_rgb": 256}, 4


def libllvm():
    """Debian's newest libLLVM, where nobody names one: Mitsuba's code needs 17 or later."""
    found = sorted(pathlib.Path("/usr/lib/x86_64-linux-gnu").glob("libLLVM-*.so"), key=lambda f: f.name.split("-")[1].split(".")[0].zfill(4))
    if found and "DRJIT_LIBLLVM_PATH" not in os.environ and int(found[-1].name.split("-")[1].split(".")[0]) >= 17:
        os.environ["DRJIT_LIBLLVM_PATH"] = str(found[-1])
    return "DRJIT_LIBLLVM_PATH" in os.environ


class Ours:
    def __init__(self, program, scene, folder):
        self.process = subprocess.Popen([program, "draw", scene], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.file = folder / "ours.raw"

    def draw(self, samples, seed, has_picture=False):
        import numpy as np
        self.process.stdin.write(f"{samples} {seed} {self.file if has_picture else '-'}\n")
        self.process.stdin.flush()
        told = json.loads(self.process.stdout.readline())
        if has_picture:
            told["picture"] = np.fromfile(self.file, dtype=np.float32).reshape(PIXELS, PIXELS, 4)[..., :3].astype(np.float64)
        return told


class Mitsuba:
    """One variant; each keeps its scene."""

    def __init__(self, variant, scene):
        import mitsuba as mi
        self.variant = variant
        mi.set_variant(variant)
        self.scene = scene.load()

    def draw(self, samples, seed, has_picture=False):
        import drjit as dr
        import mitsuba as mi
        import numpy as np
        mi.set_variant(self.variant)
        processor, begin = time.process_time(), time.perf_counter()
        picture = mi.render(self.scene, spp=samples, seed=seed)
        if "llvm" in self.variant:
            dr.eval(picture)
            dr.sync_thread()
        told = {"ms": (time.perf_counter() - begin) * 1e3, "processor_ms": (time.process_time() - processor) * 1e3}
        if has_picture:
            told["picture"] = np.array(picture, dtype=np.float64)
        return told


def error_of(renderer, samples, reference):
    """Root mean square over pixels, channels and seeds."""
    import numpy as np
    return float(np.sqrt(np.mean([(renderer.draw(samples, 100 + seed, True)["picture"] - reference) ** 2 for seed in range(SEEDS)])))


def mean_of(renderer, samples, seed):
    """The picture of many samples, in parts that memory holds."""
    part = 256
    total = 0
    for i in range(samples // part):
        total = total + renderer.draw(part, seed + i, True)["picture"]
    return total / (samples // part)


def least_samples(ours, wanted, reference):
    """The least number of samples whose error is no larger than what is wanted: doubled until it is, then halved between."""
    errors = {}

    def error(n):
        if n not in errors:
            errors[n] = error_of(ours, n, reference)
        return errors[n]
    high = 4
    while error(high) > wanted and high < 4096:
        high *= 2
    low = high // 2
    while high - low > max(1, high // 16):
        middle = (low + high) // 2
        low, high = (low, middle) if error(middle) <= wanted else (middle, high)
    return high, error(high)


def times_of(draws):
    ms = [d["ms"] for d in draws]
    return {"min_ms": min(ms), "median_ms": statistics.median(ms), "processor_ms": min(d["processor_ms"] for d in draws), "runs": len(draws)}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, assets = sys.argv[1], pathlib.Path(sys.argv[2])
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 30
    reference_samples = int(sys.argv[4]) if len(sys.argv) > 4 else 16384
    has_llvm = libllvm()
    import mitsuba as mi
    mi.set_variant("scalar_rgb")
    import mitsuba_scenes
    scene = mitsuba_scenes.cornell(assets, "lambert", PIXELS)
    with tempfile.TemporaryDirectory(prefix="lustro-bench-") as scratch:
        ours = Ours(program, scene.write(sys.argv[5] if len(sys.argv) > 5 else scratch), pathlib.Path(scratch))
        peers = {"scalar_rgb": Mitsuba("scalar_rgb", scene)}
        if has_llvm:
            peers["llvm_ad_rgb"] = Mitsuba("llvm_ad_rgb", scene)
        else:
            print(json.dumps({"key": "path/llvm_ad_rgb", "failed": "libLLVM 17 or later is missing (Debian: libllvm19)"}), flush=True)
        judge = peers.get("llvm_ad_rgb", ours)
        reference = mean_of(judge, reference_samples, 1000)
        other = mean_of(ours if judge is not ours else peers["scalar_rgb"], 1024, 5000)
        apart = abs(float(other.mean() / reference.mean()) - 1)
        for variant, peer in peers.items():
            key = f"path/{variant}"
            if apart > 0.005:
                print(json.dumps({"key": key, "failed": f"the pictures' means are {100 * apart:.2f} % apart"}), flush=True)
                continue
            wanted = error_of(peer, SAMPLES[variant], reference)
            samples, reached = least_samples(ours, wanted, reference)
            draws = {"ours": [], "peer": []}
            begin = time.monotonic()
            while len(draws["ours"]) < 3 or time.monotonic() - begin < seconds and len(draws["ours"]) < 15:
                draws["ours"].append(ours.draw(samples, len(draws["ours"])))
                draws["peer"].append(peer.draw(SAMPLES[variant], len(draws["peer"])))
            check = f"error {reached:.4f} with {samples} samples, Mitsuba's {wanted:.4f} with {SAMPLES[variant]}; means of the pictures {100 * apart:.2f} % apart"
            print(json.dumps({"key": key, "check": check, "sides": {name: times_of(d) for name, d in draws.items()}}), flush=True)
        ours.process.stdin.close()
        ours.process.wait()


if __name__ == "__main__":
    main()
