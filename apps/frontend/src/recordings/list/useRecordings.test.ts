import type { Recording } from '@ubii/proto';
import { expect, it } from 'vitest';
import { withRunning } from './useRecordings.ts';

const aRecording = (id: string, durationMs: number): Recording => ({ id, durationMs }) as Recording;

it('what runs is shown as it is now, without recordings of others', () => {
  const list = [aRecording('b', 10), aRecording('a', 500)];
  const running = [aRecording('c', 1), aRecording('b', 20)];
  expect(withRunning(list, running).map(({ id, durationMs }) => [id, durationMs])).toEqual([
    ['b', 20],
    ['a', 500],
  ]);
});

it('what runs has the name of the list, which the status leaves out in studies', () => {
  const study = { participantCode: 'P01' };
  const list = [{ ...aRecording('a', 10), name: 'sub-P01', study }] as Recording[];
  const running = [{ ...aRecording('a', 20), name: 'Touch, block 1', study: undefined }];
  expect(withRunning(list, running)).toEqual([{ id: 'a', durationMs: 20, name: 'sub-P01', study }]);
});
