import type { UbiiClient } from '@ubii/client-web/node';
import {
  ConfigError,
  HELP_OPTIONS,
  listOption,
  option,
  parseList,
  parseNumber,
  switchOption,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';
import { isMasterTopic } from '@ubii/proto';
import {
  Playback,
  type RecordedRecord,
  type RecordedTopic,
  type RecordingReader,
} from '@ubii/recording';
import { systemClock } from '@ubii/timing/system';
import { counted } from '@ubii/words';
import { createLog } from '@ubii/client-program';
import { connect, CONNECTION_OPTIONS } from './connect.ts';
import { durationText, openRecording } from './recording-words.ts';
import { replayedRecord } from './replayed-record.ts';
import { parseTopics, topicChoice } from './topic-choice.ts';

const OPTIONS = {
  ...CONNECTION_OPTIONS,
  topics: listOption('<topic|glob>,...', 'Topics to play. Default: all', parseTopics),
  rename: option<readonly Rename[]>({
    placeholder: '<from=to>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Play a topic, or all topics below it, under another name, such as /lab=/replay/lab, or all topics with /=/replay.',
    parse: parseRenames,
  }),
  rate: option({
    placeholder: '<number>',
    fallback: 1,
    description: 'Speed, 0.1 to 10 times the recorded one.',
    parse: parseNumber(0.1, 10),
  }),
  from: option({
    placeholder: '<seconds>',
    fallback: 0,
    description: 'Start this long after the beginning.',
    parse: parseNumber(0, 1_000_000),
  }),
  until: option({
    placeholder: '<seconds>',
    fallback: Infinity,
    fallbackText: 'end of the recording',
    description: 'Stop this long after the beginning.',
    parse: parseNumber(0, 1_000_000),
  }),
  loop: switchOption('Play again and again, until Ctrl-C.'),
  ...HELP_OPTIONS,
} as const;

/** `npm run play` */
export const PLAY_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  environmentPrefix: 'UBII_NODE_',
  takesWords: true,
  about: `Ubi-Interact recordings: publishes the records of a recording to a master, as a client of its own.

  npm run play -- <file.mcap> [flags]

Values get times of today. A topic that another client publishes at the same time has the values of both: use --rename then.
`,
  check({ from, until }) {
    if (until <= from) throw new ConfigError('The option --until must be later than --from.');
  },
};

/**
 * Plays a recording until its end, or until `signal` is aborted.
 *
 * @throws ConfigError when the recording cannot be read, has none of the topics, or the master cannot be reached
 */
export async function play(
  [path, ...more]: readonly string[],
  options: OptionValues<typeof OPTIONS>,
  signal: AbortSignal,
  writeError: (text: string) => void,
): Promise<void> {
  if (more.length > 0) throw new ConfigError('Play one recording at a time.');
  const log = createLog(options.logLevel, (line) => writeError(`${line}\n`));
  const { file, reader } = await openRecording(path);
  try {
    const { summary } = reader;
    const targets = targetsOf(summary.topics, options);
    const client = await connect(options, `Player of ${summary.name || 'a recording'}`, log);
    const length = durationText(summary.endNs - summary.startNs);
    log('info', `Playing ${counted(targets.size, 'topic')}, ${length}. Ctrl-C stops`);
    try {
      await playThrough(reader, options, signal, (records) => publish(client, records, targets));
      log('info', `Published ${counted(client.counters.recordsOut, 'record')}`);
    } finally {
      for (const topic of targets.values()) client.endTopic(topic);
      await client.close();
    }
  } finally {
    await file.close();
  }
}

/** Where each topic is played. @throws ConfigError when there is none */
function targetsOf(
  recorded: readonly RecordedTopic[],
  { topics, rename }: Pick<OptionValues<typeof OPTIONS>, 'topics' | 'rename'>,
): ReadonlyMap<string, string> {
  const isChosen =
    topics.length === 0 ? (topic: string) => !isMasterTopic(topic) : topicChoice(topics);
  const chosen = recorded.filter(({ topic, isRaw }) => !isRaw && isChosen(topic));
  if (chosen.length === 0) {
    throw new ConfigError(
      'The recording has none of these topics. "npm run info" lists its topics.',
    );
  }
  return new Map(chosen.map(({ topic }) => [topic, renamed(topic, rename)]));
}

function publish(
  client: UbiiClient,
  records: Iterable<RecordedRecord>,
  targets: ReadonlyMap<string, string>,
): void {
  const nowMs = client.masterTime.nowMs();
  for (const record of records) {
    const topic = targets.get(record.topic);
    if (topic === undefined) continue;
    const { bytes, valueField } = replayedRecord(record, { topic, clientId: client.id, nowMs });
    client.publishEncoded(topic, bytes, valueField);
  }
}

/** Resolves at the end, or when `signal` is aborted. @throws the error of the file */
async function playThrough(
  reader: RecordingReader,
  { rate, from, until, loop }: OptionValues<typeof OPTIONS>,
  signal: AbortSignal,
  publishAll: (records: Iterable<RecordedRecord>) => void,
): Promise<void> {
  const { startNs, endNs } = reader.summary;
  const at = (seconds: number): bigint => {
    const ns = startNs + BigInt(Math.round(seconds * 1e9));
    return ns < endNs ? ns : endNs;
  };
  const span = { fromNs: at(from), untilNs: until === Infinity ? endNs : at(until) };
  let playback: Playback | undefined;
  try {
    await new Promise<void>((resolve, reject) => {
      signal.addEventListener('abort', () => resolve(), { once: true });
      playback = new Playback({
        clock: systemClock,
        reader,
        sink: {
          onRecords: publishAll,
          onSeek: (latest) => publishAll(latest.values()),
          onState({ status, positionNs }) {
            if (status === 'ended' || (!loop && positionNs >= span.untilNs)) resolve();
          },
          onError: reject,
        },
      });
      if (loop) playback.setLoop(span);
      playback.setRate(rate);
      void playback.seek(span.fromNs).then(() => playback?.play());
    });
  } finally {
    playback?.close();
  }
}

/** Rules of `--rename`: the first whose `from` is the topic, or a level above it, applies. */
type Rename = readonly [from: string, to: string];

function renamed(topic: string, renames: readonly Rename[]): string {
  for (const [from, to] of renames) {
    if (topic === from || topic.startsWith(from === '/' ? from : `${from}/`)) {
      return to + topic.slice(from === '/' ? 0 : from.length);
    }
  }
  return topic;
}

function parseRenames(text: string): readonly Rename[] {
  return parseList(text).map((rule) => {
    const [from = '', to = '', ...more] = rule.split('=');
    if (!from.startsWith('/') || !/^\/.*[^/]$/.test(to) || more.length > 0) {
      throw new Error('rules separated by commas, such as /lab=/replay/lab');
    }
    return [from, to] as const;
  });
}
