// The part of three that the sphere uses (three ships no types of its own).
declare module "three" {
  export class Vector3 {
    constructor(x?: number, y?: number, z?: number);
    x: number;
    y: number;
    z: number;
    set(x: number, y: number, z: number): this;
    copy(other: Vector3): this;
    clone(): Vector3;
    normalize(): this;
    multiplyScalar(by: number): this;
    lerp(to: Vector3, share: number): this;
    dot(other: Vector3): number;
    length(): number;
    distanceTo(other: Vector3): number;
    project(camera: Camera): this;
    unproject(camera: Camera): this;
    sub(other: Vector3): this;
  }
  export class Color {
    constructor(style?: string);
    r: number;
    g: number;
    b: number;
    set(style: string): this;
    setRGB(r: number, g: number, b: number, space?: string): this;
  }
  export const SRGBColorSpace: string;
  export const BackSide: number;
  export const FrontSide: number;
  export const DoubleSide: number;
  export const DynamicDrawUsage: number;
  export class Matrix4 {
    compose(position: Vector3, rotation: Quaternion, scale: Vector3): this;
  }
  export class Quaternion {}
  export class Object3D {
    position: Vector3;
    up: Vector3;
    visible: boolean;
    frustumCulled: boolean;
    renderOrder: number;
    add(...objects: Object3D[]): this;
    lookAt(x: number, y: number, z: number): void;
  }
  export class Camera extends Object3D {
    updateMatrixWorld(): void;
  }
  export class PerspectiveCamera extends Camera {
    constructor(fov: number, aspect: number, near: number, far: number);
    aspect: number;
    fov: number;
    updateProjectionMatrix(): void;
  }
  export class Fog {
    constructor(color: Color, near: number, far: number);
    color: Color;
    near: number;
    far: number;
  }
  export class Scene extends Object3D {
    fog: Fog | null;
    background: Color | null;
  }
  export class BufferAttribute {
    constructor(array: Float32Array, size: number);
    array: Float32Array;
    needsUpdate: boolean;
    setUsage(usage: number): this;
  }
  export class BufferGeometry {
    setAttribute(name: string, attribute: BufferAttribute): this;
    getAttribute(name: string): BufferAttribute;
    setDrawRange(start: number, count: number): void;
    dispose(): void;
  }
  export class SphereGeometry extends BufferGeometry {
    constructor(radius: number, width: number, height: number);
  }
  export class CircleGeometry extends BufferGeometry {
    constructor(radius: number, segments: number);
  }
  export class Material {
    dispose(): void;
    color: Color;
    opacity: number;
    uniforms: Record<string, { value: unknown }>;
  }
  export class MeshBasicMaterial extends Material {
    constructor(options: object);
  }
  export class LineBasicMaterial extends Material {
    constructor(options: object);
  }
  export class PointsMaterial extends Material {
    constructor(options: object);
  }
  export class ShaderMaterial extends Material {
    constructor(options: object);
  }
  export class Mesh extends Object3D {
    constructor(geometry: BufferGeometry, material: Material);
    geometry: BufferGeometry;
    material: Material;
  }
  export class InstancedMesh extends Mesh {
    constructor(geometry: BufferGeometry, material: Material, count: number);
    count: number;
    instanceMatrix: BufferAttribute;
    instanceColor: BufferAttribute | null;
    setMatrixAt(index: number, matrix: Matrix4): void;
    setColorAt(index: number, color: Color): void;
  }
  export class LineSegments extends Object3D {
    constructor(geometry: BufferGeometry, material: Material);
    geometry: BufferGeometry;
    material: Material;
  }
  export class Points extends Object3D {
    constructor(geometry: BufferGeometry, material: Material);
    geometry: BufferGeometry;
    material: Material;
  }
  export class CanvasTexture {
    constructor(canvas: HTMLCanvasElement | OffscreenCanvas);
    dispose(): void;
  }
  export class WebGLRenderer {
    constructor(options: object);
    info: { render: { calls: number } };
    setSize(width: number, height: number, style: boolean): void;
    setPixelRatio(ratio: number): void;
    render(scene: Scene, camera: Camera): void;
    compileAsync(scene: Scene, camera: Camera): Promise<Scene>;
    dispose(): void;
    forceContextLoss(): void;
  }
}

declare module "three/addons/controls/OrbitControls.js" {
  import type { Camera, Vector3 } from "three";
  export class OrbitControls {
    constructor(camera: Camera, element: HTMLElement);
    target: Vector3;
    enablePan: boolean;
    enableDamping: boolean;
    minDistance: number;
    maxDistance: number;
    rotateSpeed: number;
    update(): boolean;
    dispose(): void;
    addEventListener(name: string, listener: () => void): void;
  }
}
