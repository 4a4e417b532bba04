// The scene on the graphics card: WebGL2 with the engine's own shaders (the GLSL mirror of the lighting equation), to be laid beside the
// engine's picture.
import type { GpuGeometry, GpuScene } from "../engine/types";
import { Geometry } from "./geometry";
import { Program } from "./programs";
import { Target } from "./target";

/** The background as the target holds it: straight colours are encoded where the shaders encode. */
function clearColor(scene: GpuScene): [number, number, number, number] {
  const [r, g, b, a] = scene.background;
  if (scene.linearShaders || !scene.encoded || a === 0) {
    return [r, g, b, a];
  }
  const encoded = (x: number) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055) * a;
  return [encoded(r / a), encoded(g / a), encoded(b / a), a];
}

/** One canvas. Draws a GpuScene, whose meshes it asks for once. */
export class GpuView {
  private readonly programs = new Map<string, Program>();
  private readonly geometries = new Map<string, Geometry>();
  private target: Target | undefined;
  private size: [number, number] = [0, 0];

  private constructor(
    readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    private readonly gl: WebGL2RenderingContext,
  ) {
    this.canDrawLinear = gl.getExtension("EXT_color_buffer_half_float") !== null || gl.getExtension("EXT_color_buffer_float") !== null;
  }

  /** Whether there are targets of floats, in which samples are averaged as light. */
  readonly canDrawLinear: boolean;

  /** Undefined where the browser has no WebGL2. */
  static create(canvas: HTMLCanvasElement | OffscreenCanvas): GpuView | undefined {
    const gl = canvas.getContext("webgl2", {
      alpha: true,
      antialias: false,
      depth: true,
      premultipliedAlpha: true,
      preserveDrawingBuffer: true,
    });
    return gl ? new GpuView(canvas, gl as WebGL2RenderingContext) : undefined;
  }

  /** Fetches what the scene needs and is not there yet, and drops what it no longer needs. */
  async prepare(scene: GpuScene, geometryOf: (key: string) => Promise<GpuGeometry>): Promise<void> {
    const wanted = new Set(scene.instances.map((instance) => instance.geometry));
    for (const key of wanted) {
      if (!this.geometries.has(key)) {
        const data = await geometryOf(key);
        if (!this.geometries.has(key)) {
          this.geometries.set(key, new Geometry(this.gl, data));
        }
      }
    }
    for (const [key, geometry] of this.geometries) {
      if (!wanted.has(key)) {
        geometry.dispose();
        this.geometries.delete(key);
      }
    }
    for (const program of scene.programs) {
      const text = program.vertex + program.fragment;
      if (!this.programs.has(text)) {
        this.programs.set(text, new Program(this.gl, program.vertex, program.fragment));
      }
    }
  }

  /** Draws what prepare() has seen: of several samples a pixel, one picture a sample. */
  draw(scene: GpuScene): void {
    const gl = this.gl;
    if (this.size[0] !== scene.width || this.size[1] !== scene.height) {
      this.canvas.width = scene.width;
      this.canvas.height = scene.height;
      this.size = [scene.width, scene.height];
    }
    gl.viewport(0, 0, scene.width, scene.height);
    gl.depthFunc(gl.LESS);
    const programs = scene.programs.map((program) => this.programs.get(program.vertex + program.fragment)!);
    programs.forEach((program) => {
      gl.useProgram(program.handle);
      program.setScene(scene);
    });
    // Without targets of floats nothing can be summed.
    if (!scene.linearShaders) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      this.drawSample(scene, programs);
      return;
    }
    if (!this.target?.fits(scene.width, scene.height)) {
      this.target?.dispose();
      this.target = new Target(gl, scene.width, scene.height);
    }
    this.target.begin();
    for (const sample of scene.pattern) {
      this.target.add(1 / scene.pattern.length, () => {
        programs.forEach((program) => {
          gl.useProgram(program.handle);
          program.setSample(scene, sample);
        });
        this.drawSample(scene, programs);
      });
    }
    this.target.store(scene.encoded);
  }

  /** All instances, into what is bound. */
  private drawSample(scene: GpuScene, programs: readonly Program[]): void {
    const gl = this.gl;
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(...clearColor(scene));
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    let current: Program | undefined;
    for (const instance of scene.instances) {
      gl.bindVertexArray(this.geometries.get(instance.geometry)!.array);
      gl.frontFace(instance.mirrored ? gl.CW : gl.CCW);
      const turned = new Set<Program>();
      for (const part of instance.parts) {
        const program = programs[part.program]!;
        if (program !== current) {
          gl.useProgram(program.handle);
          current = program;
        }
        if (!turned.has(program)) {
          gl.uniformMatrix4fv(program.place("eye_from_object"), false, instance.eyeFromObject);
          gl.uniformMatrix3fv(program.place("normal_from_object"), false, instance.normalFromObject);
          turned.add(program);
        }
        program.setMaterial(part.material);
        if (part.cull === "none") {
          gl.disable(gl.CULL_FACE);
        } else {
          gl.enable(gl.CULL_FACE);
          gl.cullFace(part.cull === "back" ? gl.BACK : gl.FRONT);
        }
        gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, part.first * 4);
      }
    }
    gl.bindVertexArray(null);
  }

  /** The picture's bytes, the top row first. Waits for the card. */
  read(): Uint8ClampedArray<ArrayBuffer> {
    const [width, height] = this.size;
    const bytes = new Uint8Array(width * height * 4);
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
    this.gl.readPixels(0, 0, width, height, this.gl.RGBA, this.gl.UNSIGNED_BYTE, bytes);
    const result = new Uint8ClampedArray(bytes.length);
    for (let y = 0; y < height; ++y) {
      result.set(bytes.subarray((height - 1 - y) * width * 4, (height - y) * width * 4), y * width * 4);
    }
    return result;
  }

  /** Waits until the card has drawn. */
  finish(): void {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  dispose(): void {
    this.target?.dispose();
    this.programs.forEach((program) => program.dispose());
    this.geometries.forEach((geometry) => geometry.dispose());
    this.programs.clear();
    this.geometries.clear();
  }
}
