import { fromJson, type StudyCheckList } from '@ubii/proto';
import { expect, it } from 'vitest';
import { aRun } from '../testing/a-study.ts';
import { adviceOf, blockTitle, checkSentence, isAbsent, runSummary } from './run-words.ts';

const aList = (rows: readonly object[]): StudyCheckList =>
  fromJson('ubii.extension.StudyCheckList', { studyId: 'study', rows });
const row = (name: string, state: number, items: readonly object[] = []) => ({
  name,
  state,
  items,
});

it('the check list is one sentence that names what is not ready, without values', () => {
  expect(checkSentence(aList([]))).toBe('This study requires no device.');
  expect(checkSentence(aList([row('Phone', 0), row('Band', 0)]))).toBe('All devices are ready.');
  const text = '12 of 30 Hz';
  const rows = [row('Phone', 1), row('Band', 2, [{ kind: 1, state: 2, text }]), row('Cam', 0)];
  expect(checkSentence(aList(rows))).toBe('Not ready: Phone (missing), Band (too low).');
});

it('advice is about the first requirement that is not fulfilled', () => {
  const advice = (items: readonly object[]) => adviceOf(aList([row('Phone', 1, items)]).rows[0]!);
  expect(advice([{ kind: 0, state: 0 }])).toBeUndefined();
  expect(advice([{ kind: 0, state: 1 }])).toContain('Connect the device');
  expect(
    advice([
      { kind: 0, state: 0 },
      { kind: 2, state: 2 },
    ]),
  ).toBe('Charge the device.');
  expect(advice([{ kind: 2, state: 1 }])).toContain('does not report its battery');
  expect(isAbsent(aList([row('Phone', 2, [{ kind: 1, state: 2 }])]).rows[0]!)).toBe(false);
  expect(isAbsent(aList([row('Phone', 1, [{ kind: 0, state: 1 }])]).rows[0]!)).toBe(true);
});

it('a block names its repetition only in runs that repeat conditions', () => {
  const once = aRun([0, 0]);
  expect(blockTitle(once.blocks[0]!, once)).toBe('Condition 1');
  const blocks = [1, 2].map((repetition) => ({ condition: 'Tap', repetition }));
  const twice = aRun([], { blocks });
  expect(blockTitle(twice.blocks[0]!, twice)).toBe('Tap, repetition 1');
});

it('a run is summed up by its blocks and recordings', () => {
  const takes = [{ recordingId: 'a' }, { recordingId: 'b' }];
  const blocks = [{ state: 2, takes }, { state: 3 }, { state: 0 }];
  expect(runSummary(aRun([], { blocks }))).toBe('1 of 3 blocks done, 1 skipped, 2 recordings.');
  expect(runSummary(aRun([2]))).toBe('1 of 1 block done, 0 recordings.');
});
