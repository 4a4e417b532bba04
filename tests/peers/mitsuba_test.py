#!/usr/bin/env python3
"""Lustro's path tracer beside Mitsuba 3, pixel by pixel: mitsuba_test.py LUSTRO ASSETS. Exit code 77 where Mitsuba or the assets are absent.

Both draw each scene several times with independent random numbers. What differs between those pictures is each renderer's own variance, so that
z = (ours - theirs) / sqrt(variance of ours + variance of theirs) has mean 0 and follows Student's t where both converge to the same picture. The test can
fail: with the albedo of one wall 5 % off it must, and does.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PIXELS, RUNS = 32, 16
CHANNELS = 3


def find_mitsuba():
    """Goes on in the environment of scripts/setup where this Python lacks Mitsuba."""
    try:
        import mitsuba
        mitsuba.set_variant("scalar_rgb")
        return True
    except ImportError:
        pass
    python = pathlib.Path(os.environ.get("LUSTRO_MITSUBA", ROOT / "build/mitsuba")) / "bin/python3"
    if python.exists() and pathlib.Path(sys.prefix) != python.parent.parent:
        os.execv(python, [str(python), *sys.argv])
    return False


def read_pfm(file):
    import numpy as np
    with open(file, "rb") as source:
        kind, size, scale = (source.readline().decode().strip() for _ in range(3))
        width, height = map(int, size.split())
        data = np.frombuffer(source.read(), dtype="<f4" if float(scale) < 0 else ">f4")
    return data.reshape(height, width, CHANNELS if kind == "PF" else 1)[::-1].astype(np.float64)


def ours(lustro, scene, samples, folder):
    """RUNS pictures, and the mean of the variances that we state ourselves."""
    import numpy as np
    pictures, stated = [], []
    for seed in range(RUNS):
        picture = folder / "ours.pfm"
        subprocess.run([lustro, "--quiet", "render", scene, "--engine", "path", "--bounces", "16", "--spp", str(samples), "--seed", str(seed), "--aov", "variance",
                        "-o", picture], check=True)
        pictures.append(read_pfm(picture))
        stated.append(read_pfm(folder / "ours.variance.pfm"))
    return np.array(pictures), np.mean(stated, axis=0)


def theirs(scene, samples):
    import mitsuba as mi
    import numpy as np
    loaded = scene.load()
    return np.array([np.array(mi.render(loaded, spp=samples, seed=seed)) for seed in range(RUNS)], dtype=np.float64)


def compare(a, b):
    """What the two stacks of pictures say: {"mean_z", "beyond", "of_means", "tiles"}."""
    import numpy as np
    variance = (a.var(axis=0, ddof=1) + b.var(axis=0, ddof=1)) / RUNS
    difference = a.mean(axis=0) - b.mean(axis=0)
    is_noisy = variance > 0
    z = difference[is_noisy] / np.sqrt(variance[is_noisy])
    # A pixel without noise (black, or the lamp itself) is the same to rounding.
    still = np.abs(difference[~is_noisy]) > 1e-5 * np.maximum(np.abs(a.mean(axis=0)[~is_noisy]), 1e-3)
    of_means = (a.mean(axis=(1, 2)).mean(axis=0) - b.mean(axis=(1, 2)).mean(axis=0)) / np.sqrt(
        (a.mean(axis=(1, 2)).var(axis=0, ddof=1) + b.mean(axis=(1, 2)).var(axis=0, ddof=1)) / RUNS)
    return {"mean_z": float(z.mean()), "spread": float(z.std()), "beyond": float((np.abs(z) > 3).mean()), "of_means": float(np.abs(of_means).max()),
            "still": int(still.sum()), "pixels": int(z.size), "difference": float(difference.mean() / b.mean())}


# P(|t| > 3) of Student's t with the 15 to 30 degrees of freedom of two times 16 runs is 0.5 to 0.9 %.
MOST_BEYOND, MOST_OF_MEANS = 0.012, 3.5
# Where a few bright paths carry much of the light, pixels that miss them look both too dark and too sure, and the mean of z strays with the share of them.
MOST_MEAN_Z, MOST_MEAN_Z_OF_GLASS = 0.1, 0.35


def agrees(found, most_mean_z=MOST_MEAN_Z):
    return abs(found["mean_z"]) < most_mean_z and found["beyond"] < MOST_BEYOND and found["of_means"] < MOST_OF_MEANS and found["still"] == 0


def say(name, found):
    print(f"{name:28} mean z {found['mean_z']:+.3f}, spread {found['spread']:.2f}, |z| > 3: {100 * found['beyond']:.2f} % of {found['pixels']}, "
          f"means {found['of_means']:.1f} standard errors apart ({100 * found['difference']:+.3f} %), {found['still']} without noise differ", flush=True)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    lustro, assets = sys.argv[1], pathlib.Path(sys.argv[2])
    if not find_mitsuba():
        print("skipped: Mitsuba 3 is not installed (scripts/setup mitsuba)")
        return SKIPPED
    if not assets.is_dir():
        print(f"skipped: no assets at {assets}")
        return SKIPPED
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
    import mitsuba_scenes as scenes
    failures = []
    with tempfile.TemporaryDirectory(prefix="lustro-mitsuba-") as scratch:
        folder = pathlib.Path(scratch)
        for scene, samples in ((scenes.cornell(assets, "lambert", PIXELS), 192), (scenes.cornell(assets, "mirror", PIXELS), 64),
                               (scenes.cornell(assets, "glass", PIXELS), 64), (scenes.bunny(assets, "lambert", PIXELS), 64),
                               (scenes.bunny(assets, "mirror", PIXELS), 64), (scenes.bunny(assets, "glass", PIXELS), 64)):
            reference = theirs(scene, samples)
            pictures, stated = ours(lustro, scene.write(folder), samples, folder)
            found = compare(pictures, reference)
            say(scene.name, found)
            if not agrees(found, MOST_MEAN_Z_OF_GLASS if scene.name.endswith("glass") else MOST_MEAN_Z):
                failures.append(f"{scene.name}: the pictures differ")
            # Our samples are stratified: what we state is at least the variance that there is.
            ratio = float(stated.mean() / pictures.var(axis=0, ddof=1).mean())
            print(f"{'':28} variance stated by ours: {ratio:.2f} x that of the runs", flush=True)
            if not 0.9 < ratio < 10:
                failures.append(f"{scene.name}: the stated variance is {ratio:.2f} x what it is")
            wall = "leftWall" if "leftWall" in scene.parts else "ground"
            if scene.name.endswith("lambert"):
                wrong = compare(ours(lustro, scene.write(folder, (wall, 1.05)), samples, folder)[0], reference)
                say(f"{scene.name}, {wall} 5 % off", wrong)
                if agrees(wrong):
                    failures.append(f"{scene.name}: the test does not see 5 % of one albedo")
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
