import { join } from 'node:path';
import { AssetFolders } from '@ubii/pm-sandbox/node';
import { asksForHelp, formatHelp, readOptions, type Environment } from '@ubii/program';
import { AssetSetState } from '@ubii/proto';
import { MASTER_PROGRAM, OPTIONS } from '../config/config.ts';
import { prepareDataDir } from '../config/prepare-data-dir.ts';
import { modelAddress, modelBytes, type KnownModel } from './catalogue.ts';
import { assetSetNames, describeAssetSet } from './describe-asset-set.ts';
import { DownloadError, downloadModel } from './download-model.ts';

const MEGABYTE = 1e6;

/** `18.6 MB`. */
export function megabytes(bytes: number): string {
  return `${(bytes / MEGABYTE).toFixed(1)} MB`;
}

/**
 * Progress of a download in one line.
 *
 * @param elapsedMs since its start
 */
function progressLine(loadedBytes: number, totalBytes: number, elapsedMs: number): string {
  const percent = Math.floor((loadedBytes / totalBytes) * 100);
  const ofBytes = `${(loadedBytes / MEGABYTE).toFixed(1)} of ${megabytes(totalBytes)}`;
  const leftMs = (elapsedMs / loadedBytes) * (totalBytes - loadedBytes);
  const left = Number.isFinite(leftMs) ? `  ${Math.ceil(leftMs / 1000)} s left` : '';
  return `${String(percent).padStart(3)} %  ${ofBytes}${left}`;
}

/** Interval of progress lines in a terminal, milliseconds; step of progress lines in other outputs, percent. */
const TERMINAL_MS = 200;
const LINE_PERCENT = 10;

const STATE_WORDS: Readonly<Record<AssetSetState, string>> = {
  [AssetSetState.ASSET_SET_STATE_UNSPECIFIED]: '',
  [AssetSetState.ASSET_SET_STATE_MISSING]: 'not installed',
  [AssetSetState.ASSET_SET_STATE_PRESENT]: 'installed',
  [AssetSetState.ASSET_SET_STATE_DAMAGED]: 'damaged',
};

const { dataDir, modelMirror, config } = OPTIONS;
const HELP = formatHelp({
  ...MASTER_PROGRAM,
  options: { dataDir, modelMirror, config },
  about: `Ubi-Interact models: downloads models for modules into the data directory of a master.

  npm run models                        lists models, and which are installed
  npm run models -- get <name>          downloads a model and verifies it

Options are those of the master, from the same places. A running master need not be restarted.
`,
});

/** Environment of the program. */
export interface ModelProgram {
  readonly models: readonly KnownModel[];
  /** Asset sets that come with the program. */
  readonly assetsFolder: string;
  readonly env: Environment;
  readonly cwd: string;
  /** Ends a download. */
  readonly signal: AbortSignal;
  readonly isTerminal: boolean;
  write(text: string): void;
  writeError(text: string): void;
  nowMs(): number;
}

/**
 * `npm run models`: lists models, or downloads one. [EX-59]
 *
 * @returns the exit code
 * @throws ConfigError for wrong flags
 */
export async function runModels(args: readonly string[], program: ModelProgram): Promise<number> {
  if (asksForHelp(args)) {
    program.write(HELP);
    return 0;
  }
  const models = { ...MASTER_PROGRAM, takesWords: true };
  const { values, words } = readOptions(models, args, program.env, program.cwd);
  const { dataDir, modelMirror } = values;
  const [command = 'list', name, ...more] = words;
  if (command === 'list' && name === undefined) return list(dataDir, modelMirror, program);
  if (command === 'get' && name !== undefined && more.length === 0) {
    return get(name, dataDir, modelMirror, program);
  }
  program.writeError(`Unexpected arguments: ${words.join(' ')}.\n\n${HELP}`);
  return 1;
}

async function list(
  dataDir: string,
  mirror: string | undefined,
  { models, assetsFolder, write }: ModelProgram,
): Promise<number> {
  const folder = join(dataDir, 'models');
  const assets = new AssetFolders([assetsFolder, folder]);
  const sets = await Promise.all(
    (await assetSetNames(assets, models)).map((name) =>
      describeAssetSet(name, {
        assets,
        folder,
        mirror,
        model: models.find((one) => one.name === name),
      }),
    ),
  );
  const width = Math.max(...sets.map(({ name }) => name.length));
  for (const { name, state, bytes, bundled, description, problem } of sets) {
    const word = bundled ? 'included' : STATE_WORDS[state];
    const size = megabytes(bytes).padStart(8);
    write(`${`${name.padEnd(width)}  ${word.padEnd(13)}  ${size}  ${description}`.trimEnd()}\n`);
    if (problem) write(`  ${problem}\n`);
    const isOffered = models.some((model) => model.name === name);
    if (isOffered && word !== 'installed') write(`  npm run models -- get ${name}\n`);
  }
  write(`\nModels are installed in ${folder}.\n`);
  return 0;
}

async function get(
  name: string,
  dataDir: string,
  mirror: string | undefined,
  program: ModelProgram,
): Promise<number> {
  const { models, signal, write, writeError, nowMs } = program;
  const model = models.find((one) => one.name === name);
  if (model === undefined) {
    const names = models.map((one) => one.name).join(', ');
    writeError(`No model is named "${name}". Available models: ${names}.\n`);
    return 1;
  }
  prepareDataDir(dataDir);
  const folder = join(dataDir, 'models');
  if (await isInstalled(model, folder)) {
    write(`${name} is installed in ${join(folder, name)}.\n`);
    return 0;
  }
  const address = modelAddress(model, mirror);
  write(
    `Downloading ${name} (${megabytes(modelBytes(model))}, ${model.licence}) from ${address}\n`,
  );
  const progress = progressWriter(modelBytes(model), nowMs(), program);
  try {
    await downloadModel(model, { folder, mirror, signal, onProgress: progress.tell });
  } catch (error) {
    progress.end();
    if (signal.aborted) {
      writeError('Cancelled. The downloaded files were deleted.\n');
      return 130;
    }
    if (!(error instanceof DownloadError)) throw error;
    const files = model.files.map(({ path }) => path).join(', ');
    writeError(
      `${error.message}\nWithout internet: download ${files} of ${model.address} on another machine, and put them into ${join(folder, name)}. Or use a mirror: --model-mirror <url>.\n`,
    );
    return 1;
  }
  progress.end();
  write(`${name} is verified and installed in ${join(folder, name)}.\n`);
  return 0;
}

/** Whether all files of a model are there and right. */
async function isInstalled(model: KnownModel, folder: string): Promise<boolean> {
  const assets = new AssetFolders([folder]);
  try {
    const { files } = await assets.manifest(model.name);
    for (const file of files) await assets.verify(model.name, file);
    return model.files.every((file) => files.some(({ sha256 }) => sha256 === file.sha256));
  } catch {
    return false; // missing or damaged: it is downloaded
  }
}

/** Writes progress into one line of a terminal, or as a line now and then. */
function progressWriter(
  totalBytes: number,
  startedMs: number,
  { isTerminal, write, nowMs }: ModelProgram,
) {
  let toldMs = -Infinity;
  let toldPercent = 0;
  const tell = (loadedBytes: number): void => {
    const atMs = nowMs();
    const percent = Math.floor((loadedBytes / totalBytes) * 100);
    const isLast = loadedBytes === totalBytes;
    if (isTerminal ? atMs - toldMs < TERMINAL_MS : percent - toldPercent < LINE_PERCENT) {
      if (!isLast || percent === toldPercent) return;
    }
    toldMs = atMs;
    toldPercent = percent;
    const line = progressLine(loadedBytes, totalBytes, atMs - startedMs);
    // The second sequence erases what is left of a longer line before.
    write(isTerminal ? `\r${line}\u001b[K` : `${line}\n`);
  };
  return { tell, end: () => isTerminal && toldMs > -Infinity && write('\n') };
}
