import { cutRecording } from '@ubii/recording';
import { csvOf, topicTable, writeParquet, xdfOf } from '@ubii/recording/export';
import { counted } from '@ubii/words';
import { TimeBase } from '../reading/recording-time-base.ts';
import type { ExportRequest } from './export-messages.ts';
import type { ExportReader } from './export-reader.ts';
import { extensionOf, isByTopic, topicFileNames } from './export-names.ts';
import { ZipFile, type Output } from './output.ts';
import { videoKind } from './video-format.ts';
import type { writeVideo } from './video.ts';

/** What an export is told, and tells. */
export interface ExportRun {
  /** The file is a ZIP, whatever labels left of its topics. @default when there are several files */
  readonly isZip?: boolean;
  readonly signal: AbortSignal;
  /** @param share 0 to 1 */
  readonly onProgress: (share: number) => void;
  /** Loads what encodes video. */
  readonly video: () => Promise<{ readonly writeVideo: typeof writeVideo }>;
}

/**
 * Exports topics of a recording into one file.
 *
 * @returns what was left out, as sentences
 * @throws the reason of the signal, and the error of the output
 */
export async function runExport(
  reader: ExportReader,
  request: ExportRequest,
  output: Output,
  run: ExportRun,
): Promise<readonly string[]> {
  const part = partOf(reader, request, run);
  const { format, topics } = request;
  if (format === 'mcap') {
    await cutRecording(reader, sinkOf(output), { ...part, topics });
    return [];
  }
  if (format === 'xdf') {
    for await (const bytes of xdfOf(reader, { ...part, topics })) await output.write(bytes);
    return [];
  }
  const isZip = run.isZip ?? topics.length > 1;
  if (!isByTopic(format) || !isZip) {
    return exportTopic(reader, topics[0]!, format, output, part, run);
  }
  const video = format === 'video' ? await videoKind() : undefined;
  const names = topicFileNames(topics, extensionOf(format, video));
  const zip = new ZipFile(output);
  const leftOut: string[] = [];
  for (const [place, topic] of topics.entries()) {
    const file = zip.add(names[place]!, format !== 'csv');
    leftOut.push(...(await exportTopic(reader, topic, format, file, part, run)));
    await file.end();
  }
  await zip.end();
  return leftOut;
}

interface Part {
  readonly fromNs?: bigint;
  readonly untilNs?: bigint;
  readonly signal: AbortSignal;
  readonly onProgress: (records: number) => void;
}

/** Passes over the records of a topic. */
const PASSES = { csv: 2, parquet: 2, xdf: 2, mcap: 1, video: 1 } as const;

function partOf(
  { summary }: ExportReader,
  { format, topics, span }: ExportRequest,
  { signal, onProgress }: ExportRun,
): Part {
  const base = new TimeBase(summary.startNs);
  const chosen = summary.topics.filter(({ topic }) => topics.includes(topic));
  const all = chosen.reduce((sum, { records }) => sum + records, 0) * PASSES[format];
  const durationMs = Math.max(1, base.toMs(summary.endNs));
  // How many records are in a span is not known: about as many as elsewhere.
  const share = span ? (span.untilMs - span.fromMs) / durationMs : 1;
  let [before, last] = [0, 0];
  return {
    ...(span ? { fromNs: base.toNs(span.fromMs), untilNs: base.toNs(span.untilMs) } : {}),
    signal,
    onProgress(records) {
      // Each topic counts from the beginning.
      if (records < last) before += last;
      last = records;
      onProgress(Math.min(0.99, (before + records) / Math.max(1, all * share)));
    },
  };
}

async function exportTopic(
  reader: ExportReader,
  topic: string,
  format: ExportRequest['format'],
  output: Output,
  part: Part,
  run: ExportRun,
): Promise<readonly string[]> {
  if (format === 'video') {
    const video = await run.video();
    return video.writeVideo(reader, topic, output, part);
  }
  const names = new Map(reader.summary.topics.map((each) => [each.clientId, each.clientName]));
  const nameOf = (id: string): string => names.get(id) || id;
  const table = await topicTable(reader, topic, part);
  const write = (bytes: Uint8Array): Promise<void> => output.write(bytes);
  if (format === 'parquet') await writeParquet(table, write, nameOf);
  else {
    const text = new TextEncoder();
    for await (const lines of csvOf(table, nameOf)) await output.write(text.encode(lines));
  }
  if (table.leftOutColumns === 0) return [];
  return [`${topic}: ${counted(table.leftOutColumns, 'column')} beyond the first 1024 left out.`];
}

function sinkOf(output: Output) {
  let position = 0n;
  return {
    async write(bytes: Uint8Array): Promise<void> {
      await output.write(bytes);
      position += BigInt(bytes.byteLength);
    },
    position: () => position,
  };
}
