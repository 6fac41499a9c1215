import { onStopRequest, readVersion, runProgram } from '@ubii/program';
import type { OptionTable, OptionValues, ProgramOptions } from '@ubii/program';
import { EXPORT_PROGRAM, exportRecording } from './recordings/export.ts';
import { IMPORT_PROGRAM, importRecording } from './recordings/import.ts';
import { INFO_PROGRAM, info } from './recordings/info.ts';
import { PLAY_PROGRAM, play } from './recordings/play.ts';
import { record, RECORD_PROGRAM } from './recordings/record.ts';

const abort = new AbortController();
onStopRequest(() => abort.abort());
const version = readVersion(import.meta.url);
const write = (text: string): void => void process.stdout.write(text);
const writeError = (text: string): void => void process.stderr.write(text);

const programs: Readonly<Record<string, () => Promise<void>>> = {
  record: () =>
    run(RECORD_PROGRAM, (words, options) =>
      record(words, options, { signal: abort.signal, version, writeError }),
    ),
  play: () => run(PLAY_PROGRAM, (words, options) => play(words, options, abort.signal, writeError)),
  info: () => run(INFO_PROGRAM, (words, options) => info(words, options, write)),
  export: () =>
    run(EXPORT_PROGRAM, (words, options) => exportRecording(words, options, abort.signal, write)),
  import: () =>
    run(IMPORT_PROGRAM, (words, options) =>
      importRecording(words, options, { signal: abort.signal, version, write }),
    ),
};

// The first word says which of the programs runs; the script of npm gives it.
const [name = ''] = process.argv.splice(2, 1);
const program = programs[name];
if (program === undefined) {
  writeError(`Unknown program "${name}". There are ${Object.keys(programs).join(', ')}.\n`);
  process.exitCode = 1;
} else await program();

function run<O extends OptionTable>(
  program: ProgramOptions<O>,
  main: (words: readonly string[], options: OptionValues<O>) => Promise<void>,
): Promise<void> {
  return runProgram(program, ({ words, values }) => main(words, values), { version });
}
