// SPDX-License-Identifier: MIT
// The unit sphere in 3-D, in eight draw calls. Loaded only where WebGL works.
import * as three from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import type { Vec3 } from "../../socket/messages";
import { direction } from "../../store/angles";
import { colorOf, inks, ramp, rampIndex } from "../palette";
import type { Preset } from "../view";
import { Balls, dotTexture, Filling } from "./buffers";
import type { Frame } from "./frame";
import type { Picture, Projected, Stage } from "./stage";

const kDistance = 4.2;
const kPresets: Record<Preset, Vec3> = { front: [1, 0, 0.06], top: [-0.002, 0, 1], side: [0, -1, 0.06], iso: [0.72, -0.62, 0.5] };

const kRimVertex = "varying vec3 vNormal; varying vec3 vEye; void main() { vec4 p = modelViewMatrix * vec4(position, 1.0); vNormal = normalMatrix * normal; vEye = -p.xyz; gl_Position = projectionMatrix * p; }";
const kRimFragment = "uniform vec3 ink; varying vec3 vNormal; varying vec3 vEye; void main() { float rim = 1.0 - abs(dot(normalize(vNormal), normalize(vEye))); gl_FragColor = vec4(ink, 0.03 + 0.24 * rim * rim * rim); }";

export class SphereScene implements Stage {
  private readonly renderer: three.WebGLRenderer;
  private readonly scene = new three.Scene();
  private readonly camera = new three.PerspectiveCamera(30, 1, 0.1, 20);
  private readonly controls: OrbitControls;
  private readonly grid = new Filling(8192);
  private readonly lines = new Filling(16384);
  private readonly sparks = new Filling(8192);
  private readonly heat = new Filling(4096);
  private readonly balls = new Balls(64);
  private readonly mics = new Balls(256);
  private readonly rim: three.ShaderMaterial;
  private readonly floor: three.MeshBasicMaterial;
  private readonly glow: three.Color[] = [];
  private readonly ink = new three.Color();
  private width = 1;
  private height = 1;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, onMove: () => void) {
    this.renderer = new three.WebGLRenderer({ canvas, context });
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.minDistance = 2.2;
    this.controls.maxDistance = 8;
    this.controls.addEventListener("change", onMove);
    this.scene.fog = new three.Fog(new three.Color(), 1, 2);

    this.rim = new three.ShaderMaterial({ vertexShader: kRimVertex, fragmentShader: kRimFragment, uniforms: { ink: { value: this.ink } }, transparent: true, depthWrite: false });
    this.floor = new three.MeshBasicMaterial({ transparent: true, opacity: 0.07, depthWrite: false, side: three.DoubleSide, fog: false });
    const dot = dotTexture();
    const points = (size: number) => new three.PointsMaterial({ size, map: dot, vertexColors: true, transparent: true, depthWrite: false, fog: false });
    const line = (fog: boolean) => new three.LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, fog });
    const parts = [
      new three.Mesh(new three.CircleGeometry(1, 96), this.floor),
      new three.LineSegments(this.grid.geometry, line(true)),
      new three.Points(this.heat.geometry, points(0.16)),
      this.mics.mesh,
      new three.Points(this.sparks.geometry, points(0.05)),
      new three.LineSegments(this.lines.geometry, line(false)),
      this.balls.mesh,
      new three.Mesh(new three.SphereGeometry(1, 64, 40), this.rim),
    ];
    parts.forEach((part, k) => {
      part.frustumCulled = false;
      part.renderOrder = k;
    });
    this.scene.add(...parts);
    this.look("iso");
    this.recolor();
  }

  /** Resolves when the shaders are ready; the page goes on meanwhile, which it would not at the first drawing. */
  async compiled(): Promise<void> {
    await this.renderer.compileAsync(this.scene, this.camera);
  }

  resize(width: number, height: number, ratio: number): void {
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    // Upright boxes are fitted by their width, with room for the words at both sides.
    const share = Math.min(1, this.camera.aspect / 1.2);
    this.camera.fov = 2 * (180 / Math.PI) * Math.atan(Math.tan((15 * Math.PI) / 180) / share);
    this.camera.updateProjectionMatrix();
  }

  look(preset: Preset): void {
    const [x, y, z] = kPresets[preset];
    this.camera.position.set(x, y, z).normalize().multiplyScalar(kDistance);
    this.controls.update();
  }

  follow(az: number, el: number, share: number): void {
    const [x, y, z] = direction(az, Math.max(-60, Math.min(60, el * 0.5 + 12)));
    const away = this.camera.position.length();
    this.camera.position.lerp(new three.Vector3(x, y, z).multiplyScalar(away), share).normalize().multiplyScalar(away);
    this.controls.update();
  }

  recolor(): void {
    const ink = inks();
    this.scene.background = new three.Color(ink.ground);
    this.scene.fog!.color.set(ink.ground);
    this.floor.color.set(ink.accent);
    this.ink.set(ink.text);
    const table = ramp();
    for (let k = 0; k < 256; k++) this.glow[k] = new three.Color().setRGB(table[3 * k]! / 255, table[3 * k + 1]! / 255, table[3 * k + 2]! / 255, three.SRGBColorSpace);
    this.drawGrid(new three.Color(ink.text), new three.Color(ink.accent));
  }

  draw(frame: Frame, picture: Picture): void {
    const away = this.camera.position.length();
    this.scene.fog!.near = away - 0.7;
    this.scene.fog!.far = away + 1.5;
    this.fillBalls(frame, picture);
    this.sparks.begin();
    for (const { az, el, energy, age } of frame.sparks) {
      const [x, y, z] = direction(az, el);
      const index = rampIndex(energy, picture.energy);
      this.sparks.add(x, y, z, this.glow[index]!, (1 - age) * (0.35 + 0.65 * (index / 255)));
    }
    this.sparks.end();
    this.fillHeat(picture);
    this.mics.begin();
    const ink = new three.Color(inks().text);
    const chosen = new three.Color(inks().accent);
    picture.mics.forEach(([x, y, z], k) => this.mics.add(x, y, z, picture.mic === k ? 0.034 : 0.024, picture.mic === k ? chosen : ink));
    this.mics.end();
    this.renderer.render(this.scene, this.camera);
  }

  project([x, y, z]: Vec3): Projected {
    const point = new three.Vector3(x, y, z);
    const front = point.dot(this.camera.position) > point.length() ** 2 * 0.999;
    point.project(this.camera);
    return { x: (0.5 + point.x / 2) * this.width, y: (0.5 - point.y / 2) * this.height, front };
  }

  /** Where the ray through a pixel meets the sphere first. */
  pick(x: number, y: number): Vec3 | null {
    const from = this.camera.position;
    const ray = new three.Vector3((2 * x) / this.width - 1, 1 - (2 * y) / this.height, 0.5).unproject(this.camera).sub(from).normalize();
    const along = ray.dot(from);
    const inside = along * along - from.dot(from) + 1;
    if (inside < 0) return null;
    const away = -along - Math.sqrt(inside);
    return [from.x + away * ray.x, from.y + away * ray.y, from.z + away * ray.z];
  }

  get calls(): number {
    return this.renderer.info.render.calls;
  }

  dispose(): void {
    this.controls.dispose();
    this.renderer.dispose();
  }

  private fillBalls(frame: Frame, picture: Picture): void {
    this.balls.begin();
    this.lines.begin();
    for (const { id, look, az, el, activity, trail } of frame.balls) {
      const color = new three.Color(colorOf(look));
      const [x, y, z] = direction(az, el);
      const pointed = picture.pointed === id;
      this.balls.add(x, y, z, (pointed ? 0.075 : 0.05) * (0.8 + 0.2 * activity), color);
      this.lines.add(0, 0, 0, color, 0.08);
      this.lines.add(x, y, z, color, pointed ? 0.8 : 0.4);
      const last = trail.length / 2 - 1;
      for (let k = 0; k < last; k++) {
        for (const end of [k, k + 1]) {
          const [tx, ty, tz] = direction(trail[2 * end]!, trail[2 * end + 1]!);
          this.lines.add(tx, ty, tz, color, end / Math.max(1, last));
        }
      }
    }
    this.balls.end();
    this.lines.end();
  }

  private fillHeat({ power, powerGrid }: Picture): void {
    this.heat.begin();
    const count = power ? Math.min(power.values.length, powerGrid.length) : 0;
    for (let k = 0; k < count; k++) {
      const value = power!.values[k]!;
      if (value < 8) continue;
      const [x, y, z] = powerGrid[k]!;
      this.heat.add(x, y, z, this.glow[value]!, 0.06 + (0.6 * value) / 255);
    }
    this.heat.end();
  }

  private drawGrid(ink: three.Color, accent: three.Color): void {
    this.grid.begin();
    const arc = (from: Vec3, to: Vec3, color: three.Color, opacity: number) => {
      this.grid.add(...from, color, opacity);
      this.grid.add(...to, color, opacity);
    };
    for (let el = -60; el <= 60; el += 30) {
      for (let az = 0; az < 360; az += 4) arc(direction(az, el), direction(az + 4, el), el === 0 ? accent : ink, el === 0 ? 0.9 : 0.36);
    }
    for (let az = 0; az < 360; az += 30) {
      for (let el = -90; el < 90; el += 5) arc(direction(az, el), direction(az, el + 5), ink, 0.36);
    }
    arc([0, 0, 0], [1, 0, 0], accent, 0.9);
    this.grid.end();
  }
}
