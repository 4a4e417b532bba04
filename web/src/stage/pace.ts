// How large a picture may be while something is dragged, learned from the pictures before: one takes about a + b pixels, a for the triangles and
// b for what is seen of them. Full pictures (more samples, larger maps of shadows) are learned apart.

/** More than 30 frames a second, with what the page itself needs taken off. */
export const kFrameMilliseconds = 24;
const kSmallestScale = 0.2;
const kRemembered = 24;
/** Where the triangles alone take longer than a frame, pixels may take this share of that on top: smaller pictures would gain nothing. */
const kShareOfFixed = 0.5;
/** So many pictures that took less than this share of a frame: the next one may be larger. */
const kTries = 4;
const kIdleShare = 0.8;

interface Taken {
  pixels: number;
  milliseconds: number;
}

/** a and b of the straight line nearest to the times, neither below 0; through the origin where all sizes are alike. */
function line(taken: readonly Taken[]): { fixed: number; perPixel: number } {
  const mean = (of: (t: Taken) => number) => taken.reduce((sum, t) => sum + of(t), 0) / taken.length;
  const pixels = mean((t) => t.pixels);
  const milliseconds = mean((t) => t.milliseconds);
  const spread = mean((t) => (t.pixels - pixels) ** 2);
  const through = { fixed: 0, perPixel: milliseconds / pixels };
  if (spread < (0.1 * pixels) ** 2) {
    return through;
  }
  const slope = mean((t) => (t.pixels - pixels) * (t.milliseconds - milliseconds)) / spread;
  const fixed = milliseconds - slope * pixels;
  if (slope <= 0) {
    return { fixed: milliseconds, perPixel: 0 };
  }
  return fixed < 0 ? through : { fixed, perPixel: slope };
}

export class Pace {
  private quick: Taken[] = [];
  private fullPerSample = 0;
  private scale = 0.5;

  /** A picture of a gesture was drawn. */
  learnQuick(pixels: number, milliseconds: number): void {
    this.quick = [...this.quick, { pixels, milliseconds }].slice(-kRemembered);
  }

  /** A full picture was drawn. */
  learnFull(pixels: number, samples: number, milliseconds: number): void {
    this.fullPerSample = milliseconds / (pixels * weight(samples));
  }

  /** What a full picture will take, if it is like the one before. */
  expectedFull(pixels: number, samples: number): number {
    return this.fullPerSample * pixels * weight(samples);
  }

  /** The scale, 0..1 of the full width and height, at which a picture of a gesture fits into the time of a frame. */
  scaleFor(pixels: number): number {
    if (this.quick.length === 0) {
      return this.scale;
    }
    const { fixed, perPixel } = line(this.quick);
    const affordable = perPixel === 0 ? pixels : Math.max(kFrameMilliseconds - fixed, kShareOfFixed * fixed) / perPixel;
    // Steps, so that the picture does not tremble between two sizes; and no step up for a little.
    const next = Math.min(1, Math.max(kSmallestScale, Math.floor(Math.sqrt(affordable / pixels) * 10) / 10));
    const isSmallStepUp = next > this.scale && next - this.scale < 0.11 && next < 1;
    const latest = this.quick.slice(-kTries);
    const isIdle = latest.length === kTries && latest.every(({ milliseconds }) => milliseconds < kIdleShare * kFrameMilliseconds);
    if (isIdle && next <= this.scale) {
      // Time is left though the line says no: a larger picture tells more.
      this.scale = Math.min(1, Math.round(this.scale * 10 + 1) / 10);
    } else if (!isSmallStepUp) {
      this.scale = next;
    }
    return this.scale;
  }
}

/** Samples share most of the work: eight take about three and a half times one. */
const weight = (samples: number): number => 1 + 0.35 * (samples - 1);
