import { describe, expect, it } from 'vitest';
import { AT_REST, STEPS_PER_SECOND, type Controls } from '../game.ts';
import { hillGame } from './hill-game.ts';
import {
  onUnitCircle,
  PLATFORM_RADIUS,
  startHill,
  nextRing,
  radiusAt,
  RINGS,
  type HillState,
} from './hill-state.ts';

const stick = (x: number, y: number, isPressed = false): Controls => ({ x, y, isPressed });

function place(state: HillState, seat: number, x: number, y: number): void {
  const piece = state.pieces.find((one) => one.seat === seat)!;
  Object.assign(piece.position, { x, y });
  Object.assign(piece.velocity, { x: 0, y: 0 });
}

function run(
  state: HillState,
  steps: number,
  controls: (seat: number, step: number) => Controls,
): void {
  for (let step = 0; step < steps; step += 1)
    hillGame.step(state, (seat) => controls(seat, step), hillGame.settings);
}

const pair = (): HillState => startHill({ seats: [0, 1], seed: 1 });

describe('King of the Hill', () => {
  it('places up to 32 pieces on the platform, none in another', () => {
    const seats = Array.from({ length: 32 }, (_, seat) => seat);
    const { pieces } = startHill({ seats, seed: 0 });
    for (const a of pieces)
      for (const b of pieces)
        if (a !== b)
          expect(
            Math.hypot(a.position.x - b.position.x, a.position.y - b.position.y),
          ).toBeGreaterThan(2);
    for (const { position } of pieces)
      expect(Math.hypot(position.x, position.y)).toBeLessThan(PLATFORM_RADIUS - 1);
  });

  it('gives points on the circle without sine, to within a fifth of a degree', () => {
    for (let turn = 0; turn < 1; turn += 1 / 64) {
      const { x, y } = onUnitCircle(turn);
      const off = ((Math.atan2(y, x) / (2 * Math.PI) - turn + 1.5) % 1) - 0.5;
      expect(Math.abs(off * 360)).toBeLessThan(0.2);
    }
  });

  it('lets a piece slide on when its stick is let go', () => {
    const state = pair();
    place(state, 0, -6, 0);
    place(state, 1, 0, 8);
    run(state, 30, (seat) => (seat === 0 ? stick(1, 0) : AT_REST));
    const { x } = state.pieces[0]!.position;
    run(state, 30, () => AT_REST);
    expect(state.pieces[0]!.position.x).toBeGreaterThan(x + 0.8);
  });

  it('dashes further the longer the button was held, and not again at once', () => {
    const reach = (held: number): number => {
      const state = pair();
      place(state, 0, -8, 0);
      place(state, 1, 0, 8);
      run(state, held + 40, (seat, step) =>
        seat === 0 ? stick(step < held ? 0 : 0.01, 0, step < held) : AT_REST,
      );
      return state.pieces[0]!.position.x;
    };
    expect(reach(36)).toBeGreaterThan(reach(3) + 2);
    const state = pair();
    run(state, 40, () => stick(0, 0, true));
    run(state, 1, () => AT_REST);
    run(state, 30, () => stick(0, 0, true));
    expect(state.pieces[0]!.charge).toBe(0);
  });

  it('counts a push for the pusher when the other player falls', () => {
    const state = pair();
    place(state, 0, 4, 0);
    place(state, 1, 8, 0);
    run(state, 200, (seat, step) => (seat === 0 && step < 60 ? stick(1, 0, step < 20) : AT_REST));
    expect(state.pieces[1]!.outAt).toBeDefined();
    expect(state.pieces[0]!.pushes).toBe(1);
  });

  it('crowns the piece that was last in the middle, which keeps the crown outside of it', () => {
    const state = pair();
    place(state, 0, 0, 0);
    place(state, 1, 6, 0);
    run(state, 10, () => AT_REST);
    expect(state.crown).toBe(0);
    place(state, 0, -6, 0);
    run(state, 10, () => AT_REST);
    expect(state.crown).toBe(0);
    place(state, 1, 0, 0);
    run(state, 10, () => AT_REST);
    expect(state.crown).toBe(1);
    expect(state.pieces.map(({ crownSteps }) => crownSteps)).toEqual([20, 10]);
  });

  it('gives the last one who stands 20 seconds of the crown', () => {
    const state = pair();
    place(state, 1, PLATFORM_RADIUS + 1, 0);
    run(state, 1, () => AT_REST);
    expect(hillGame.isOver(state)).toBe(true);
    expect(hillGame.places(state)).toEqual([[0], [1]]);
  });

  it('ranks players with equal crown time by the time that they stood', () => {
    const state = startHill({ seats: [0, 1, 2, 3], seed: 1 });
    place(state, 2, PLATFORM_RADIUS + 1, 0);
    run(state, 1, () => AT_REST);
    expect(hillGame.places(state)).toEqual([[0, 1, 3], [2]]);
    expect(hillGame.feedback(state, 2)).toMatchObject({ place: 4, isOut: true });
    place(state, 1, PLATFORM_RADIUS + 1, 0);
    run(state, 1, () => AT_REST);
    expect(hillGame.places(state)).toEqual([[0, 3], [1], [2]]);
  });

  it('loses its rings from the outside in, then shrinks without a pause', () => {
    expect(radiusAt(0)).toBe(PLATFORM_RADIUS);
    for (const { inner, fallsAt } of RINGS) {
      expect(radiusAt(fallsAt - 1)).toBeGreaterThan(inner);
      expect(radiusAt(fallsAt)).toBe(inner);
    }
    expect(radiusAt(80 * STEPS_PER_SECOND)).toBeLessThan(4);
    expect(nextRing(22 * STEPS_PER_SECOND)?.inS).toBe(3);
    expect(nextRing(70 * STEPS_PER_SECOND)).toBeUndefined();
  });

  it('lets fallen players vote for the next power, which the first player there gets', () => {
    const state = startHill({ seats: [0, 1, 2], seed: 1 });
    place(state, 2, PLATFORM_RADIUS + 1, 0);
    run(state, 8 * STEPS_PER_SECOND, (seat) => (seat === 2 ? stick(0, 1) : AT_REST));
    expect(state.offer?.kind).toBe('anchor');
    const { x, y } = state.offer!.position;
    place(state, 0, x, y);
    run(state, 1, () => AT_REST);
    expect(state.pieces[0]!.power?.kind).toBe('anchor');
    expect(state.offer).toBeUndefined();
    run(state, 5 * STEPS_PER_SECOND, () => AT_REST);
    expect(state.pieces[0]!.power).toBeUndefined();
  });

  it('is ice without end when friction is turned off', () => {
    const state = pair();
    place(state, 0, 0, 0);
    place(state, 1, 0, 8);
    const ice = { ...hillGame.settings, friction: 0 };
    hillGame.step(state, () => stick(1, 0), ice);
    const speed = state.pieces[0]!.velocity.x;
    for (let step = 0; step < 60; step += 1) hillGame.step(state, () => AT_REST, ice);
    expect(state.pieces[0]!.velocity.x).toBe(speed);
  });
});
