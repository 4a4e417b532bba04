// A picture's own bytes as a PNG file: no canvas, which would multiply by alpha and back. Rows are encoded as the file's sRGB bytes stand.
import { encode } from "fast-png";
import type { Picture } from "../engine/types";

export function pngOf({ width, height, bytes }: Pick<Picture, "width" | "height" | "bytes">): Uint8Array<ArrayBuffer> {
  return encode({
    width,
    height,
    data: new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength),
    channels: 4,
    depth: 8,
  }) as Uint8Array<ArrayBuffer>;
}
