import { describe, expect, it } from 'vitest';
import type { RoundState } from '../../modules/index.ts';
import { RoundFilm } from './round-film.ts';

const frame = (step: number, id = 'a'): RoundState => ({
  ...{ id, step, state: { step }, places: [], isOver: false },
});

describe('the film of a round', () => {
  it('keeps its last four seconds, and plays them slower', () => {
    const film = new RoundFilm();
    for (let step = 1; step <= 1000; step += 1) film.add(frame(step));
    expect(film.newest?.step).toBe(1000);
    expect(film.at(0)?.step).toBe(760);
    expect(film.lengthMs).toBeCloseTo(4000 / 0.6);
    expect(film.at(film.lengthMs)?.step).toBe(1000);
    expect(film.at(film.lengthMs + 1)).toBeUndefined();
  });

  it('begins again with another round', () => {
    const film = new RoundFilm();
    for (let step = 1; step <= 100; step += 1) film.add(frame(step));
    film.add(frame(1, 'b'));
    expect(film.at(0)).toEqual(frame(1, 'b'));
  });

  it('is empty before the first state', () => {
    expect(new RoundFilm().at(0)).toBeUndefined();
  });
});
