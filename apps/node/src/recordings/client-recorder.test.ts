import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import { encodeRecord } from '@ubii/proto';
import { RecordingWriter } from '@ubii/recording';
import { MemoryFile, SAMPLE_HEADER } from '@ubii/recording/testing';
import { expect, it, vi } from 'vitest';
import { ClientRecorder } from './client-recorder.ts';

type Receive = (record: Partial<EncodedRecord>) => void;

/** A recorder of a client whose requests the test answers, and what the client receives. */
async function recording(answer: () => Promise<{ elements: object[] }>) {
  const call = vi.fn(answer);
  call.mockResolvedValueOnce({ elements: [] }).mockResolvedValueOnce({ elements: [] });
  let receive: Receive = () => undefined;
  const client = {
    call,
    masterTime: { nowMs: () => 1_750_000_000_000 },
    subscribeEncoded: (_: unknown, { onRecord }: { onRecord: Receive }) => {
      receive = onRecord;
      return () => undefined;
    },
  } as unknown as UbiiClient;
  const writer = await RecordingWriter.create(new MemoryFile(), SAMPLE_HEADER);
  const recorder = new ClientRecorder(client, writer, {
    ...{ patterns: ['/**'], isChosen: () => true, withImages: true, onProgress: () => undefined },
    ...{ maxMs: Infinity, maxBytes: Infinity },
  });
  const stop = new AbortController();
  const ended = recorder.run(stop.signal);
  await vi.waitFor(() => expect(call).toHaveBeenCalledTimes(2));
  await Promise.resolve();
  const publish = (publisherId: string): void => {
    const bytes = encodeRecord({ topic: '/a', format: 'double', value: 1 });
    receive({ topic: '/a', bytes, publisherId });
  };
  return { call, writer, publish, stop: () => (stop.abort(), ended) };
}

it('looks up a publisher that is no client once', async () => {
  const { call, writer, publish, stop } = await recording(() => Promise.resolve({ elements: [] }));
  await vi.waitFor(() => {
    publish('the master');
    expect(writer.statistics.records).toBeGreaterThan(2);
  });
  expect(call).toHaveBeenCalledTimes(3);
  await stop();
});

it('records on and ends well when a publisher cannot be looked up', async () => {
  const { writer, publish, stop } = await recording(() => Promise.reject(new Error('closed')));
  await vi.waitFor(() => {
    publish('ada');
    expect(writer.statistics.records).toBeGreaterThan(0);
  });
  expect(await stop()).toBe('Stopped');
});
