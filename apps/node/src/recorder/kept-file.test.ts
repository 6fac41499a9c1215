import { ServiceError } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import { keptFile } from './kept-file.ts';

const KEPT = { makerId: 'm' } as Awaited<ReturnType<typeof keptFile>>;

/** A recorder that is away for some requests. */
function recorderAwayFor(requests: number, code: 'unavailable' | 'not_found' = 'unavailable') {
  let left = requests;
  return {
    get: () => (left-- > 0 ? Promise.reject(new ServiceError(code, 'No.')) : Promise.resolve(KEPT)),
  };
}

it('[RC-63] a file is uploaded when the recorder that failed is there again', async () => {
  const clock = new FakeClock();
  const kept = keptFile(recorderAwayFor(5), 'a', clock, new AbortController().signal);
  await clock.advance(5_000);
  expect(await kept).toBe(KEPT);
});

it('a file is not waited for when there is none, when it takes too long, or when the node ends', async () => {
  const clock = new FakeClock();
  const { signal } = new AbortController();
  await expect(keptFile(recorderAwayFor(1, 'not_found'), 'a', clock, signal)).rejects.toThrow(
    'No.',
  );
  const late = expect(keptFile(recorderAwayFor(100), 'a', clock, signal)).rejects.toThrow('No.');
  await clock.advance(20_000);
  await late;
  const ended = AbortSignal.abort(new Error('The node ends.'));
  await expect(keptFile(recorderAwayFor(1), 'a', clock, ended)).rejects.toThrow('The node ends.');
});
