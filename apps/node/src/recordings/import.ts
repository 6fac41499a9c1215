import { rm } from 'node:fs/promises';
import {
  ConfigError,
  HELP_OPTIONS,
  listOption,
  option,
  choiceOption,
  parseName,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';
import { cutRecording, RecordingError, type RecordingFile } from '@ubii/recording';
import { importCsv, importXdf, type ImportResult, type TimeUnit } from '@ubii/recording/import';
import { DiskFile } from '@ubii/recording/node';
import { counted } from '@ubii/words';
import { createRecording, openRecording } from './recording-words.ts';

const text = (placeholder: string, fallbackText: string, description: string) =>
  option<string | undefined>({
    placeholder,
    fallback: undefined,
    fallbackText,
    description,
    parse: parseName,
  });

const OPTIONS = {
  name: text('<text>', 'name of the file', 'Name of the recording, shown to users.'),
  time: text('<column>', 'found by its name', 'Table: column with the times.'),
  unit: choiceOption(
    ['auto', 's', 'ms', 'us', 'ns', 'iso'],
    'auto',
    'Table: unit of the times. Times before 1973 count from now.',
  ),
  layout: choiceOption(
    ['topics', 'object'],
    'topics',
    'Table: a topic for each column, or one topic with all numbers of a row.',
  ),
  topic: text(
    '<topic>',
    'name of the recording',
    'Table: topic of the rows, or the level above columns.',
  ),
  topics: listOption('<topic>,...', 'Topics to import. Default: all', (list) => list.split(',')),
  ...HELP_OPTIONS,
} as const;

/** `npm run import` */
export const IMPORT_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  takesWords: true,
  about: `Ubi-Interact recordings: makes a recording (MCAP) of a table or of a recording of the Lab Streaming Layer (XDF).

  npm run import -- <file.csv|file.xdf|file.mcap> [recording.mcap] [flags]

The recording can be uploaded on the page of recordings.
`,
};

/**
 * Imports a file.
 *
 * @throws ConfigError when it cannot be read or has nothing to import, or when the recording exists
 */
export async function importRecording(
  [path, target, ...more]: readonly string[],
  options: OptionValues<typeof OPTIONS>,
  program: { readonly signal: AbortSignal; readonly version: string; write(text: string): void },
): Promise<void> {
  if (path === undefined || more.length > 0) {
    throw new ConfigError('Give the path of one CSV, XDF or MCAP file, and that of the recording.');
  }
  const base = path.replace(/\.\w+$/, '');
  const out = target ?? `${base}.mcap`;
  if (out === path) throw new ConfigError('Give another path for the recording, after the file.');
  const name = options.name ?? base.replace(/^.*[\\/]/, '');
  const file = await createRecording(out);
  let isDone = false;
  try {
    const result = await importInto(file, path, { ...options, ...program, name });
    isDone = true;
    program.write(`${out}\n${[resultText(result), ...result.leftOut].join('\n')}\n`);
  } catch (error) {
    if (!(error instanceof RecordingError)) throw error;
    throw new ConfigError(`The file ${path} cannot be imported: ${error.message}`);
  } finally {
    await file.close();
    if (!isDone) await rm(out, { force: true });
  }
}

type ImportRun = Omit<OptionValues<typeof OPTIONS>, 'name' | 'version'> & {
  readonly name: string;
  readonly version: string;
  readonly signal: AbortSignal;
};

async function importInto(
  file: RecordingFile,
  path: string,
  { name, version, signal, time, unit, layout, topic, topics }: ImportRun,
): Promise<ImportResult> {
  const chosen = topics.length > 0 ? { topics } : {};
  const shared = { name, version, signal, startMs: Date.now(), ...chosen };
  if (/\.mcap$/i.test(path)) {
    const { file: source, reader } = await openRecording(path);
    try {
      const header = { name, kind: 'import' } as const;
      return { ...(await cutRecording(reader, file, { ...chosen, signal, header })), leftOut: [] };
    } finally {
      await source.close();
    }
  }
  const source = await openFile(path);
  try {
    if (/\.xdf$/i.test(path)) return await importXdf(source, file, shared);
    const timeUnit: TimeUnit | undefined = unit === 'auto' ? undefined : unit;
    return await importCsv(source, file, { ...shared, timeColumn: time, timeUnit, layout, topic });
  } finally {
    await source.close();
  }
}

async function openFile(path: string): Promise<DiskFile> {
  try {
    return await DiskFile.open(path);
  } catch (error) {
    throw new ConfigError(`The file ${path} cannot be opened: ${(error as Error).message}`);
  }
}

function resultText({ records, markers }: ImportResult): string {
  const parts = [counted(records, 'record'), ...(markers > 0 ? [counted(markers, 'marker')] : [])];
  return `Imported ${parts.join(' and ')}.`;
}
