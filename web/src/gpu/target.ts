// What is drawn into before the canvas: samples become pixels here; of linear light they are averaged as light, and encoded after that, as the
// engine does it.
import { Program } from "./programs";

export interface TargetShape {
  width: number;
  height: number;
  /** samples a pixel that are wanted; the card may have fewer */
  samples: number;
  /** half floats of linear light, else bytes that the shaders have encoded */
  isLinear: boolean;
}

const kVertex = `#version 300 es
// One triangle over the whole picture.
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}`;

const kFragment = `#version 300 es
// A pixel of linear light, stored: sRGB (IEC 61966-2-1) of the colour, which alpha multiplies.
precision highp float;
uniform sampler2D light;
uniform bool encodes;
out vec4 stored;
float srgb(float x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}
void main() {
  vec4 value = texelFetch(light, ivec2(gl_FragCoord.xy), 0);
  vec3 color = clamp(value.a > 0.0 ? value.rgb / value.a : vec3(0.0), 0.0, 1.0);
  stored = vec4((encodes ? vec3(srgb(color.r), srgb(color.g), srgb(color.b)) : color) * value.a, value.a);
}`;

export class Target {
  readonly framebuffer: WebGLFramebuffer;
  private readonly color: WebGLRenderbuffer;
  private readonly depth: WebGLRenderbuffer;
  /** of linear light: the averaged samples, and what encodes them */
  private readonly light:
    { texture: WebGLTexture; framebuffer: WebGLFramebuffer; program: Program; nothing: WebGLVertexArrayObject } | undefined;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly shape: TargetShape,
  ) {
    const { width, height } = shape;
    const format = shape.isLinear ? gl.RGBA16F : gl.RGBA8;
    const most = (gl.getInternalformatParameter(gl.RENDERBUFFER, format, gl.SAMPLES) as Int32Array | null)?.[0] ?? 1;
    const samples = shape.samples > 1 ? Math.min(shape.samples, most) : 0;
    this.framebuffer = gl.createFramebuffer();
    this.color = gl.createRenderbuffer();
    this.depth = gl.createRenderbuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.color);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, this.color);
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, gl.DEPTH_COMPONENT24, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, this.depth);
    if (shape.isLinear) {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      this.light = { texture, framebuffer, program: new Program(gl, kVertex, kFragment), nothing: gl.createVertexArray() };
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  fits(shape: TargetShape): boolean {
    const own = this.shape;
    return shape.width === own.width && shape.height === own.height && shape.samples === own.samples && shape.isLinear === own.isLinear;
  }

  /** Averages the samples into the canvas. */
  resolve(encodes: boolean): void {
    const { gl, light } = this;
    const { width, height } = this.shape;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, light?.framebuffer ?? null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (light) {
      gl.disable(gl.DEPTH_TEST);
      gl.disable(gl.CULL_FACE);
      gl.useProgram(light.program.handle);
      gl.bindTexture(gl.TEXTURE_2D, light.texture);
      gl.uniform1i(light.program.place("light"), 0);
      gl.uniform1i(light.program.place("encodes"), encodes ? 1 : 0);
      gl.bindVertexArray(light.nothing);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.bindVertexArray(null);
    }
  }

  dispose(): void {
    const { gl, light } = this;
    gl.deleteFramebuffer(this.framebuffer);
    gl.deleteRenderbuffer(this.color);
    gl.deleteRenderbuffer(this.depth);
    if (light) {
      gl.deleteTexture(light.texture);
      gl.deleteFramebuffer(light.framebuffer);
      gl.deleteVertexArray(light.nothing);
      light.program.dispose();
    }
  }
}
