import { Color, PerspectiveCamera, Scene, Vector3, type WebGLRenderer } from 'three';
import { eyeOf, FIELD_DEGREES } from '../orbit.ts';
import { MAX_THINGS, ORIGIN, type Axes, type Point, type SpaceThing } from '../space-things.ts';
import { Batch } from './arrow-batch.ts';
import { LineBatch } from './line-batch.ts';
import { openRenderer } from './open-renderer.ts';
import type { SceneInput, SceneLabel } from './scene-input.ts';

/** Most objects whose axes have letters, */
const LETTERED = 3;
/** and most objects with names. */
const NAMED = 40;
const ROOM: readonly [string, Point][] = [
  ['X', [1, 0, 0]],
  ['Y', [0, 1, 0]],
  ['Z', [0, 0, 1]],
];
const ARMS = ['x', 'y', 'z'] as const;

/** Draws objects in space on a canvas, on request. */
export class SpaceScene {
  readonly #renderer: WebGLRenderer;
  readonly #ratio: number;
  readonly #camera = new PerspectiveCamera(FIELD_DEGREES);
  readonly #scene = new Scene();
  readonly #lines = new LineBatch();
  readonly #arrows = Batch.ofArrows(MAX_THINGS * 3);
  readonly #dots = Batch.ofDots(MAX_THINGS);
  #width = 0;
  #height = 0;

  private constructor(renderer: WebGLRenderer, ratio: number) {
    this.#renderer = renderer;
    this.#ratio = ratio;
    this.#scene.add(this.#lines.mesh, this.#arrows.mesh, this.#dots.mesh);
  }

  /** Undefined without WebGL. */
  static open(canvas: HTMLCanvasElement): SpaceScene | undefined {
    const opened = openRenderer(canvas);
    return opened && new SpaceScene(opened.renderer, opened.ratio);
  }

  resize(width: number, height: number): void {
    this.#width = width;
    this.#height = height;
    this.#renderer.setPixelRatio(this.#ratio);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / Math.max(1, height);
    this.#camera.updateProjectionMatrix();
  }

  /** @returns labels with their positions */
  draw(input: SceneInput): SceneLabel[] {
    const { things, colors, ground, scale, trails } = input;
    this.#aim(input);
    for (const batch of [this.#lines, this.#arrows, this.#dots]) batch.begin();
    this.#addGround(input);
    for (const points of trails.values()) {
      points.slice(1).forEach((point, index) => {
        this.#lines.add(points[index]!, point, colors.vector);
      });
    }
    const arms: { thing: SpaceThing; index: number; arm: string }[] = [];
    for (const thing of things) {
      const { at, axes, mark, size } = thing;
      if (mark === 'arrow') this.#arrows.addArrow(ORIGIN, at, scale * 0.014, colors.vector);
      if (mark === 'dot') this.#dots.addDot(at, scale * 0.022, colors.vector);
      if (mark !== 'axes') this.#addDrop(at, input);
      if (size) this.#addBox(at, axes, size, colors.box);
      const length = thing.isToScale ? 1 : scale * 0.22;
      axes?.forEach((axis, part) => {
        const along = axis.map((one) => one * length) as unknown as Point;
        const wide = Math.min(scale, 4 * length) * 0.018;
        const index = this.#arrows.addArrow(at, along, wide, colors.arms[part]!);
        if (index >= 0 && things.length <= LETTERED) arms.push({ thing, index, arm: ARMS[part]! });
      });
    }
    for (const batch of [this.#lines, this.#arrows, this.#dots]) batch.end();
    this.#renderer.render(this.#scene, this.#camera);

    return [
      ...ROOM.flatMap(([text, axis]) => {
        const end = new Vector3(...axis).multiplyScalar(ground.reach * 1.07);
        return this.#label(`room ${text}`, text, 'axis', end);
      }),
      ...arms.flatMap(({ thing, index, arm }) =>
        this.#label(`${thing.key} ${arm}`, arm, 'arm', this.#arrows.tipOf(index)),
      ),
      ...things
        .filter(({ name }) => name !== '')
        .slice(0, NAMED)
        .flatMap(({ key, name, at }) =>
          this.#label(`${key} name`, name, 'name', new Vector3(...at)),
        ),
    ];
  }

  dispose(): void {
    for (const batch of [this.#lines, this.#arrows, this.#dots]) batch.dispose();
    this.#renderer.dispose();
    // Browsers limit the number of WebGL contexts: release this one before garbage collection.
    this.#renderer.forceContextLoss();
  }

  #aim({ orbit, up, colors, ground }: SceneInput): void {
    const camera = this.#camera;
    camera.up.set(0, up === 'y' ? 1 : 0, up === 'z' ? 1 : 0);
    camera.position.set(...eyeOf(orbit, up));
    camera.lookAt(...orbit.target);
    camera.near = orbit.distance / 100;
    camera.far = orbit.distance * 10 + ground.reach * 10;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.#renderer.setClearColor(new Color().setStyle(colors.ground));
  }

  #addGround({ ground: { reach, step }, up, colors }: SceneInput): void {
    const flat = (a: number, b: number): Point => (up === 'y' ? [a, 0, b] : [a, b, 0]);
    const count = Math.round(reach / step);
    for (let line = -count; line <= count; line++) {
      if (line === 0) continue;
      const at = line * step;
      this.#lines.add(flat(at, -reach), flat(at, reach), colors.grid);
      this.#lines.add(flat(-reach, at), flat(reach, at), colors.grid);
    }
    for (const [, axis] of ROOM) {
      const end = axis.map((part) => part * reach) as unknown as Point;
      const isUp = axis[up === 'y' ? 1 : 2] === 1;
      const start = end.map((part) => (isUp ? 0 : -part)) as unknown as Point;
      this.#lines.add(start, end, colors.axis);
    }
  }

  /** Vertical line to the ground, which shows the position of a floating object. */
  #addDrop([x, y, z]: Point, { up, colors }: SceneInput): void {
    this.#lines.add([x, y, z], up === 'y' ? [x, 0, z] : [x, y, 0], colors.axis);
  }

  #addBox(at: Point, axes: Axes | undefined, size: Point, color: string): void {
    const [a, b, c] = axes ?? [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ];
    const corner = (i: number, j: number, k: number): Point =>
      at.map(
        (part, n) =>
          part +
          ((i - 0.5) * size[0] * a[n]! + (j - 0.5) * size[1] * b[n]! + (k - 0.5) * size[2] * c[n]!),
      ) as unknown as Point;
    for (const i of [0, 1]) {
      for (const j of [0, 1]) {
        this.#lines.add(corner(0, i, j), corner(1, i, j), color);
        this.#lines.add(corner(i, 0, j), corner(i, 1, j), color);
        this.#lines.add(corner(i, j, 0), corner(i, j, 1), color);
      }
    }
  }

  /** Returns no label for positions behind the camera or outside of the picture. */
  #label(key: string, text: string, kind: SceneLabel['kind'], at: Vector3): SceneLabel[] {
    const { x, y, z } = at.project(this.#camera);
    if (!(z < 1) || Math.abs(x) > 1 || Math.abs(y) > 1) return [];
    const left = ((x + 1) / 2) * this.#width;
    const top = ((1 - y) / 2) * this.#height;
    return [{ key, text, kind, left, top }];
  }
}
