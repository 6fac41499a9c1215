import { describe, expect, it } from 'vitest';
import { AT_REST, STEPS_PER_SECOND, type Answer, type Controls, type Seat } from '../game.ts';
import { huntGame } from './hunt-game.ts';
import { THINGS, type HuntSettings, type HuntState } from './hunt-state.ts';

/** Hands in photos: what each seat's controller says, until changed. */
class HuntPlay {
  readonly state: HuntState;
  readonly settings: HuntSettings;
  readonly answers = new Map<Seat, Answer>();
  readonly away = new Set<Seat>();

  constructor(seats: readonly Seat[] = [0, 1, 2], settings: Partial<HuntSettings> = {}) {
    this.state = huntGame.start({ seats, seed: 2 });
    this.settings = { ...huntGame.settings, ...settings } as HuntSettings;
    this.pass(0.1);
  }

  get hunt(): NonNullable<HuntState['hunt']> {
    return this.state.hunt!;
  }

  pass(seconds: number): void {
    for (let step = 0; step < seconds * STEPS_PER_SECOND; step += 1) this.step();
  }

  passUntil(holds: () => boolean): void {
    for (let step = 0; !holds(); step += 1) {
      if (step > 100 * STEPS_PER_SECOND) throw new Error('not within 100 s');
      this.step();
    }
  }

  step(): void {
    huntGame.step(this.state, (seat) => this.controls(seat), this.settings);
  }

  controls(seat: Seat): Controls {
    const answer = this.answers.get(seat);
    return { ...AT_REST, isAway: this.away.has(seat), ...(answer && { answer }) };
  }

  /** @param atS when the shutter was pressed, seconds since the thing was named */
  photo(seat: Seat, atS: number, text = this.hunt.label, score = 0.8): void {
    this.answers.set(seat, { text, score, atMs: this.hunt.beganAtMs + atS * 1000 });
    this.step();
  }

  /** All find the thing in this order, and the next one begins. */
  found(...order: Seat[]): void {
    order.forEach((seat, index) => this.photo(seat, 1 + index));
    const { label } = this.hunt;
    this.passUntil(() => this.hunt.label !== label || this.state.isOver);
  }
}

describe('Photo Hunt', () => {
  it('gives 3 points to the first, 2 to the second, 1 to others, and 1 more to the best photo', () => {
    const play = new HuntPlay([0, 1, 2, 3]);
    play.photo(2, 3);
    play.photo(0, 4);
    play.photo(1, 5, undefined, 0.95);
    play.photo(3, 6);
    expect(play.state.decided?.gains).toMatchObject({
      2: { place: 1, points: 3 },
      0: { place: 2, points: 2 },
      1: { place: 3, points: 2, isBest: true },
      3: { place: 4, points: 1 },
    });
    expect(play.state.points).toEqual({ 0: 2, 1: 2, 2: 3, 3: 1 });
  });

  it('judges by the time of the shutter, not by that of the arrival', () => {
    const play = new HuntPlay([0, 1]);
    play.pass(6);
    play.photo(0, 5);
    play.photo(1, 4);
    expect(play.state.decided?.gains).toMatchObject({ 1: { place: 1 }, 0: { place: 2 } });
  });

  it('takes a photo of the last moment that arrives late, and none of after it', () => {
    const play = new HuntPlay([0, 1]);
    play.pass(30.1);
    play.photo(1, 30.05);
    play.photo(0, 29.99);
    play.passUntil(() => play.state.decided !== undefined);
    expect(Object.keys(play.state.decided!.gains)).toEqual(['0']);
  });

  it('waits for a phone that still looks at its photo when time is up, for some seconds', () => {
    const play = new HuntPlay([0, 1]);
    play.photo(0, 29, '');
    play.photo(1, 28, '');
    play.pass(31.5);
    expect(play.state.decided).toBeUndefined();
    play.photo(0, 29);
    play.passUntil(() => play.state.decided !== undefined);
    expect(play.state.decided?.gains).toMatchObject({ 0: { place: 1 } });
    expect(play.hunt.photos[1]).toBeUndefined();
  });

  it('costs a player 2 s for a wrong photo, and nothing else', () => {
    const play = new HuntPlay([0, 1]);
    play.photo(0, 2, 'bowl');
    expect(play.hunt.photos[0]).toMatchObject({ verdict: 'wrong', text: 'bowl' });
    expect(huntGame.feedback(play.state, 0)).toMatchObject({ isReady: false });
    expect(huntGame.feedback(play.state, 0).hitAt).toBeGreaterThan(0);
    play.photo(0, 3.9);
    expect(play.hunt.photos[0]!.verdict).toBe('wrong');
    play.photo(0, 4.1);
    expect(play.hunt.photos[0]!.verdict).toBe('found');
  });

  it('takes no photo that the detector is not sure of', () => {
    const play = new HuntPlay([0, 1]);
    play.photo(0, 2, undefined, 0.39);
    expect(play.hunt.photos[0]!.verdict).toBe('wrong');
  });

  it('does not count a photo of one thing for the next', () => {
    const play = new HuntPlay([0, 1], { cup: 1 });
    play.photo(0, 1);
    play.photo(1, 2);
    const { label } = play.hunt;
    play.passUntil(() => play.state.hunted.length === 2);
    play.answers.set(0, { ...play.answers.get(0)!, text: play.hunt.label });
    play.pass(1);
    expect(play.hunt.label).not.toBe(label);
    expect(play.hunt.photos).toEqual({});
  });

  it('goes on when all who are there have found it, whoever is away', () => {
    const play = new HuntPlay();
    play.away.add(2);
    play.photo(0, 1);
    expect(play.state.decided).toBeUndefined();
    play.photo(1, 2);
    expect(play.state.decided).toBeDefined();
  });

  it('does not rush when everybody is away', () => {
    const play = new HuntPlay([0]);
    play.away.add(0);
    play.pass(10);
    expect(play.state.decided).toBeUndefined();
  });

  it('lasts longer with a setting, at once', () => {
    const play = new HuntPlay([0, 1], { time: 2 });
    play.pass(50);
    expect(play.state.decided).toBeUndefined();
    expect(huntGame.feedback(play.state, 0).question?.endsAtMs).toBeCloseTo(60_000, -2);
  });

  it('names only things that were not left out, each once as long as there are others', () => {
    const off = Object.fromEntries(Object.keys(THINGS).map((id) => [id, 0]));
    const play = new HuntPlay([0, 1], { ...off, cup: 1, phone: 1 });
    for (let thing = 0; thing < 4; thing += 1) {
      const { length } = play.state.hunted;
      play.photo(0, 1);
      play.photo(1, 2);
      play.passUntil(() => play.state.hunted.length > length);
    }
    expect(play.state.hunted.slice(0, 2).sort()).toEqual(['cell phone', 'cup']);
    expect(new Set(play.state.hunted).size).toBe(2);
  });

  it('lets only those who share the first place hunt one decisive thing', () => {
    const play = new HuntPlay();
    for (const order of [
      [0, 1, 2],
      [1, 0, 2],
      [0, 1, 2],
      [1, 0, 2],
    ])
      play.found(...order);
    play.photo(2, 1, undefined, 0.9);
    play.passUntil(() => play.state.hunted.length === 6);
    // The best photos were those of the first
    expect(play.hunt.hunters).toEqual([0, 1]);
    expect(huntGame.feedback(play.state, 2)).toMatchObject({ isOut: true });
    play.photo(2, 1);
    play.photo(1, 2);
    play.passUntil(() => play.state.isOver);
    expect(huntGame.places(play.state)).toEqual([[1], [0], [2]]);
  });

  it('names each thing within the headline', () => {
    for (const { name } of Object.values(THINGS)) expect(`Find ${name}`.length).toBeLessThan(17);
  });
});
