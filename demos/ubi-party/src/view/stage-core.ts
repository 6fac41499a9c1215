import { NoToneMapping, PCFShadowMap, Scene as World, Vector3, type WebGLRenderer } from 'three';

import { CameraRig } from './camera/camera-rig.ts';
import { Backdrop } from './light/backdrop.ts';
import { HOURS, type Hour } from './light/hours.ts';
import { LightRig, smoothShadows } from './light/light-rig.ts';
import { PieceKit } from './pieces/piece-kit.ts';
import type { Quality } from './quality/quality.ts';
import { DuelScene } from './scenes/duel/duel-scene.ts';
import { HillScene } from './scenes/hill/hill-scene.ts';
import { LobbyScene } from './scenes/lobby/lobby-scene.ts';
import { PiecesScene } from './scenes/pieces/pieces-scene.ts';
import { PodiumScene } from './scenes/podium/podium-scene.ts';
import { RaceScene } from './scenes/race/race-scene.ts';
import type { SceneView } from './scenes/scene-view.ts';
import type { Scene, Stage } from './stage.ts';

type Openers = {
  readonly [K in Scene['kind']]: (kit: PieceKit) => SceneView<Extract<Scene, { kind: K }>>;
};

const OPENERS: Openers = {
  lobby: (kit) => new LobbyScene(kit),
  race: (kit) => new RaceScene(kit),
  podium: (kit) => new PodiumScene(kit),
  hill: (kit) => new HillScene(kit),
  duel: (kit) => new DuelScene(kit),
  pieces: (kit) => new PiecesScene(kit),
};

function openScene(kind: Scene['kind'], kit: PieceKit): SceneView {
  // The stage shows a view only scenes of the kind it was opened for
  return OPENERS[kind](kit) as unknown as SceneView;
}

/** Pixels drawn for one of the page, at most. */
const MAX_RATIO: Readonly<Record<Quality, number>> = { low: 1, middle: 1.25, high: 2 };
/** A pause is not made up for. */
const LONGEST_FRAME_S = 0.1;

/** The stage without a clock of its own: `advance` moves it on, `draw` draws it. */
export class StageCore {
  readonly #renderer: WebGLRenderer;
  readonly #world = new World();
  readonly #rig = new CameraRig();
  readonly #backdrop = new Backdrop();
  readonly #lights: LightRig;
  readonly #kit = new PieceKit();
  readonly #foot = new Vector3();
  readonly #top = new Vector3();
  #view: SceneView | undefined;
  #kind: Scene['kind'] | undefined;
  #width = 1;
  #height = 1;
  #isReduced = false;
  #quality: Quality = 'high';
  #beforeMs: number | undefined;

  constructor(renderer: WebGLRenderer) {
    this.#renderer = renderer;
    smoothShadows();
    renderer.toneMapping = NoToneMapping;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    this.#world.background = this.#backdrop.texture;
    // Lights stand in the world itself: they stay when the scene changes
    this.#lights = new LightRig(this.#world as never);
  }

  /** @returns whether another kind of scene is shown now, which takes time to build */
  show(scene: Scene, nowMs: number): boolean {
    const isNew = scene.kind !== this.#kind;
    if (isNew) this.#open(scene);
    this.#view!.show(scene, nowMs);
    if (isNew) this.#rig.frame(this.#view!.framing, true);
    return isNew;
  }

  setReducedMotion(isReduced: boolean): void {
    this.#isReduced = isReduced;
  }

  setQuality(quality: Quality): void {
    if (quality === this.#quality) return;
    this.#quality = quality;
    this.#lights.setQuality(quality);
    this.#applySize();
  }

  /** In CSS pixels. */
  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    [this.#width, this.#height] = [Math.max(1, width), Math.max(1, height)];
    this.#rig.resize(this.#width / this.#height);
    this.#applySize();
  }

  /** Moves all things on to a time. */
  advance(nowMs: number): void {
    const view = this.#view;
    if (!view) return;
    const dtS = Math.min(LONGEST_FRAME_S, Math.max(0, (nowMs - (this.#beforeMs ?? nowMs)) / 1000));
    this.#beforeMs = nowMs;
    view.update({
      nowMs,
      dtS,
      isReduced: this.#isReduced,
      quality: this.#quality,
      eye: this.#rig.camera.position,
    });
    this.#rig.frame(view.framing);
    this.#rig.update(dtS, view.zoom, this.#isReduced ? 0 : view.swayDeg, view.zoomAt);
  }

  draw(): void {
    const view = this.#view;
    if (!view) return;
    this.#backdrop.paint(view.hour, hourOf(view), this.#width / this.#height);
    this.#renderer.render(this.#world, this.#rig.camera);
  }

  placeOf(seat: number): ReturnType<Stage['placeOf']> {
    const high = this.#view?.footOf(seat, this.#foot) ?? 0;
    if (high === 0) return undefined;
    this.#top
      .copy(this.#foot)
      .setY(this.#foot.y + high)
      .project(this.#rig.camera);
    const { x, y, z } = this.#foot.project(this.#rig.camera);
    if (Math.abs(x) > 1 || Math.abs(y) > 1 || z > 1) return undefined;
    const height = ((this.#top.y - y) / 2) * this.#height;
    return { x: ((x + 1) / 2) * this.#width, y: ((1 - y) / 2) * this.#height, height };
  }

  dispose(): void {
    this.#view?.dispose();
    this.#kit.dispose();
    this.#backdrop.dispose();
    this.#lights.dispose();
    this.#renderer.dispose();
  }

  #open(scene: Scene): void {
    this.#view?.root.removeFromParent();
    this.#view?.dispose();
    this.#kind = scene.kind;
    this.#view = openScene(scene.kind, this.#kit);
    this.#world.add(this.#view.root);
    this.#lights.light(hourOf(this.#view), this.#view.reach);
  }

  #applySize(): void {
    this.#renderer.setPixelRatio(Math.min(MAX_RATIO[this.#quality], globalThis.devicePixelRatio));
    this.#renderer.setSize(this.#width, this.#height, false);
  }
}

function hourOf(view: SceneView): Hour {
  return HOURS[view.hour];
}
