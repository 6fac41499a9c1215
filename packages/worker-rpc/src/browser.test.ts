import { expect, it } from 'vitest';
import { callWorker } from './browser.ts';

/** A worker that replies to nothing. */
function aWorker() {
  const posted: { message: unknown; transfer: unknown }[] = [];
  const state = { isTerminated: false };
  const worker = {
    onmessage: null,
    onerror: null as ((event: { message: string }) => void) | null,
    postMessage: (message: unknown, transfer: unknown) => void posted.push({ message, transfer }),
    terminate: () => void (state.isTerminated = true),
  };
  return { worker, peerOf: worker as unknown as Worker, posted, state };
}

interface Reader {
  read(path: string): Promise<string>;
}

it('calls of a worker that fails reject with a sentence, also later ones', async () => {
  const { worker, peerOf } = aWorker();
  const { calls } = callWorker<Reader>(peerOf, {}, 'This browser cannot read files.');
  const read = calls.read('a');
  worker.onerror!({ message: '' });
  await expect(read).rejects.toThrow('This browser cannot read files.');
  await expect(calls.read('b')).rejects.toThrow('This browser cannot read files.');
});

it('the sentence may have the message of the browser', async () => {
  const { worker, peerOf } = aWorker();
  const { calls } = callWorker<Reader>(peerOf, {}, (message) => `It failed: ${message}.`);
  const read = calls.read('a');
  worker.onerror!({ message: 'out of memory' });
  await expect(read).rejects.toThrow('It failed: out of memory.');
});

it('close ends the worker', () => {
  const { peerOf, posted, state } = aWorker();
  const { calls, close } = callWorker<Reader>(peerOf, {}, 'Failed.');
  void calls.read('a');
  expect(posted).toMatchObject([{ message: { m: 'read', a: ['a'] }, transfer: [] }]);
  close();
  expect(state.isTerminated).toBe(true);
});
