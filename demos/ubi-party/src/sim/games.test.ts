import { describe, expect, it } from 'vitest';
import { AT_REST, type Controls, type Game, type GameSettings } from './game.ts';
import { GAMES } from './games.ts';
import { stateHash } from './state-hash.ts';
import { templateGame } from './template/template-game.ts';
import { playWithBots } from './testing/play-with-bots.ts';

type AnyGame = Game<unknown, GameSettings>;
const SEATS = Array.from({ length: 32 }, (_, seat) => seat);

const ALL = { ...GAMES, template: templateGame };

/** Rules for all games. */
describe.each(Object.entries(ALL) as unknown as [string, AnyGame][])('%s', (id, game) => {
  it('is found by its id, and is explained', () => {
    expect(game.id).toBe(id);
    expect(game.explanation.length).toBeGreaterThan(0);
  });

  it.each([2, 7, 32])('ends with each of %i players in one place', (players) => {
    const places = game.places(playWithBots(game, players, 5));
    expect(places.flat().sort((a, b) => a - b)).toEqual(SEATS.slice(0, players));
  });

  it('says to every player in every moment how they stand', () => {
    let steps = 0;
    playWithBots(game, 5, 3, (state) => {
      if ((steps += 1) % 50 !== 0) return;
      for (const seat of SEATS.slice(0, 5)) {
        const hud = game.hud(state, (one) => `P${one}`);
        expect(hud.headline.length).toBeLessThanOrEqual(16);
        expect(hud.notes[seat]).toMatch(/\S/);
        const { place, of, headline, sentence, progress, gauge } = game.feedback(state, seat);
        expect(place).toBeGreaterThanOrEqual(1);
        expect(place).toBeLessThanOrEqual(of);
        expect(headline.length).toBeLessThanOrEqual(16);
        expect(sentence).toMatch(/^[A-Z0-9].*[.!]$/);
        for (const share of [progress, gauge]) expect(share).toBeGreaterThanOrEqual(0);
        for (const share of [progress, gauge]) expect(share).toBeLessThanOrEqual(1);
      }
    });
  });

  it('ends without any input', () => {
    const state = game.start({ seats: SEATS.slice(0, 4), seed: 3 });
    let steps = 0;
    while (!game.isOver(state) && steps < 300 * 60) {
      game.step(state, () => AT_REST, game.settings);
      steps += 1;
    }
    expect(game.isOver(state)).toBe(true);
  });

  it('has a state that is plain data, and goes on from it as if nothing had happened', () => {
    const seats = [0, 1, 2];
    const state = game.start({ seats, seed: 8 });
    const controls = (): Controls => ({ x: 0.5, y: 0.25, isPressed: false });
    for (let step = 0; step < 200; step += 1) game.step(state, controls, game.settings);
    const copy = JSON.parse(JSON.stringify(state)) as unknown;
    expect(copy).toEqual(state);
    for (const one of [state, copy])
      for (let step = 0; step < 200; step += 1) game.step(one, controls, game.settings);
    expect(stateHash(copy)).toBe(stateHash(state));
  });

  it('stays finite whatever controllers say', () => {
    const wild = [1, -1, 1e9, -1e9, 0];
    const state = game.start({ seats: SEATS, seed: 1 });
    for (let step = 0; step < 400 && !game.isOver(state); step += 1) {
      const value = (seat: number): number => wild[(seat + step) % wild.length]!;
      const controls = (seat: number): Controls => ({
        x: value(seat),
        y: value(seat + 2),
        isPressed: (seat + step) % 3 === 0,
        pressedAtMs: value(seat) * step,
      });
      game.step(state, controls, game.settings);
    }
    expect(JSON.stringify(state)).not.toContain('null');
  });

  it('keeps its pieces on the table', () => {
    playWithBots(game, 32, 6, (state) => {
      for (const { x, y } of game.pieces?.(state) ?? [])
        expect(Math.max(Math.abs(x), Math.abs(y))).toBeLessThanOrEqual(10);
    });
  });
});
