// Meshes in the graphics card's memory, kept for as long as the scene shows them.
import type { GpuGeometry } from "../engine/types";

/** Attributes as src/shade/vertex.glsl numbers them: position, normal (of flat shading: the face's), the face's centre. */
export class Geometry {
  readonly array: WebGLVertexArrayObject;
  private readonly gl: WebGL2RenderingContext;
  private readonly buffers: WebGLBuffer[] = [];

  constructor(gl: WebGL2RenderingContext, data: GpuGeometry) {
    this.gl = gl;
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    [data.positions, data.normals, data.centers].forEach((values, place) => {
      if (values) {
        this.fill(gl.ARRAY_BUFFER, values);
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
      }
    });
    this.fill(gl.ELEMENT_ARRAY_BUFFER, data.indices);
    gl.bindVertexArray(null);
  }

  dispose(): void {
    this.gl.deleteVertexArray(this.array);
    for (const buffer of this.buffers) {
      this.gl.deleteBuffer(buffer);
    }
  }

  private fill(target: number, values: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>): void {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, values, this.gl.STATIC_DRAW);
    this.buffers.push(buffer);
  }
}
