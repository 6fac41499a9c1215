import { describe, expect, it } from 'vitest';
import type { HuntState } from '../sim/index.ts';
import { playRound, type Playing, type RoundInputs } from './play-round.ts';
import { readAnswer, type AnswerRecord } from './phone-input.ts';

const STARTS_AT_MS = 1_800_000_000_000;
const DELAY = { leastMs: 5, mostMs: 20 };

const record = (id: string, data: unknown, area?: readonly number[]): AnswerRecord => ({
  object2D: {
    id,
    userDataJson: typeof data === 'string' ? data : JSON.stringify(data),
    ...(area && {
      pose: { position: { x: area[0]!, y: area[1]! } },
      size: { x: area[2]!, y: area[3]! },
    }),
  },
});

describe('an answer', () => {
  const nowMs = STARTS_AT_MS + 5000;
  const read = (one: AnswerRecord | undefined) => readAnswer(one, nowMs, STARTS_AT_MS);
  const atMs = nowMs - 1000;

  it('is read, with its time since the start of the round', () => {
    const area = { x: 0.25, y: 0.5, width: 0.5, height: 0.25 };
    expect(read(record('cell phone', { score: 0.5, atMs }, [0.25, 0.5, 0.5, 0.25]))).toEqual({
      text: 'cell phone',
      score: 0.5,
      atMs: 4000,
      area,
    });
  });

  it('may be empty while the phone looks', () => {
    expect(read(record('', { score: 0, atMs }))).toEqual({ text: '', score: 0, atMs: 4000 });
  });

  it.each([
    ['is missing', undefined],
    ['has no object', {}],
    ['has no data', record('cup', '')],
    ['has data that is no JSON', record('cup', '{"score":')],
    ['has data that is no object', record('cup', 'null')],
    ['has a score of text', record('cup', { score: '1', atMs })],
    ['is surer than sure', record('cup', { score: 1.01, atMs })],
    ['is less sure than not at all', record('cup', { score: -0.1, atMs })],
    ['has no time', record('cup', { score: 1 })],
    ['is of the future', record('cup', { score: 1, atMs: nowMs + 2001 })],
    ['is of long ago', record('cup', { score: 1, atMs: nowMs - 10_000 })],
    ['has an infinite time', record('cup', '{"score":1,"atMs":1e999}')],
    ['has a long text', record('cup '.repeat(8), { score: 1, atMs })],
    ['has markup as a text', record('<b>cup</b>', { score: 1, atMs })],
    ['has long data', record('cup', { score: 1, atMs, more: 'x'.repeat(200) })],
  ])('is none when it %s', (_what, one) => {
    expect(read(one)).toBeUndefined();
  });

  it.each([
    [[0.5, 0.5, 0.6, 0.1]],
    [[-0.1, 0, 0.5, 0.5]],
    [[0, 0, 0, 0]],
    [[Number.NaN, 0, 1, 1]],
    [[0, 0, 1e300, 1]],
  ])('has no place outside of the picture: %j', (area) => {
    const answer = read(record('cup', { score: 1, atMs }, area));
    expect(answer?.text).toBe('cup');
    expect(answer?.area).toBeUndefined();
  });
});

describe('a hunt that a module plays', () => {
  const round = JSON.stringify({
    id: 'a',
    game: 'hunt',
    seed: 3,
    seats: [0, 1],
    startsAtMs: STARTS_AT_MS,
  });
  const seats = (clients: object): string => JSON.stringify({ clients, bots: [] });

  function play(playing: Playing, inputs: RoundInputs, atS: number): HuntState | undefined {
    playRound('hunt', inputs, playing, STARTS_AT_MS + atS * 1000);
    return playing.state as HuntState | undefined;
  }

  it('takes the answers of those who have a seat, each for the own one', () => {
    const playing: Playing = {};
    const inputs = { round: { string: round }, seats: { string: seats({ 0: 'mara', 1: 'theo' }) } };
    const { label } = play(playing, inputs, 0.2)!.hunt!;
    const answer = { ...record(label, { score: 0.9, atMs: STARTS_AT_MS + 300 }) };
    const elements = [
      { ...answer, identity: 'stranger' },
      { ...answer, identity: 'theo' },
    ];
    const state = play(playing, { ...inputs, answers: { elements } }, 0.4)!;
    expect(Object.keys(state.hunt!.photos)).toEqual(['1']);
    expect(state.hunt!.photos[1]).toMatchObject({ verdict: 'found', atMs: 300 });
  });

  it('judges a photo by its first record, and keeps the time that the phone said', () => {
    const playing: Playing = {};
    const told = JSON.stringify({ clients: { 0: 'mara' }, bots: [], delays: { 0: DELAY } });
    const inputs = { round: { string: round }, seats: { string: told } };
    const { label } = play(playing, inputs, 0.2)!.hunt!;
    const claimedMs = STARTS_AT_MS + 500;
    const take = (id: string, receivedMs: number): HuntState => {
      const answer = { ...record(id, { score: 0.9, atMs: claimedMs }), identity: 'mara' };
      const elements = [{ ...answer, receivedAtMs: STARTS_AT_MS + receivedMs }];
      return play(playing, { ...inputs, answers: { elements } }, (receivedMs + 10) / 1000)!;
    };
    take('', 900);
    const { photos } = take(label, 1500).hunt!;
    expect(photos[0]).toMatchObject({ verdict: 'found', atMs: 880, claimedAtMs: 500 });
  });

  it('does not wait for players who are away', () => {
    const playing: Playing = {};
    const inputs = { round: { string: round }, seats: { string: seats({ 1: 'theo' }) } };
    const { label } = play(playing, inputs, 0.2)!.hunt!;
    const answer = { ...record(label, { score: 0.9, atMs: STARTS_AT_MS + 300 }), identity: 'theo' };
    const state = play(playing, { ...inputs, answers: { elements: [answer] } }, 0.4)!;
    expect(state.decided?.gains).toMatchObject({ 1: { place: 1, points: 4 } });
  });
});
