// Pictures for the engine's textures, by the libraries of the field: PNG by fast-png, JPEG and WebP by the decoders that the command uses too
// (libjpeg's in mozjpeg, libwebp), in WebAssembly. The engine asks while it loads, so nothing here may wait: what must be fetched is fetched by
// preparePictures() before.
import loadJpeg, { type MozJPEGModule } from "@jsquash/jpeg/codec/dec/mozjpeg_dec.js";
import jpegUrl from "@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm?url";
import loadWebp, { type WebPModule } from "@jsquash/webp/codec/dec/webp_dec.js";
import webpUrl from "@jsquash/webp/codec/dec/webp_dec.wasm?url";
import { convertIndexedToRgb, decode, type DecodedPng } from "fast-png";
import type { DecodedPicture } from "../../engine/built/lustro.js";
import type { EngineFile } from "./types";

let jpeg: MozJPEGModule | undefined;
let webp: WebPModule | undefined;

const isJpeg = (bytes: Uint8Array) => bytes[0] === 0xff && bytes[1] === 0xd8 && bytes[2] === 0xff;
const isWebp = (bytes: Uint8Array) => String.fromCharCode(...bytes.subarray(0, 4)) === "RIFF" && String.fromCharCode(...bytes.subarray(8, 12)) === "WEBP";

/** Whether pictures may stand inside the file. */
const isContainer = (file: EngineFile) => /\.(gltf|glb)$/i.test(file.path);

/** Fetches the decoders that these files may need. */
export async function preparePictures(files: EngineFile[]): Promise<void> {
  if (!jpeg && files.some((file) => isJpeg(file.bytes) || isContainer(file))) {
    jpeg = await loadJpeg({ locateFile: () => jpegUrl, noInitialRun: true });
  }
  if (!webp && files.some((file) => isWebp(file.bytes) || isContainer(file))) {
    webp = await loadWebp({ locateFile: () => webpUrl, noInitialRun: true });
  }
}

/** Components that a JPEG states in its frame header (ITU T.81, B.2.2), or 3. */
function jpegComponents(bytes: Uint8Array): number {
  for (let at = 2; at + 9 < bytes.length && bytes[at] === 0xff; ) {
    const marker = bytes[at + 1]!;
    if (marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc) {
      return bytes[at + 9]!;
    }
    at += 2 + ((bytes[at + 2]! << 8) | bytes[at + 3]!);
  }
  return 3;
}

/** RGBA with fewer channels: the first ones. */
function channelsOf(rgba: Uint8ClampedArray | Uint8Array, channels: number): Uint8Array {
  if (channels === 4) {
    return new Uint8Array(rgba.buffer, rgba.byteOffset, rgba.length);
  }
  const result = new Uint8Array((rgba.length / 4) * channels);
  for (let pixel = 0; pixel < rgba.length / 4; ++pixel) {
    for (let channel = 0; channel < channels; ++channel) {
      result[pixel * channels + channel] = rgba[pixel * 4 + channel]!;
    }
  }
  return result;
}

/** Gray of 1, 2 or 4 bits as bytes. */
function unpackGray(png: DecodedPng): Uint8Array {
  const result = new Uint8Array(png.width * png.height);
  const rowBytes = Math.ceil((png.width * png.depth) / 8);
  const largest = (1 << png.depth) - 1;
  for (let y = 0; y < png.height; ++y) {
    for (let x = 0; x < png.width; ++x) {
      const bit = x * png.depth;
      const value = (png.data[y * rowBytes + (bit >> 3)]! >> (8 - png.depth - (bit & 7))) & largest;
      result[y * png.width + x] = (value * 255) / largest;
    }
  }
  return result;
}

/** A colour that a tRNS chunk declares transparent becomes an alpha channel. */
function withKey(data: Uint8Array | Uint16Array, channels: number, key: Uint16Array, largest: number): Uint8Array | Uint16Array {
  const pixels = data.length / channels;
  const result = data instanceof Uint16Array ? new Uint16Array(pixels * 4) : new Uint8Array(pixels * 4);
  for (let pixel = 0; pixel < pixels; ++pixel) {
    let isKey = true;
    for (let channel = 0; channel < channels; ++channel) {
      isKey &&= data[pixel * channels + channel] === key[channel];
    }
    for (let channel = 0; channel < 3; ++channel) {
      result[pixel * 4 + channel] = data[pixel * channels + (channels === 1 ? 0 : channel)]!;
    }
    result[pixel * 4 + 3] = isKey ? 0 : largest;
  }
  return result;
}

function decodePng(bytes: Uint8Array): DecodedPicture {
  const png = decode(bytes, { checkCrc: true });
  const { width, height } = png;
  if (png.palette) {
    const data = convertIndexedToRgb(png) as Uint8Array;
    return { width, height, channels: png.palette[0]!.length, depth: 8, data };
  }
  const is16 = png.depth === 16;
  let data = png.depth < 8 ? unpackGray(png) : is16 ? (png.data as Uint16Array) : new Uint8Array(png.data.buffer, png.data.byteOffset, png.data.length);
  let channels = png.channels;
  if (png.transparency && (channels === 1 || channels === 3)) {
    const key = png.depth < 8 ? png.transparency.map((value) => (value * 255) / ((1 << png.depth) - 1)) : png.transparency;
    data = withKey(data, channels, key, is16 ? 65535 : 255);
    channels = 4;
  }
  return { width, height, channels, depth: is16 ? 16 : 8, data };
}

/** What the engine asks: the texels of a picture file, or why there are none. */
export function decodePicture(format: string, view: Uint8Array): DecodedPicture | { error: string } {
  try {
    const bytes = view.slice(); // the view is of the engine's memory, which may move
    if (format === "png") {
      return decodePng(bytes);
    }
    const decoder = format === "jpeg" ? jpeg : webp;
    const picture = format === "jpeg" ? jpeg?.decode(bytes, false) : webp?.decode(bytes);
    if (!decoder) {
      return { error: `the decoder of ${format} is not there` };
    }
    if (!picture) {
      return { error: `the ${format} data is broken` };
    }
    const channels = format === "jpeg" ? (jpegComponents(bytes) === 1 ? 1 : 3) : 4;
    return { width: picture.width, height: picture.height, channels, depth: 8, data: channelsOf(picture.data as Uint8ClampedArray, channels) };
  } catch (problem) {
    return { error: `the ${format} data is broken: ${problem instanceof Error ? problem.message : String(problem)}` };
  }
}
