import { BlobSource } from '@ubii/recording/browser';
import {
  importCsv,
  importXdf,
  previewCsv,
  previewXdf,
  type CsvOptions,
} from '@ubii/recording/import';
import { sentenceOf } from '../reading/recording-desk.ts';
import {
  nameOfFile,
  type ImportChoice,
  type ImportCommand,
  type ImportPlan,
  type ImportReport,
} from './import-messages.ts';
import { openMemory } from './output.ts';

/** Makes a recording of a file of another format, beside the page. */
const tell = (report: ImportReport): void => self.postMessage(report);
const abort = new AbortController();

const isXdf = (file: File): boolean => /\.xdf$/i.test(file.name);

function tableOptions({ timeColumn, timeUnit, layout }: ImportChoice): CsvOptions {
  return {
    timeColumn: timeColumn || undefined,
    timeUnit: timeUnit === 'auto' ? undefined : timeUnit,
    layout,
  };
}

async function planOf(file: File, choice: ImportChoice): Promise<ImportPlan> {
  const source = new BlobSource(file);
  if (!isXdf(file)) {
    const plan = await previewCsv(source, { name: nameOfFile(file), ...tableOptions(choice) });
    return { kind: 'csv', ...plan };
  }
  const { topics, damage } = await previewXdf(source);
  const rows = topics.map(({ topic, format, stream }) => ({
    topic,
    format,
    channels: stream.channels,
  }));
  return { kind: 'xdf', damage, topics: rows };
}

async function run({
  file,
  choice,
  topics,
}: Extract<ImportCommand, { kind: 'import' }>): Promise<void> {
  const target = openMemory();
  let position = 0n;
  const sink = {
    async write(bytes: Uint8Array): Promise<void> {
      await target.write(bytes);
      position += BigInt(bytes.byteLength);
    },
    position: () => position,
  };
  const shared = {
    ...{ name: nameOfFile(file), version: '', startMs: file.lastModified, topics },
    signal: abort.signal,
    onProgress: (share: number) => tell({ kind: 'progress', share }),
  };
  const source = new BlobSource(file);
  const { leftOut } = isXdf(file)
    ? await importXdf(source, sink, shared)
    : await importCsv(source, sink, { ...shared, ...tableOptions(choice) });
  tell({ kind: 'done', file: (await target.end())!, leftOut });
}

async function handle(command: Exclude<ImportCommand, { kind: 'cancel' }>): Promise<void> {
  if (command.kind === 'import') return run(command);
  tell({ kind: 'plan', plan: await planOf(command.file, command.choice) });
}

self.addEventListener('message', ({ data }: MessageEvent<ImportCommand>) => {
  if (data.kind === 'cancel') abort.abort(new Error('Cancelled.'));
  else handle(data).catch((error: unknown) => tell({ kind: 'failed', message: sentenceOf(error) }));
});
