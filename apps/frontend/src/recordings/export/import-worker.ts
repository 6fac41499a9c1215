import { BlobSource } from '@ubii/recording/browser';
import {
  importCsv,
  importXdf,
  previewCsv,
  previewXdf,
  type CsvOptions,
} from '@ubii/recording/import';
import { serveCalls } from '@ubii/worker-rpc/browser';
import {
  nameOfFile,
  type ImportChoice,
  type ImportPage,
  type ImportPlan,
  type ImportWorker,
} from './import-messages.ts';
import { openMemory } from './output.ts';

/** Makes a recording of a file of another format, beside the page. */
const page: ImportPage = serveCalls<ImportWorker, ImportPage>({ plan, run });

const isXdf = (file: File): boolean => /\.xdf$/i.test(file.name);

function tableOptions({ timeColumn, timeUnit, layout }: ImportChoice): CsvOptions {
  return {
    timeColumn: timeColumn || undefined,
    timeUnit: timeUnit === 'auto' ? undefined : timeUnit,
    layout,
  };
}

async function plan(file: File, choice: ImportChoice): Promise<ImportPlan> {
  const source = new BlobSource(file);
  if (!isXdf(file)) {
    const table = await previewCsv(source, { name: nameOfFile(file), ...tableOptions(choice) });
    return { kind: 'csv', ...table };
  }
  const { topics, damage } = await previewXdf(source);
  const rows = topics.map(({ topic, format, stream }) => ({
    topic,
    format,
    channels: stream.channels,
  }));
  return { kind: 'xdf', damage, topics: rows };
}

async function run(
  ...[file, choice, topics]: Parameters<ImportWorker['run']>
): ReturnType<ImportWorker['run']> {
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
    name: nameOfFile(file),
    version: '',
    startMs: file.lastModified,
    topics,
    onProgress: (share: number) => page.showProgress(share),
  };
  const source = new BlobSource(file);
  const { leftOut } = isXdf(file)
    ? await importXdf(source, sink, shared)
    : await importCsv(source, sink, { ...shared, ...tableOptions(choice) });
  return { recording: (await target.end())!, leftOut };
}
