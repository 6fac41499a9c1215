import type { PieceKit } from '../pieces/piece-kit.ts';
import type { Scene } from '../stage.ts';
import { DuelScene } from './duel/duel-scene.ts';
import { HillScene } from './hill/hill-scene.ts';
import { LobbyScene } from './lobby/lobby-scene.ts';
import { PiecesScene } from './pieces/pieces-scene.ts';
import { PodiumScene } from './podium/podium-scene.ts';
import { RaceScene } from './race/race-scene.ts';
import type { SceneView } from './scene-view.ts';

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

export function openScene(kind: Scene['kind'], kit: PieceKit): SceneView {
  // The stage shows a view only scenes of the kind it was opened for
  return OPENERS[kind](kit) as unknown as SceneView;
}
