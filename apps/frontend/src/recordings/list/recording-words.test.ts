import { RecordingState, type Recording } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  emptySentence,
  estimateSentence,
  findRecordings,
  formatWhen,
  placeSentence,
  recordingLook,
  sortRecordings,
  unknownSentence,
} from './recording-words.ts';

const aRecording = (changes: Partial<Recording>): Recording =>
  ({
    name: '',
    notes: '',
    author: '',
    lostCount: 0,
    state: RecordingState.RECORDING_STATE_COMPLETE,
    ...changes,
  }) as Recording;

const at = (day: number, hour: number): number => new Date(2026, 10, day, hour, 2).getTime();

describe('when a recording was made', () => {
  it.each([
    [26, 'today 14:02'],
    [25, 'yesterday 14:02'],
    [23, 'Monday 14:02'],
    [2, '2 Nov 2026 14:02'],
  ])('on day %i is "%s"', (day, text) => {
    expect(formatWhen(at(day, 14), at(26, 20))).toBe(text);
  });
});

it('a recording says what is wrong with it, and nothing when it is whole', () => {
  expect(recordingLook(aRecording({}))).toBeUndefined();
  const repaired = aRecording({ state: RecordingState.RECORDING_STATE_REPAIRED });
  expect(recordingLook(repaired)).toEqual({ mark: 'warning', word: 'Repaired' });
  const failed = aRecording({ state: RecordingState.RECORDING_STATE_FAILED });
  expect(recordingLook(failed)?.word).toBe('Stopped early');
  const rejected = aRecording({ state: RecordingState.RECORDING_STATE_REJECTED });
  expect(recordingLook(rejected)?.word).toBe('Cannot be read');
  expect(recordingLook(aRecording({ lostCount: 1 }))?.word).toBe('1 record missing');
});

it('[RC-63] [RC-64] a recording of a node says where it is', () => {
  const at = {
    nodeName: 'kitchen',
    nodeIsAway: false,
    problem: '',
    uploadedBytes: 0,
    sizeBytes: 200,
  };
  const there = aRecording({ ...at, state: RecordingState.RECORDING_STATE_AT_NODE });
  expect(recordingLook(there)?.word).toBe('Uploading from kitchen');
  expect(placeSentence({ ...there, uploadedBytes: 50 })).toContain('25 % of it is uploaded');
  expect(recordingLook({ ...there, problem: 'No room.' })?.word).toBe('On kitchen');
  expect(placeSentence({ ...there, nodeIsAway: true })).toMatch(/uploaded when it returns/);
  const running = aRecording({ ...at, state: RecordingState.RECORDING_STATE_RECORDING });
  expect(recordingLook(running)).toBeUndefined();
  expect(recordingLook({ ...running, nodeIsAway: true })?.word).toBe('kitchen is away');
});

it('recordings are found by words of name, notes and author', () => {
  const all = [
    aRecording({ name: 'Gesture study, P07', author: 'Mara' }),
    aRecording({ name: 'Party', notes: '24 phones' }),
  ];
  expect(findRecordings(all, 'mara gesture')).toEqual([all[0]]);
  expect(findRecordings(all, 'PHONES')).toEqual([all[1]]);
  expect(findRecordings(all, ' ')).toEqual(all);
});

it('an estimate says rate, size and how long the disk lasts', () => {
  expect(estimateSentence(1842, 2e6, 7.2e9)).toBe(
    '1842 records and 2.0 MB per second before compression. The disk has room for at least 1:00:00.',
  );
  // The free space is that of the master, and a node writes to its own disk.
  expect(estimateSentence(1842, 2e6, 7.2e9, 'Lab PC')).toBe(
    '1842 records and 2.0 MB per second before compression. The recording stops before the disk of Lab PC is full.',
  );
  expect(estimateSentence(0, 0, 1e9)).toMatch(/^Nothing that was selected/);
  expect(estimateSentence(1, 10, 1e12)).toMatch(/more than two days\.$/);
});

it('an empty list and an unknown address tell all but admins that there may be recordings of others', () => {
  const others = 'Recordings of others are shown to admins only.';
  expect([emptySentence(true, false), unknownSentence(false)].join(' ')).not.toContain(others);
  expect(emptySentence(true, true)).toContain(others);
  expect(emptySentence(false, true)).toContain(others);
  expect(unknownSentence(true)).toContain(others);
});

it('the list is sorted by name with its numbers, by length and by size', () => {
  const all = [
    aRecording({ name: 'P10', durationMs: 1, sizeBytes: 20 }),
    aRecording({ name: 'P9', durationMs: 3, sizeBytes: 10 }),
    aRecording({ name: 'P7', durationMs: 2, sizeBytes: 30 }),
  ];
  const names = (order: Parameters<typeof sortRecordings>[1]) =>
    sortRecordings(all, order).map(({ name }) => name);
  expect(names('newest')).toEqual(['P10', 'P9', 'P7']);
  expect(names('name')).toEqual(['P7', 'P9', 'P10']);
  expect(names('longest')).toEqual(['P9', 'P7', 'P10']);
  expect(names('largest')).toEqual(['P7', 'P10', 'P9']);
});
