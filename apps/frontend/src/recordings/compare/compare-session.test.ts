import { RecordingReader } from '@ubii/recording';
import { recorded, sampleRecord } from '@ubii/recording/testing';
import { expect, it } from 'vitest';
import { compareSession } from './compare-session.ts';

type Values = Readonly<Record<string, readonly (readonly [number, number])[]>>;
async function readerOf(values: Values) {
  const records = Object.entries(values)
    .flatMap(([topic, all]) => all.map(([atMs, value]) => sampleRecord(topic, atMs, value)))
    .sort((a, b) => Number(a.logTimeNs - b.logTimeNs));
  return RecordingReader.open(await recorded(records));
}
const REQUEST = {
  inputPrefix: '/replays/1/in',
  outputPrefix: '/replays/1/out',
  outputs: ['/sum', '/never'],
  span: undefined,
};
const INPUTS = [
  [0, 0],
  [500, 1],
  [1000, 2],
] as const;

it('compares the outputs of a session and those that only the run wrote, with times of the recording', async () => {
  const before = await readerOf({
    '/angle': INPUTS,
    '/other': [[20, 1]],
    '/sum': [
      [1, 0],
      [501, 1],
      [1001, 3],
    ],
  });
  // The run began 2 s later, and plays twice as fast.
  const today = await readerOf({
    '/replays/1/in/angle': INPUTS.map(([atMs, value]) => [2000 + atMs / 2, value]),
    '/replays/1/out/sum': [
      [2001, 0],
      [2251, 1],
      [2501, 4],
    ],
    '/replays/1/out/debug': [
      [2001, 7],
      [2002, 8],
    ],
  });
  const { topics, differences } = await compareSession(before, today, REQUEST, () => undefined);
  const none = { same: 0, different: 0, missing: 0, additional: 0 };
  // Another value says more of a module than outputs that only one side has.
  expect(topics).toEqual([
    { ...none, topic: '/sum', same: 2, different: 1 },
    { ...none, topic: '/debug', additional: 2 },
  ]);
  expect(differences).toEqual([
    ...[{ kind: 'additional', topic: '/debug', path: '', timeMs: 1, today: '7.00' }],
    { kind: 'additional', topic: '/debug', path: '', timeMs: 2, today: '8.00' },
    { kind: 'different', topic: '/sum', path: '', timeMs: 1001, recorded: '3.00', today: '4.00' },
  ]);
});
