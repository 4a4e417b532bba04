// How two pictures differ: bytes against bytes, as one would see them.

export interface Difference {
  /** width x height x 4: |a - b| times the gain, opaque */
  bytes: Uint8ClampedArray<ArrayBuffer>;
  /** share of the pixels in which a channel differs by more than 2/255 */
  shareOver: number;
  /** the largest difference of a channel, 0..255 */
  most: number;
}

/** Both RGBA, straight alpha; colours count by their alpha, and so does alpha itself. */
export function differenceOf(a: Uint8ClampedArray, b: Uint8ClampedArray, gain: number): Difference {
  const bytes = new Uint8ClampedArray(a.length);
  let over = 0;
  let most = 0;
  for (let at = 0; at < a.length; at += 4) {
    const weightA = a[at + 3]! / 255;
    const weightB = b[at + 3]! / 255;
    let largest = Math.abs(a[at + 3]! - b[at + 3]!);
    for (let channel = 0; channel < 3; ++channel) {
      const difference = Math.abs(a[at + channel]! * weightA - b[at + channel]! * weightB);
      bytes[at + channel] = difference * gain;
      largest = Math.max(largest, difference);
    }
    bytes[at + 3] = 255;
    most = Math.max(most, largest);
    over += largest > 2 ? 1 : 0;
  }
  return { bytes, shareOver: a.length > 0 ? over / (a.length / 4) : 0, most };
}

/** The bytes of a premultiplied picture, straight. */
export function straight(bytes: Uint8ClampedArray<ArrayBuffer>): Uint8ClampedArray<ArrayBuffer> {
  for (let at = 0; at < bytes.length; at += 4) {
    const alpha = bytes[at + 3]!;
    if (alpha > 0 && alpha < 255) {
      for (let channel = 0; channel < 3; ++channel) {
        bytes[at + channel] = (bytes[at + channel]! * 255) / alpha;
      }
    }
  }
  return bytes;
}
