import { MessageChannel, type MessagePort, type Transferable } from 'node:worker_threads';
import { ServiceError } from '@ubii/proto';
import { expect, it, onTestFinished } from 'vitest';
import { connectPeer, transfer, type Channel, type PeerOptions } from './peer.ts';

function channelOf(port: MessagePort): Channel {
  return {
    post: (message, list) => port.postMessage(message, list as Transferable[]),
    receive: (handle) => void port.on('message', handle),
  };
}

/** A side with these functions, and one that calls them. */
function connected<Functions extends object>(functions: Functions, options?: PeerOptions) {
  const { port1, port2 } = new MessageChannel();
  onTestFinished(() => port1.close());
  connectPeer(functions, channelOf(port2), options);
  return connectPeer<Functions>({}, channelOf(port1));
}

it('calls start in order, and each gets its reply', async () => {
  const started: number[] = [];
  const { calls } = connected({
    async double(value: number) {
      started.push(value);
      await new Promise<void>((resolve) => void setTimeout(resolve, value === 1 ? 5 : 0));
      return 2 * value;
    },
  });
  expect(await Promise.all([1, 2, 3].map((value) => calls.double(value)))).toEqual([2, 4, 6]);
  expect(started).toEqual([1, 2, 3]);
});

it('both sides can call: progress comes before the reply', async () => {
  const { port1, port2 } = new MessageChannel();
  onTestFinished(() => port1.close());
  const seen: string[] = [];
  const page = { progress: (share: number) => void seen.push(`progress ${share}`) };
  const worker = {
    async run(): Promise<string> {
      void ofPage.calls.progress(0.5);
      return 'done';
    },
  };
  const ofPage = connectPeer<typeof page>(worker, channelOf(port2));
  const ofWorker = connectPeer<typeof worker>(page, channelOf(port1));
  seen.push(await ofWorker.calls.run());
  expect(seen).toEqual(['progress 0.5', 'done']);
});

it('transfers what is marked, as an argument and as a result, and copies the rest', async () => {
  const { calls } = connected({
    async echo(bytes: ArrayBuffer) {
      return transfer(bytes);
    },
  });
  const copied = new ArrayBuffer(8);
  expect((await calls.echo(copied)).byteLength).toBe(8);
  expect(copied.byteLength).toBe(8);
  const given = new ArrayBuffer(16);
  expect((await calls.echo(transfer(given))).byteLength).toBe(16);
  expect(given.byteLength).toBe(0);
});

it('errors keep class, code, details and cause', async () => {
  const { calls } = connected({
    refuse() {
      const details = { reason: 'full' };
      throw new ServiceError('resource_exhausted', 'No room.', { details, cause: 'disk' });
    },
    fail: () => Promise.reject(new RangeError('Too far.')),
    failWithText: () => Promise.reject('text' as unknown as Error),
  });
  const refused = await calls.refuse().catch((error: unknown) => error);
  expect(refused).toBeInstanceOf(ServiceError);
  expect(refused).toMatchObject({
    code: 'resource_exhausted',
    message: 'No room.',
    details: { reason: 'full' },
    cause: 'disk',
  });
  await expect(calls.fail()).rejects.toMatchObject({ name: 'RangeError', message: 'Too far.' });
  await expect(calls.failWithText()).rejects.toThrow('text');
});

it('errors are converted by the side that throws them', async () => {
  const { calls } = connected(
    { fail: () => Promise.reject(new Error('secret')) },
    {
      asError: ServiceError.from,
    },
  );
  await expect(calls.fail()).rejects.toMatchObject({ code: 'internal', cause: 'Error: secret' });
});

it('what cannot be copied rejects the call', async () => {
  const { calls } = connected({ take: (value: unknown) => value, give: () => () => undefined });
  await expect(calls.take(() => undefined)).rejects.toThrow('could not be cloned');
  await expect(calls.give()).rejects.toThrow('could not be cloned');
});

it('close rejects calls without a reply and later ones', async () => {
  const peer = connected({ wait: () => new Promise<void>(() => undefined) });
  const waiting = peer.calls.wait();
  peer.close(new Error('The worker failed.'));
  await expect(waiting).rejects.toThrow('The worker failed.');
  await expect(peer.calls.wait()).rejects.toThrow('The worker failed.');
});

it('calls of a connection can be the result of a promise', async () => {
  const { calls } = connected({ one: () => 1 });
  expect(await (await Promise.resolve(calls)).one()).toBe(1);
});
