import { hostname } from 'node:os';
import {
  ConfigError,
  HELP_OPTIONS,
  listOption,
  option,
  parseName,
  parseNumber,
  switchOption,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';
import { RecordingWriter } from '@ubii/recording';
import { counted } from '@ubii/words';
import { createLog } from '@ubii/client-program';
import { ClientRecorder } from './client-recorder.ts';
import { connect, CONNECTION_OPTIONS } from './connect.ts';
import { bytesText, createRecording, durationText } from './recording-words.ts';
import { parseTopics, topicChoice } from './topic-choice.ts';

const OPTIONS = {
  ...CONNECTION_OPTIONS,
  topics: listOption(
    '<topic|glob>,...',
    'Topics to record, such as /lab/**. Default: all but those of the master',
    parseTopics,
  ),
  noImages: switchOption('Leave out images.'),
  name: option<string | undefined>({
    placeholder: '<text>',
    fallback: undefined,
    fallbackText: 'name of the file',
    description: 'Name of the recording, shown to users.',
    parse: parseName,
  }),
  seconds: option({
    placeholder: '<number>',
    fallback: Infinity,
    fallbackText: 'until Ctrl-C',
    description: 'Longest duration.',
    parse: parseNumber(0.1, 1_000_000),
  }),
  megabytes: option({
    placeholder: '<number>',
    fallback: Infinity,
    fallbackText: 'no limit',
    description: 'Largest size of the file.',
    parse: parseNumber(0.1, 1_000_000),
  }),
  ...HELP_OPTIONS,
} as const;

/** `npm run record` */
export const RECORD_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  environmentPrefix: 'UBII_NODE_',
  takesWords: true,
  about: `Ubi-Interact recordings: records topics of a master into an MCAP file on this machine, until Ctrl-C.

  npm run record -- [file.mcap] [flags]
`,
};

/** What the program has around it. */
export interface RecordProgram {
  /** Ends the recording. */
  readonly signal: AbortSignal;
  /** Version of the program, for the file. */
  readonly version: string;
  writeError(text: string): void;
}

/**
 * Records until `signal` is aborted or a limit is reached.
 *
 * @throws ConfigError when the master cannot be reached, or the file cannot be created
 */
export async function record(
  [path = defaultPath(), ...more]: readonly string[],
  options: OptionValues<typeof OPTIONS>,
  { signal, writeError, version }: RecordProgram,
): Promise<void> {
  if (more.length > 0) throw new ConfigError('Record into one file at a time.');
  const { topics, noImages, seconds, megabytes } = options;
  const log = createLog(options.logLevel, (line) => writeError(`${line}\n`));
  const client = await connect(options, `${hostname().split('.')[0] || 'unnamed'} recorder`, log);
  try {
    const file = await createRecording(path);
    const writer = await RecordingWriter.create(file, {
      name: options.name ?? path.replace(/^.*[\\/]|\.mcap$/g, ''),
      kind: 'recording',
      masterName: (await client.call('serverConfiguration')).name,
      version,
      notes: '',
      selection: JSON.stringify({ topics, withImages: !noImages }),
    });
    const content = (): string => {
      const { records, topics: topicCount } = writer.statistics;
      const size = bytesText(Number(file.position()));
      const parts = [`${counted(records, 'record')} of ${counted(topicCount, 'topic')}`];
      return [...parts, durationText(recorder.lengthNs), size].join(', ');
    };
    const recorder = new ClientRecorder(client, writer, {
      patterns: topics.length === 0 ? ['/**'] : topics,
      isChosen: topicChoice(topics),
      withImages: !noImages,
      maxMs: seconds * 1000,
      maxBytes: megabytes * 1_000_000,
      onProgress: () => log('debug', content()),
    });
    log('info', `Recording into ${path}. Ctrl-C ends the recording`);
    const reason = await recorder.run(signal);
    await writer.end();
    log('info', `${reason}: ${content()} in ${path}`);
    await file.close();
  } finally {
    await client.close();
  }
}

/** Such as `recording-2026-11-26-14-05-09.mcap`, local time. */
function defaultPath(): string {
  const now = new Date();
  const parts = [
    now.getMonth() + 1,
    now.getDate(),
    now.getHours(),
    now.getMinutes(),
    now.getSeconds(),
  ];
  const digits = parts.map((part) => String(part).padStart(2, '0'));
  return `recording-${now.getFullYear()}-${digits.join('-')}.mcap`;
}
