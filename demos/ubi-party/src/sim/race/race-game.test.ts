import { describe, expect, it } from 'vitest';
import { AT_REST, STEPS_PER_SECOND, type Controls } from '../game.ts';
import { playWithBots } from '../testing/play-with-bots.ts';
import { raceGame } from './race-game.ts';
import { lapOf, startRace, trackOf, type RaceState } from './race-state.ts';
import { findOnTrack, placeAt, TRACKS } from './track.ts';

const seedFor = (track: number): number => track;

function drive(state: RaceState, steps: number, controls: Controls): void {
  for (let step = 0; step < steps; step += 1)
    raceGame.step(state, () => controls, raceGame.settings);
}

describe.each(TRACKS.map((track, index) => [track.title, track, index] as const))(
  '%s',
  (_, track, index) => {
    it('is closed, and no bend is too sharp for its width', () => {
      for (const [at, point] of track.points.entries()) {
        const next = track.points[(at + 1) % track.points.length]!;
        const turn = Math.acos(
          Math.min(1, point.direction.x * next.direction.x + point.direction.y * next.direction.y),
        );
        const step = (next.distance - point.distance + track.length) % track.length;
        expect(step / Math.max(turn, 1e-9)).toBeGreaterThan(track.halfWidth);
      }
    });

    it('knows where a cart is, on every lap', () => {
      for (const distance of [-3, 0, 17.5, track.length - 0.1, track.length * 2 + 40]) {
        const { position, direction } = placeAt(track, distance);
        const beside = { x: position.x - direction.y * 2, y: position.y + direction.x * 2 };
        const found = findOnTrack(track, beside, distance - 0.2);
        expect(found.distance).toBeCloseTo(distance, 0);
        expect(found.toLeft).toBeCloseTo(2, 1);
      }
    });

    it('is driven to the end by bots, who stay on it for most of the time', () => {
      let [off, all] = [0, 0];
      const state = playWithBots(raceGame, 6, seedFor(index), ({ carts }) => {
        off += carts.filter(({ liftSteps }) => liftSteps > 0).length;
        all += carts.length;
      });
      expect(state.track).toBe(track.id);
      expect(state.carts.every(({ finishedAt }) => finishedAt !== undefined)).toBe(true);
      expect(off / all).toBeLessThan(0.1);
      const seconds =
        Math.min(...state.carts.map(({ finishedAt }) => finishedAt!)) / STEPS_PER_SECOND;
      expect(seconds).toBeGreaterThan(25);
      expect(seconds).toBeLessThan(90);
    });
  },
);

describe('Marble Dash', () => {
  it('puts a cart that left the track back within 0.8 seconds, facing forward', () => {
    const state = startRace({ seats: [0], seed: 0 });
    const [cart] = state.carts;
    let steps = 0;
    while (cart!.liftSteps === 0 && steps < 600) {
      drive(state, 1, { x: -1, y: 0, isPressed: false });
      steps += 1;
    }
    drive(state, 0.8 * STEPS_PER_SECOND, AT_REST);
    expect(cart!.liftSteps).toBe(0);
    const { direction } = placeAt(trackOf(state), cart!.distance);
    expect(cart!.heading.x * direction.x + cart!.heading.y * direction.y).toBeGreaterThan(0.9);
    expect(Math.abs(cart!.toLeft)).toBeLessThan(trackOf(state).halfWidth);
  });

  it('gives a boost for a press when it is saved up, and none for a button that is held', () => {
    const speedAfter = (isPressed: boolean): number => {
      const state = startRace({ seats: [0], seed: 0 });
      state.carts[0]!.energy = 1;
      drive(state, 60, { x: 0, y: 0, isPressed });
      return Math.hypot(state.carts[0]!.velocity.x, state.carts[0]!.velocity.y);
    };
    expect(speedAfter(true)).toBeGreaterThan(speedAfter(false) * 1.2);
    const state = startRace({ seats: [0], seed: 0 });
    state.carts[0]!.energy = 0.995;
    drive(state, 120, { x: 0, y: 0, isPressed: true });
    expect(state.carts[0]!.boostSteps).toBe(0);
  });

  it('lets two carts that meet bounce off each other', () => {
    const state = startRace({ seats: [0, 1], seed: 0 });
    const [a, b] = state.carts;
    Object.assign(b!.position, { x: a!.position.x + 0.5, y: a!.position.y });
    drive(state, 1, AT_REST);
    const apart = Math.hypot(a!.position.x - b!.position.x, a!.position.y - b!.position.y);
    expect(apart).toBeGreaterThan(1.95);
  });

  it('jumps once a lap on the bridge, where it flies straight', () => {
    const eight = TRACKS.findIndex(({ bridge }) => bridge !== undefined);
    let jumps = 0;
    let wasUp = false;
    const state = playWithBots(raceGame, 1, eight, ({ carts: [cart] }) => {
      const isUp = cart!.jumpSteps > 0;
      if (isUp && !wasUp) jumps += 1;
      wasUp = isUp;
    });
    expect(jumps).toBe(trackOf(state).laps);
  });

  it('counts laps, ranks by the way driven, and by time at the finish', () => {
    const state = startRace({ seats: [4, 7, 9], seed: 0 });
    const track = trackOf(state);
    const [a, b, c] = state.carts;
    expect(lapOf(a!, track)).toBe(1);
    a!.distance = track.length * 1.5;
    b!.distance = track.length * 1.7;
    expect(lapOf(b!, track)).toBe(2);
    c!.finishedAt = 4000;
    expect(raceGame.places(state)).toEqual([[9], [7], [4]]);
    a!.finishedAt = 3999.5;
    expect(raceGame.places(state)).toEqual([[4], [9], [7]]);
  });

  it('is over 20 seconds after the first has finished', () => {
    const state = startRace({ seats: [0, 1], seed: 0 });
    state.carts[0]!.finishedAt = 100;
    state.step = 100 + 20 * STEPS_PER_SECOND - 1;
    expect(raceGame.isOver(state)).toBe(false);
    state.step += 1;
    expect(raceGame.isOver(state)).toBe(true);
  });

  it('starts in another order with another seed', () => {
    const orders = [0, 3, 6].map((seed) =>
      startRace({ seats: [0, 1, 2], seed }).carts.map(({ distance, toLeft }) =>
        [distance, toLeft].join(),
      ),
    );
    expect(new Set(orders.map(String)).size).toBe(3);
  });
});
