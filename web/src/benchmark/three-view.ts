// three.js showing the measured scene with its MeshPhongMaterial: what the page's WebGL2 view is measured against.
import * as THREE from "three";
import type { GpuGeometry } from "../engine/types";
import { kRequest } from "./scene";

export class ThreeView {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera: THREE.PerspectiveCamera;

  constructor(canvas: HTMLCanvasElement, data: GpuGeometry) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    this.renderer.setSize(kRequest.width, kRequest.height, false);
    this.scene.background = new THREE.Color(0.1, 0.1, 0.12);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(data.positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(data.normals, 3));
    geometry.setIndex(new THREE.BufferAttribute(data.indices, 1));
    const material = new THREE.MeshPhongMaterial({
      color: new THREE.Color(0.5, 0.4, 0.3),
      specular: new THREE.Color(0.5, 0.5, 0.5),
      shininess: 32,
    });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.scene.add(mesh, new THREE.AmbientLight(0xffffff, 0.2));
    const sun = new THREE.DirectionalLight(0xffffff, 1);
    sun.position.set(1, 1, 1);
    const point = new THREE.PointLight(new THREE.Color(0.5, 0.4, 0.3), 1, 0, 0);
    point.position.set(2, 2, 2);
    const spot = new THREE.SpotLight(0xffffff, 1, 0, (40 * Math.PI) / 180, 0.25, 0);
    spot.position.set(-2, 3, 2);
    spot.target.position.set(-1.5, 2, 1.5);
    this.scene.add(sun, point, spot, spot.target);
    this.camera = new THREE.PerspectiveCamera(42, kRequest.width / kRequest.height, 0.5, 6);
    this.camera.position.set(0, 1.5, 2.2);
    this.camera.lookAt(0, 0, 0);
  }

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** Waits until the card has drawn. */
  finish(): void {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** The share of the pixels that do not show the picture's corner's colour. */
  coveredShare(): number {
    const gl = this.renderer.getContext();
    const bytes = new Uint8Array(kRequest.width * kRequest.height * 4);
    gl.readPixels(0, 0, kRequest.width, kRequest.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let covered = 0;
    for (let at = 0; at < bytes.length; at += 4) {
      covered += bytes[at] !== bytes[0] || bytes[at + 1] !== bytes[1] || bytes[at + 2] !== bytes[2] ? 1 : 0;
    }
    return covered / (bytes.length / 4);
  }

  dispose(): void {
    this.renderer.dispose();
  }
}
