// SPDX-License-Identifier: MIT
// Geometry that is written anew for each picture: one buffer and one draw call, however much there is to show.
import * as three from "three";

/** Positions and colours (with opacity) that are filled from the front. */
export class Filling {
  readonly geometry = new three.BufferGeometry();
  private readonly positions: Float32Array;
  private readonly colors: Float32Array;
  private count = 0;

  constructor(private readonly most: number) {
    this.positions = new Float32Array(3 * most);
    this.colors = new Float32Array(4 * most);
    this.geometry.setAttribute("position", new three.BufferAttribute(this.positions, 3).setUsage(three.DynamicDrawUsage));
    this.geometry.setAttribute("color", new three.BufferAttribute(this.colors, 4).setUsage(three.DynamicDrawUsage));
  }

  begin(): void {
    this.count = 0;
  }

  /** Left out when the buffer is full. */
  add(x: number, y: number, z: number, color: three.Color, opacity: number): void {
    if (this.count >= this.most) return;
    this.positions.set([x, y, z], 3 * this.count);
    this.colors.set([color.r, color.g, color.b, opacity], 4 * this.count);
    this.count++;
  }

  end(): void {
    this.geometry.setDrawRange(0, this.count);
    this.geometry.getAttribute("position").needsUpdate = true;
    this.geometry.getAttribute("color").needsUpdate = true;
  }
}

/** Balls of one shape. */
export class Balls {
  readonly mesh: three.InstancedMesh;
  private readonly matrix = new three.Matrix4();
  private readonly still = new three.Quaternion();
  private readonly place = new three.Vector3();
  private readonly size = new three.Vector3();
  private count = 0;

  constructor(private readonly most: number) {
    this.mesh = new three.InstancedMesh(new three.SphereGeometry(1, 20, 14), new three.MeshBasicMaterial({ toneMapped: false, fog: false }), most);
    this.mesh.frustumCulled = false;
    this.mesh.count = 0;
  }

  begin(): void {
    this.count = 0;
  }

  add(x: number, y: number, z: number, radius: number, color: three.Color): void {
    if (this.count >= this.most) return;
    this.mesh.setMatrixAt(this.count, this.matrix.compose(this.place.set(x, y, z), this.still, this.size.set(radius, radius, radius)));
    this.mesh.setColorAt(this.count, color);
    this.count++;
  }

  end(): void {
    this.mesh.count = this.count;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }
}

/** A soft round dot, for points that are squares otherwise. */
export function dotTexture(): three.CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const draw = canvas.getContext("2d")!;
  const shade = draw.createRadialGradient(16, 16, 4, 16, 16, 16);
  shade.addColorStop(0, "#fff");
  shade.addColorStop(1, "rgb(255 255 255 / 0%)");
  draw.fillStyle = shade;
  draw.fillRect(0, 0, 32, 32);
  return new three.CanvasTexture(canvas);
}
