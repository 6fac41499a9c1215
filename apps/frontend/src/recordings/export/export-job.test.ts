import { encodeRecord } from '@ubii/proto';
import { RecordingReader } from '@ubii/recording';
import { importCsv } from '@ubii/recording/import';
import { MemoryFile, recorded, SAMPLE_START_NS } from '@ubii/recording/testing';
import { strFromU8, unzipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { runExport } from './export-job.ts';
import type { ExportRequest } from './export-messages.ts';
import { openMemory } from './output.ts';

const at = (ms: number): bigint => SAMPLE_START_NS + BigInt(ms) * 1_000_000n;

/** `/lab/a` and `/lab/b` each 10 ms for a second. */
async function aRecording(): Promise<RecordingReader> {
  const records = Array.from({ length: 100 }, (_, i) =>
    ['/lab/a', '/lab/b'].map((topic) => ({
      topic,
      clientId: 'ada',
      logTimeNs: at(10 * i),
      publishTimeNs: at(10 * i),
      record: encodeRecord({ topic, format: 'double', value: i }),
    })),
  ).flat();
  return RecordingReader.open(await recorded(records));
}

async function exported(
  request: Partial<ExportRequest>,
  signal = new AbortController().signal,
  isZip?: boolean,
) {
  const file = openMemory();
  const shares: number[] = [];
  const leftOut = await runExport(
    await aRecording(),
    { format: 'csv', topics: ['/lab/a'], span: undefined, name: 'Tuesday', ...request },
    file,
    {
      signal,
      ...(isZip !== undefined && { isZip }),
      onProgress: (share) => shares.push(share),
      video: () => Promise.reject(new Error('not here')),
    },
  );
  const blob = await file.end();
  return { bytes: new Uint8Array(await blob!.arrayBuffer()), shares, leftOut };
}

const SPAN = { fromMs: 200, untilMs: 290 };

describe('an export', () => {
  it('writes one topic as a table', async () => {
    const { bytes, leftOut } = await exported({ span: SPAN });
    const rows = strFromU8(bytes).trim().split('\r\n');
    expect(rows.slice(1).map((row) => row.split(',').at(-1))).toEqual(
      ['20', '21', '22', '23', '24', '25', '26', '27', '28', '29'], // inclusive edges
    );
    expect(leftOut).toEqual([]);
  });

  it('puts several tables into a ZIP', async () => {
    const { bytes } = await exported({ topics: ['/lab/a', '/lab/b'], span: SPAN });
    const files = unzipSync(bytes);
    expect(Object.keys(files)).toEqual(['lab-a.csv', 'lab-b.csv']);
    const again = new MemoryFile();
    const options = { name: 'Again', version: '' };
    const table = new MemoryFile(files['lab-b.csv']);
    expect(await importCsv(table, again, options)).toMatchObject({ records: 10 });
  });

  it('is a ZIP also where labels left one of several topics', async () => {
    const { bytes } = await exported({}, undefined, true);
    expect(Object.keys(unzipSync(bytes))).toEqual(['lab-a.csv']);
  });

  it('writes a part as a recording of its own', async () => {
    const { bytes } = await exported({ format: 'mcap', span: SPAN });
    const { summary } = await RecordingReader.open(new MemoryFile(bytes));
    expect(summary).toMatchObject({ startNs: at(200), endNs: at(290), name: 'Tuesday' });
    expect(summary.topics.map(({ topic }) => topic)).toEqual(['/lab/a']);
  });

  it('ends with the reason when it is cancelled', async () => {
    const signal = AbortSignal.abort(new Error('Cancelled.'));
    for (const format of ['csv', 'parquet', 'xdf', 'mcap'] as const)
      await expect(exported({ format }, signal)).rejects.toThrow('Cancelled.');
  });
});

it('a file in memory has a limit, which is told', async () => {
  const file = openMemory(2 * 1024 ** 2);
  await file.write(new Uint8Array(1024 ** 2));
  await expect(file.write(new Uint8Array(1024 ** 2 + 1))).rejects.toThrow(
    'The file has more than 2 MB, which this browser would keep in memory.',
  );
});
