import { createWriteStream } from 'node:fs';
import { mkdir, rm } from 'node:fs/promises';
import { once } from 'node:events';
import { join } from 'node:path';
import {
  choiceOption,
  ConfigError,
  HELP_OPTIONS,
  listOption,
  option,
  parseNumber,
  parsePath,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';
import { cutRecording, RecordingError, type EventsReader } from '@ubii/recording';
import { csvOf, topicTable, writeParquet, xdfOf } from '@ubii/recording/export';
import { leftOutParts } from '@ubii/recording/personal';
import { counted } from '@ubii/words';
import { createRecording, openRecording } from './recording-words.ts';
import { shareRecording } from './shared-reader.ts';
import { parseTopics, topicChoice } from './topic-choice.ts';

const OPTIONS = {
  format: choiceOption(
    ['csv', 'parquet', 'xdf', 'mcap'],
    'csv',
    'csv and parquet: a file for each topic; xdf and mcap: one file with all topics.',
  ),
  topics: listOption('<topic|glob>,...', 'Topics to export. Default: all', parseTopics),
  from: option({
    placeholder: '<seconds>',
    fallback: 0,
    description: 'Leave out what is earlier than this long after the beginning.',
    parse: parseNumber(0, 1_000_000),
  }),
  until: option({
    placeholder: '<seconds>',
    fallback: Infinity,
    fallbackText: 'end of the recording',
    description: 'Leave out what is later than this long after the beginning.',
    parse: parseNumber(0, 1_000_000),
  }),
  out: option({
    placeholder: '<folder>',
    fallback: '.',
    description: 'Folder of the files. It is created when it does not exist.',
    parse: parsePath,
  }),
  personal: option({
    placeholder: '<rules.json|recording|none>',
    fallback: 'none',
    description:
      'Replace personal data: by a file with rules, or by the labels in the recording. none exports everything as it is.',
    parse: (text, baseDir) =>
      text === 'recording' || text === 'none' ? text : parsePath(text, baseDir),
  }),
  key: option({
    placeholder: '<file>',
    fallback: '',
    fallbackText: 'a key that is thrown away',
    description: 'Key file of pseudonyms. It is created when it does not exist, and completed.',
    parse: parsePath,
  }),
  ...HELP_OPTIONS,
} as const;

/** `npm run export` */
export const EXPORT_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  takesWords: true,
  about: `Ubi-Interact recordings: writes a recording, or a part of it, as tables (CSV, Parquet), XDF or MCAP.

  npm run export -- <file.mcap> [flags]
`,
};

/** Where an export writes to. */
interface Output {
  readonly write: (part: string | Uint8Array) => Promise<void>;
  readonly end: () => Promise<void>;
}

/**
 * Exports a recording. Files that exist are not replaced.
 *
 * @throws ConfigError when it cannot be read, has none of the topics, or a file exists
 */
export async function exportRecording(
  [path, ...more]: readonly string[],
  { format, topics, from, until, out, personal, key }: OptionValues<typeof OPTIONS>,
  signal: AbortSignal,
  write: (text: string) => void,
): Promise<void> {
  if (more.length > 0) throw new ConfigError('Export one recording at a time.');
  const { file, reader: whole } = await openRecording(path);
  try {
    const shared = await shareRecording(whole, personal, key);
    const { reader } = shared;
    const chosen = chosenTopics(whole, topics, shared.topic, format === 'mcap');
    await mkdir(out, { recursive: true });
    const options = { ...spanOf(reader, from, until), topics: chosen, signal };
    if (format === 'xdf' || format === 'mcap') {
      const target = join(out, `${fileName(reader.summary.name || 'recording')}.${format}`);
      await (format === 'xdf' ? exportXdf : exportCut)(reader, target, options);
      write(`${target}\n`);
    } else {
      for (const topic of chosen) {
        const target = join(out, `${fileName(topic)}.${format}`);
        await exportTable(reader, topic, format, await createOutput(target), options);
        write(`${target}\n`);
      }
    }
    const leftOut = leftOutTopics(whole, topics, shared.topic);
    if (leftOut > 0)
      write(`Left out: ${counted(leftOut, 'topic')} with messages of other programs.\n`);
    const parts = format === 'mcap' && reader !== whole ? leftOutParts(whole.summary) : '';
    if (parts !== '') write(`Left out: ${parts}.\n`);
    for (const sentence of shared.report()) write(`${sentence}.\n`);
    await shared.saveKey();
  } finally {
    await file.close();
  }
}

interface PartOptions extends Span {
  readonly topics: readonly string[];
  readonly signal: AbortSignal;
}

interface Span {
  readonly fromNs?: bigint;
  readonly untilNs?: bigint;
}

/** @param from @param until seconds after the beginning */
function spanOf({ summary }: EventsReader, from: number, until: number): Span {
  if (until < from) throw new ConfigError('--until is before --from.');
  const at = (seconds: number): bigint => summary.startNs + BigInt(Math.round(seconds * 1e9));
  return {
    ...(from > 0 ? { fromNs: at(from) } : {}),
    ...(until < Infinity ? { untilNs: at(until) } : {}),
  };
}

async function exportXdf(
  reader: EventsReader,
  target: string,
  options: PartOptions,
): Promise<void> {
  const output = await createOutput(target);
  for await (const part of xdfOf(reader, options)) await output.write(part);
  await output.end();
}

async function exportCut(
  reader: EventsReader,
  target: string,
  options: PartOptions,
): Promise<void> {
  const file = await createRecording(target);
  try {
    await cutRecording(reader, file, options);
  } catch (error) {
    if (!(error instanceof RecordingError)) throw error;
    await rm(target, { force: true });
    throw new ConfigError(error.message);
  } finally {
    await file.close();
  }
}

async function exportTable(
  reader: EventsReader,
  topic: string,
  format: 'csv' | 'parquet',
  output: Output,
  { topics: _topics, ...options }: PartOptions,
): Promise<void> {
  const names = new Map(reader.summary.topics.map((each) => [each.clientId, each.clientName]));
  const nameOf = (id: string): string => names.get(id) || id;
  const table = await topicTable(reader, topic, options);
  if (format === 'parquet') await writeParquet(table, output.write, nameOf);
  else for await (const part of csvOf(table, nameOf)) await output.write(part);
  await output.end();
}

function chosenTopics(
  reader: EventsReader,
  topics: readonly string[],
  shared: (topic: string) => string | undefined,
  withForeign: boolean,
): readonly string[] {
  const isChosen = topics.length === 0 ? () => true : topicChoice(topics);
  const all = reader.summary.topics
    .filter(({ isRaw }) => withForeign || !isRaw)
    .map(({ topic }) => topic);
  const names = all.filter(isChosen).flatMap((topic) => shared(topic) ?? []);
  // Topics that differed in a dropped value are one.
  const chosen = [...new Set(names)];
  if (chosen.length > 0) return chosen;
  throw new ConfigError('The recording has none of these topics. "npm run info" lists its topics.');
}

/** How many of the chosen topics are not shared because they cannot be searched for names. [PD-14] */
function leftOutTopics(
  { summary }: EventsReader,
  topics: readonly string[],
  shared: (topic: string) => string | undefined,
): number {
  const isChosen = topics.length === 0 ? () => true : topicChoice(topics);
  const foreign = summary.topics.filter(({ isRaw, topic }) => isRaw && isChosen(topic));
  return new Set(foreign.map(({ topic }) => topic).filter((topic) => shared(topic) === undefined))
    .size;
}

/** @throws ConfigError when the file exists or cannot be created */
async function createOutput(path: string): Promise<Output> {
  const stream = createWriteStream(path, { flags: 'wx' });
  try {
    await once(stream, 'open');
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason = code === 'EEXIST' ? 'it exists. Choose another folder with --out' : message;
    throw new ConfigError(`The file ${path} cannot be written: ${reason}.`);
  }
  return {
    async write(part) {
      if (!stream.write(part)) await once(stream, 'drain');
    },
    async end() {
      stream.end();
      await once(stream, 'finish');
    },
  };
}

function fileName(text: string): string {
  return text.replace(/^\/+/, '').replace(/[^\w.-]+/g, '-') || 'recording';
}
