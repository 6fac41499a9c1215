import '@fontsource-variable/bricolage-grotesque/standard.css';
import { WebGLRenderer } from 'three';
import {
  GAMES,
  STEPS_PER_SECOND,
  type Controls,
  type Game,
  type Player,
  type Seat,
} from '../../sim/index.ts';
import { createStage } from '../create-stage.ts';
import { StageCore } from '../stage-core.ts';
import type { Scene } from '../stage.ts';

/**
 * Shows a scene at a step, played by bots: `gallery.html?scene=hill&players=6&step=900&seed=7`.
 * `live=1` plays on, `tour=1` with all scenes in turn; `reduced=1` and `quality=low` as in the settings; `away=2` lets
 * seat 2 be away. The title says `ready` when all is drawn.
 */
const query = new URLSearchParams(location.search);
const number = (name: string, otherwise: number): number => Number(query.get(name) ?? otherwise);
type Kind = Scene['kind'];
const KINDS: readonly Kind[] = ['lobby', 'race', 'hill', 'duel', 'podium'];
const kind = (query.get('scene') ?? 'hill') as Kind;
const seats: readonly Seat[] = Array.from({ length: number('players', 6) }, (_, seat) => seat);
const setup = { seats, seed: number('seed', 7) };
const isReduced = query.get('reduced') === '1';
const quality = (query.get('quality') ?? 'high') as 'low' | 'middle' | 'high';
const isTour = query.get('tour') === '1';
const STEPS_OF_A_TOUR = 6 * STEPS_PER_SECOND;
const canvas = document.querySelector('canvas')!;

/** Gives the scene one step later, at each call. */
function scenes(kind: Kind): () => Scene {
  switch (kind) {
    case 'hill':
      return played(GAMES.hill, (state) => ({ kind, state }));
    case 'race':
      return played(GAMES.race, (state) => ({ kind, state }));
    case 'duel':
      return played(GAMES.duel, (state) => ({ kind, state }));
    case 'pieces':
      return played(GAMES.quiz, (state) => ({
        kind,
        pieces: GAMES.quiz.pieces!(state),
        hasSides: true,
      }));
    case 'lobby':
      return joining();
    case 'podium':
      return () => ({ kind, players: players(seats), first: [...seats].reverse().slice(0, 3) });
  }
}

function played<State>(game: Game<State>, scene: (state: State) => Scene): () => Scene {
  const state = game.start(setup);
  return () => {
    const controls = new Map<Seat, Controls>(seats.map((seat) => [seat, game.bot(state, seat)]));
    if (!game.isOver(state)) game.step(state, (seat) => controls.get(seat)!, game.settings);
    return scene(state);
  };
}

/** One joins each third of a second. */
function joining(): () => Scene {
  let step = 0;
  return () => {
    step += 1;
    return { kind: 'lobby', players: players(seats.slice(0, Math.ceil(step / 20))), words: 'join' };
  };
}

function players(of: readonly Seat[]): Player[] {
  return of.map((seat) => ({
    seat,
    name: `Player ${seat}`,
    isReady: false,
    isWaiting: false,
    points: 0,
    ...(query.get('away') === String(seat) && { awaySinceMs: 0 }),
  }));
}

async function showStill(step: number): Promise<void> {
  const core = new StageCore(
    new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true }),
  );
  core.setReducedMotion(isReduced);
  core.setQuality(quality);
  core.resize(canvas.clientWidth, canvas.clientHeight);
  const next = scenes(kind);
  for (let at = 0; at <= step; at += 1) {
    core.show(next(), (at * 1000) / STEPS_PER_SECOND);
    core.advance((at * 1000) / STEPS_PER_SECOND);
  }
  await document.fonts.load('800 100px "Bricolage Grotesque Variable"', 'ABC');
  await document.fonts.ready;
  core.draw();
  document.title = 'ready';
}

function playLive(step: number): void {
  const stage = createStage(canvas, {
    isReducedMotion: isReduced,
    ...(query.has('quality') && { quality }),
  });
  let next = scenes(kind);
  for (let at = 0; at < step; at += 1) next();
  let stepsDone = 0;
  const beganMs = performance.now();
  requestAnimationFrame(function onFrame(nowMs) {
    requestAnimationFrame(onFrame);
    const wanted = Math.floor(((nowMs - beganMs) / 1000) * STEPS_PER_SECOND);
    for (; stepsDone < wanted; stepsDone += 1) {
      if (isTour && stepsDone % STEPS_OF_A_TOUR === 0)
        next = scenes(KINDS[(stepsDone / STEPS_OF_A_TOUR) % KINDS.length]!);
      stage.show(next());
    }
    document.title = `${stage.frames.quality} ${stage.frames.p95Ms.toFixed(1)} ms`;
  });
}

if (isTour || query.get('live') === '1') playLive(number('step', 0));
else await showStill(number('step', 0));
