import { expect, it } from 'vitest';
import { RecordingError } from '../records/recording-error.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { recorded } from '../testing/recorded.ts';
import { sampleRecord } from '../testing/sample-records.ts';
import { BlobSource, RangeSource } from './sources.ts';

const RECORDS = [sampleRecord('/a', 0), sampleRecord('/b', 10)];

/** A server for one file, which answers as HTTP says. */
function server(bytes: Uint8Array<ArrayBuffer>) {
  const state = { etag: '"1"', status: 206, ranges: 0 };
  const answer = (_url: string, init: RequestInit): Promise<Response> => {
    const headers = { ETag: state.etag, 'Content-Length': String(bytes.length) };
    if (init.method === 'HEAD') return Promise.resolve(new Response(null, { headers }));
    state.ranges += 1;
    const range = new Headers(init.headers).get('Range')!;
    const [from, until] = range.slice('bytes='.length).split('-').map(Number);
    const body = bytes.slice(from, until! + 1);
    return Promise.resolve(
      new Response(body, { status: state.status, headers: { ETag: state.etag } }),
    );
  };
  return { state, answer };
}

it('reads a recording from a Blob', async () => {
  const { bytes } = await recorded(RECORDS);
  const source = new BlobSource(new Blob([bytes]));
  expect((await RecordingReader.open(source)).summary.records).toBe(2);
  await expect(source.read(BigInt(bytes.length) - 1n, 2n)).rejects.toThrow(RecordingError);
});

it('reads a recording from a server by ranges', async () => {
  const { answer } = server((await recorded(RECORDS)).bytes);
  const reader = await RecordingReader.open(new RangeSource('/recordings/1.mcap', answer));
  expect((await reader.latestAt(reader.summary.endNs)).get('/b')).toEqual(RECORDS[1]);
});

it('reads what lies together with one request', async () => {
  const { bytes } = await recorded(RECORDS);
  const { answer, state } = server(bytes);
  const source = new RangeSource('/recordings/1.mcap', answer);
  for (const [from, length] of [
    [0, 8],
    [8, 40],
    [100, 4096],
  ] as const) {
    const part = await source.read(BigInt(from), BigInt(length));
    expect(part).toEqual(bytes.subarray(from, from + length));
  }
  expect(state.ranges).toBe(1);
});

it('tells when the file was changed or the server refuses', async () => {
  const { answer, state } = server((await recorded(RECORDS)).bytes);
  const source = new RangeSource('/recordings/1.mcap', answer);
  await source.size();
  state.etag = '"2"';
  await expect(source.read(0n, 8n)).rejects.toThrow('was changed');
  state.status = 403;
  await expect(source.read(0n, 8n)).rejects.toThrow('403');
  await expect(source.read(0n, 0n)).resolves.toHaveLength(0);
});
