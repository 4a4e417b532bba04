// Programs of the engine's own shaders, and where their uniforms are.
import type { GpuLight, GpuMaterial, GpuScene } from "../engine/types";

/** A linked pair of shaders. */
export class Program {
  readonly handle: WebGLProgram;
  private readonly gl: WebGL2RenderingContext;
  private readonly places = new Map<string, WebGLUniformLocation | null>();

  constructor(gl: WebGL2RenderingContext, vertex: string, fragment: string) {
    this.gl = gl;
    this.handle = gl.createProgram();
    const shaders = [compiled(gl, gl.VERTEX_SHADER, vertex), compiled(gl, gl.FRAGMENT_SHADER, fragment)];
    for (const shader of shaders) {
      gl.attachShader(this.handle, shader);
    }
    gl.linkProgram(this.handle);
    for (const shader of shaders) {
      gl.deleteShader(shader);
    }
    if (!gl.getProgramParameter(this.handle, gl.LINK_STATUS)) {
      throw new Error(`the shaders do not fit together: ${gl.getProgramInfoLog(this.handle)}`);
    }
  }

  /** Null where the program does not use it. */
  place(name: string): WebGLUniformLocation | null {
    let place = this.places.get(name);
    if (place === undefined) {
      place = this.gl.getUniformLocation(this.handle, name);
      this.places.set(name, place);
    }
    return place;
  }

  /** Has that place of each pixel, from its centre on, in pixels, y down, be drawn where the card looks: at the centre. In use. */
  setSample(scene: GpuScene, [x, y]: readonly [number, number]): void {
    const clipFromEye = scene.clipFromEye.slice();
    for (let column = 0; column < 16; column += 4) {
      clipFromEye[column]! -= ((2 * x) / scene.width) * clipFromEye[column + 3]!;
      clipFromEye[column + 1]! += ((2 * y) / scene.height) * clipFromEye[column + 3]!;
    }
    this.gl.uniformMatrix4fv(this.place("clip_from_eye"), false, clipFromEye);
  }

  /** What is the same for all that the scene shows. The program must be in use. */
  setScene(scene: GpuScene): void {
    const gl = this.gl;
    this.setSample(scene, [0, 0]);
    gl.uniform3fv(this.place("view_to_eye"), scene.viewToEye);
    gl.uniform3fv(this.place("ambient_light"), scene.ambientLight);
    gl.uniform1i(this.place("light_count"), scene.lights.length);
    scene.lights.forEach((light, index) => this.setLight(`lights[${index}]`, light));
    if (scene.fog) {
      gl.uniform1i(this.place("fog.mode"), scene.fog.mode);
      gl.uniform1f(this.place("fog.density"), scene.fog.density);
      gl.uniform1f(this.place("fog.end"), scene.fog.end);
      gl.uniform1f(this.place("fog.range_scale"), scene.fog.range_scale);
      gl.uniform3fv(this.place("fog.color"), scene.fog.color);
    }
  }

  setMaterial(material: GpuMaterial): void {
    const gl = this.gl;
    gl.uniform3fv(this.place("material.ambient"), material.ambient);
    gl.uniform3fv(this.place("material.diffuse"), material.diffuse);
    gl.uniform3fv(this.place("material.specular"), material.specular);
    gl.uniform3fv(this.place("material.emission"), material.emission);
    gl.uniform1f(this.place("material.shininess"), material.shininess);
  }

  dispose(): void {
    this.gl.deleteProgram(this.handle);
  }

  private setLight(name: string, light: GpuLight): void {
    const gl = this.gl;
    gl.uniform1i(this.place(`${name}.type`), light.type);
    gl.uniform1i(this.place(`${name}.fades_quadratically`), light.fades_quadratically ? 1 : 0);
    for (const key of ["position", "travel", "ambient", "diffuse", "specular", "attenuation"] as const) {
      gl.uniform3fv(this.place(`${name}.${key}`), light[key]);
    }
    for (const key of ["falloff", "attenuation_limit", "range_scale", "cos_cutoff", "cos_beam", "beam_scale", "exponent"] as const) {
      gl.uniform1f(this.place(`${name}.${key}`), light[key]);
    }
  }
}

function compiled(gl: WebGL2RenderingContext, kind: number, text: string): WebGLShader {
  const shader = gl.createShader(kind)!;
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
    throw new Error(`this graphics driver refuses a shader: ${gl.getShaderInfoLog(shader)}`);
  }
  return shader;
}
