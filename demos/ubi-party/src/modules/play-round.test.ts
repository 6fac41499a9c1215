import { beforeEach, describe, expect, it } from 'vitest';
import type { DuelState, HillState } from '../sim/index.ts';
import { playRound, type Playing, type RoundInputs } from './play-round.ts';
import type { RoundPlan, RoundSeats, RoundState } from './round.ts';

const STARTS = 1_000_000;
const plan: RoundPlan = { id: 'r', game: 'hill', seed: 3, seats: [0, 1], startsAtMs: STARTS };
const seats: RoundSeats = { clients: { 0: 'mara', 1: 'theo' }, bots: [] };
const text = (value: unknown): { string: string } => ({ string: JSON.stringify(value) });
const inputs = (more: Partial<RoundInputs> = {}): RoundInputs => ({
  round: text(plan),
  seats: text(seats),
  ...more,
});

let playing: Playing;
beforeEach(() => (playing = {}));

function run<State>(
  game: 'hill' | 'duel',
  atMs: number,
  given = inputs(),
): RoundState<State> | undefined {
  const round = game === 'hill' ? given.round : text({ ...plan, game });
  const outputs = playRound(game, { ...given, round }, playing, STARTS + atMs)?.outputs;
  return outputs?.state && (JSON.parse(outputs.state.string) as RoundState<State>);
}

describe('a run of a module that plays a game', () => {
  it('makes the steps that are due, and none before the start', () => {
    expect(run('hill', -500)).toBeUndefined();
    expect(run('hill', 50)?.step).toBe(3);
    expect(run('hill', 50)).toBeUndefined();
  });

  it('leaves the plan of another game alone, which is there when its session starts', () => {
    const outputs = playRound('duel', inputs(), playing, STARTS + 50);
    expect(outputs).toBeUndefined();
  });

  it('catches up after it was held up, a few steps at a time', () => {
    expect(run('hill', 2000)?.step).toBe(12);
    expect(run('hill', 2000)?.step).toBe(24);
  });

  it('moves the piece of whose client steers, and no other', () => {
    const sticks = { elements: [{ identity: 'mara', vector2: { x: 1, y: 0 } }] };
    const [before] = run<HillState>('hill', 17)!.state.pieces;
    const after = run<HillState>('hill', 200, inputs({ sticks }))!.state.pieces;
    expect(after[0]!.velocity.x).toBeGreaterThan(before!.velocity.x);
    expect(after[1]!.velocity).toEqual({ x: 0, y: 0 });
  });

  it('takes a tap that was over before the step for a press', () => {
    const pressed = { elements: [{ identity: 'theo', double: STARTS + 10 }] };
    run('hill', 17, inputs({ pressed }));
    const buttons = { elements: [{ identity: 'theo', bool: false }] };
    const { pieces } = run<HillState>('hill', 60, inputs({ pressed, buttons }))!.state;
    expect(pieces[1]!.dashReadyAt).toBeGreaterThan(0);
  });

  describe('judges a press', () => {
    const delays = { 0: { leastMs: 71, mostMs: 110 }, 1: { leastMs: 0, mostMs: 7 } };
    const told = text({ ...seats, delays });
    const press = (identity: string, agoMs: number, arrivedMs: number) => ({
      identity,
      double: STARTS + arrivedMs - agoMs,
      receivedAtMs: STARTS + arrivedMs,
    });
    const judged = (elements: readonly object[], atMs = 100): Record<number, number> =>
      run<DuelState>('duel', atMs, inputs({ seats: told, pressed: { elements } as never }))!.state
        .bout.presses;

    it('by when an honest phone says it was, also of a packet that is late', () => {
      expect(judged([press('mara', 75, 95)])).toEqual({ 0: 20 });
      playing = {};
      expect(judged([press('mara', 110, 140)], 150)).toEqual({ 0: 30 });
    });

    it('by its arrival, less what the line takes at most, when a phone claims more', () => {
      expect(judged([press('theo', 400, 90)])).toEqual({ 1: 83 });
    });

    it('by its arrival, less what the line takes at least, when a clock is ahead', () => {
      expect(judged([press('mara', -150, 95)])).toEqual({ 0: 24 });
    });
  });

  it.each([
    ['in the future', 5000],
    ['long past', -60_000],
    ['no number', Number.NaN],
  ])('takes no press that is %s', (_what, atMs) => {
    const pressed = { elements: [{ identity: 'mara', double: STARTS + atMs }] };
    const { bout } = run<DuelState>('duel', 100, inputs({ pressed }))!.state;
    expect(bout.presses).toEqual({});
  });

  it('has numbers of phones and settings within bounds', () => {
    const sticks = { elements: [{ identity: 'mara', vector2: { x: 1e300, y: Number.NaN } }] };
    const wild = inputs({ sticks, speed: { double: Infinity }, push: { double: -4 } });
    let last: RoundState | undefined;
    for (let ms = 17; ms < 3500; ms += 17) last = run('hill', ms, wild) ?? last;
    expect(last!.step).toBeGreaterThan(10);
    expect(JSON.stringify(last)).not.toContain('null');
  });

  it.each([
    ['text', 'no JSON'],
    ['nothing', '{}'],
    ['seats twice', JSON.stringify({ ...plan, id: 'x', seats: [1, 1] })],
    ['a seat that is none', JSON.stringify({ ...plan, id: 'x', seats: [0, 99] })],
    ['a start that is none', JSON.stringify({ ...plan, id: 'x', startsAtMs: 'now' })],
    ['a state that is none', JSON.stringify({ ...plan, id: 'x', resume: { step: 1.5 } })],
  ])('plays on when somebody tells a plan that is %s', (_what, string) => {
    run('hill', 17);
    expect(run('hill', 100, { ...inputs(), round: { string } })?.id).toBe('r');
  });

  it('goes on from the state that it is given', () => {
    const { state, step } = run<HillState>('hill', 170)!;
    const resume = { state, step };
    const startsAtMs = STARTS - 1000;
    playing = {};
    const next = { ...inputs(), round: text({ ...plan, id: 'again', startsAtMs, resume }) };
    expect(run('hill', 0, next)?.step).toBeGreaterThan(step);
  });

  it('says nothing more when the round is over', () => {
    let last: RoundState | undefined;
    for (let ms = 0; ms < 120_000; ms += 100) last = run('hill', ms) ?? last;
    expect(last?.isOver).toBe(true);
    expect(run('hill', 130_000)).toBeUndefined();
  });

  it('tells each phone at most ten times a second how its player stands, and at once of a hit', () => {
    let told = 0;
    for (let ms = 17; ms <= 1017; ms += 17) {
      const { outputs } = playRound('hill', inputs(), playing, STARTS + ms) ?? { outputs: {} };
      told += outputs.feedback?.elements.length ?? 0;
    }
    expect(told).toBeLessThanOrEqual(2 * 11);
    expect(told).toBeGreaterThan(0);
  });
});
