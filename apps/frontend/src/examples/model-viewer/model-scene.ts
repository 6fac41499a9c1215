import {
  AmbientLight,
  BoxGeometry,
  Color,
  DirectionalLight,
  Group,
  LatheGeometry,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector2,
  type BufferGeometry,
  type WebGLRenderer,
} from 'three';
import { openRenderer } from '../../topics/viewers/space/three/open-renderer.ts';

/** Colours in CSS syntax. */
export interface ModelColors {
  readonly ground: string;
  readonly body: string;
  readonly wings: string;
  readonly glass: string;
}

export interface ModelInput {
  /** Rotation in screen coordinates: x to the right, y up, z towards the viewer. */
  readonly turn: { readonly x: number; readonly y: number; readonly z: number; readonly w: number };
  readonly colors: ModelColors;
}

/** Radius and position along the hull, from the tail to the nose; closed at both ends. */
export const HULL = [
  [0, -1],
  [0.02, -1],
  [0.1, -0.9],
  [0.17, -0.4],
  [0.2, 0.2],
  [0.17, 0.65],
  [0.09, 0.92],
  [0, 1],
].map(([radius, along]) => new Vector2(radius, along));
const FIELD_DEGREES = 30;
/** Radius of the model, which must be visible in every rotation. */
const REACH = 1.3;

/** An aeroplane: its nose is the top edge of the phone, its upper side the screen. Drawn on request. */
export class ModelScene {
  readonly #canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #ratio: number;
  readonly #camera = new PerspectiveCamera(FIELD_DEGREES, 1, 0.1, 100);
  readonly #scene = new Scene();
  readonly #model = new Group();
  readonly #geometries: BufferGeometry[] = [];
  readonly #body = new MeshLambertMaterial();
  readonly #wings = new MeshLambertMaterial();
  readonly #glass = new MeshLambertMaterial();

  private constructor(canvas: HTMLCanvasElement, renderer: WebGLRenderer, ratio: number) {
    this.#canvas = canvas;
    this.#renderer = renderer;
    this.#ratio = ratio;
    const sun = new DirectionalLight('white', 2.2);
    sun.position.set(2, 4, 5);
    this.#scene.add(this.#model, sun, new AmbientLight('white', 1.1));
    this.#add(new LatheGeometry(HULL, 28), this.#body);
    this.#add(new BoxGeometry(2, 0.42, 0.06), this.#wings, 0, 0.05, -0.02);
    this.#add(new BoxGeometry(0.8, 0.24, 0.05), this.#wings, 0, -0.82, 0.02);
    this.#add(new BoxGeometry(0.05, 0.3, 0.42), this.#wings, 0, -0.8, 0.24);
    const cockpit = this.#add(new SphereGeometry(0.13, 20, 14), this.#glass, 0, 0.45, 0.14);
    cockpit.scale.set(1, 1.9, 0.8);
  }

  /** Returns undefined without WebGL. */
  static open(canvas: HTMLCanvasElement): ModelScene | undefined {
    const opened = openRenderer(canvas);
    return opened && new ModelScene(canvas, opened.renderer, opened.ratio);
  }

  resize(width: number, height: number): void {
    this.#renderer.setPixelRatio(this.#ratio);
    this.#renderer.setSize(width, height, false);
    const aspect = width / Math.max(1, height);
    const half = Math.tan((FIELD_DEGREES * Math.PI) / 360) * Math.min(1, aspect);
    this.#camera.aspect = aspect;
    this.#camera.position.set(0, 0, REACH / half);
    this.#camera.updateProjectionMatrix();
  }

  /** Returns no labels. */
  draw({ turn, colors }: ModelInput): [] {
    this.#body.color.setStyle(colors.body);
    this.#wings.color.setStyle(colors.wings);
    this.#glass.color.setStyle(colors.glass);
    this.#renderer.setClearColor(new Color().setStyle(colors.ground));
    this.#model.quaternion.set(turn.x, turn.y, turn.z, turn.w);
    this.#renderer.render(this.#scene, this.#camera);
    // For tests: the rotation that was drawn, from the scene.
    const { x, y, z, w } = this.#model.getWorldQuaternion(new Quaternion());
    this.#canvas.dataset['turn'] = [x, y, z, w].map((part) => part.toFixed(4)).join(' ');
    return [];
  }

  dispose(): void {
    for (const geometry of this.#geometries) geometry.dispose();
    for (const material of [this.#body, this.#wings, this.#glass]) material.dispose();
    this.#renderer.dispose();
    // Browsers limit the number of WebGL contexts: release this one before garbage collection.
    this.#renderer.forceContextLoss();
  }

  #add(geometry: BufferGeometry, material: MeshLambertMaterial, x = 0, y = 0, z = 0): Mesh {
    const mesh = new Mesh(geometry, material);
    mesh.position.set(x, y, z);
    this.#geometries.push(geometry);
    this.#model.add(mesh);
    return mesh;
  }
}
