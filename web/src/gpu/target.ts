// Where samples become pixels: one picture a sample is drawn, and their average kept as linear light, which is encoded after that, as the engine
// does it. A card's own samples lie elsewhere, are fewer than sixteen, and are told apart on a coarser grid.
import { Program } from "./programs";

const kVertex = `#version 300 es
// One triangle over the whole picture.
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}`;

const kAdd = `#version 300 es
precision highp float;
uniform sampler2D light;
uniform float weight;
out vec4 part;
void main() {
  part = texelFetch(light, ivec2(gl_FragCoord.xy), 0) * weight;
}`;

const kStore = `#version 300 es
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

interface Layer {
  texture: WebGLTexture;
  framebuffer: WebGLFramebuffer;
}

export class Target {
  /** the sample that is being drawn */
  private readonly sample: Layer;
  private readonly sum: Layer;
  private readonly depth: WebGLRenderbuffer;
  private readonly adding: Program;
  private readonly storing: Program;
  private readonly nothing: WebGLVertexArrayObject;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly width: number,
    private readonly height: number,
  ) {
    const layer = (): Layer => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, width, height);
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      return { texture, framebuffer };
    };
    this.sum = layer();
    this.sample = layer();
    this.depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, this.depth);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.adding = new Program(gl, kVertex, kAdd);
    this.storing = new Program(gl, kVertex, kStore);
    this.nothing = gl.createVertexArray();
  }

  fits(width: number, height: number): boolean {
    return width === this.width && height === this.height;
  }

  /** Nothing is summed yet. */
  begin(): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.sum.framebuffer);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  /** What draw() draws counts with that weight. */
  add(weight: number, draw: () => void): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.sample.framebuffer);
    draw();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.sum.framebuffer);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    this.cover(this.adding, this.sample.texture, () => gl.uniform1f(this.adding.place("weight"), weight));
    gl.disable(gl.BLEND);
  }

  /** The sum into the canvas. */
  store(encodes: boolean): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.cover(this.storing, this.sum.texture, () => gl.uniform1i(this.storing.place("encodes"), encodes ? 1 : 0));
  }

  private cover(program: Program, texture: WebGLTexture, set: () => void): void {
    const { gl } = this;
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.useProgram(program.handle);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(program.place("light"), 0);
    set();
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.bindVertexArray(null);
  }

  dispose(): void {
    const { gl } = this;
    gl.deleteRenderbuffer(this.depth);
    for (const { texture, framebuffer } of [this.sample, this.sum]) {
      gl.deleteTexture(texture);
      gl.deleteFramebuffer(framebuffer);
    }
    gl.deleteVertexArray(this.nothing);
    this.adding.dispose();
    this.storing.dispose();
  }
}
