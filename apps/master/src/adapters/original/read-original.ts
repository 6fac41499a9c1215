import type { JsonObject } from '@ubii/proto';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { ConfigError } from '@ubii/program';
import type { Clock } from '@ubii/timing';
import {
  type OriginalFile,
  findOriginalFolders,
  readFiles,
  type OriginalFolders,
} from './original-files.ts';
import type { Log } from '../../core/ports/index.ts';
import { classModule, MAX_SCRIPT_BYTES } from './class-module.ts';
import { withThreeParameters } from './four-parameters.ts';

function isJsonObject(value: unknown): value is JsonObject {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** Modules of an original installation that have the name of a trusted module of this master. */
class ShadowedModules {
  readonly #byName = new Map<string, JsonObject>();

  /** @param library trusted modules of this master, which come first [PM-64] */
  constructor(modules: readonly OriginalFile[], library: { has(name: string): boolean }) {
    for (const { document } of modules) {
      const { json } = document;
      const name = isJsonObject(json) ? json['name'] : undefined;
      if (typeof name === 'string' && library.has(name)) this.#byName.set(name, json as JsonObject);
    }
  }

  get names(): readonly string[] {
    return [...this.#byName.keys()];
  }

  /** The session, with the code of these modules where it names one: code in a session comes first. [SE-28] */
  addTo(session: OriginalFile): OriginalFile {
    const { json } = session.document;
    if (!isJsonObject(json) || !Array.isArray(json['processingModules'])) return session;
    const processingModules = (json['processingModules'] as unknown[]).map((module) =>
      isJsonObject(module) ? this.#complete(module) : module,
    );
    return { ...session, document: { json: { ...json, processingModules } } };
  }

  #complete(module: JsonObject): JsonObject {
    const own = this.#byName.get(String(module['name']));
    if (own === undefined || isGiven(module['onProcessingStringified'])) return module;
    const given = Object.entries(module).filter(([, value]) => isGiven(value));
    return { ...own, ...Object.fromEntries(given) } as JsonObject;
  }
}

function isGiven(value: unknown): boolean {
  return Array.isArray(value) ? value.length > 0 : Boolean(value);
}

/** What an original installation has stored. */
interface OriginalData {
  readonly sessions: readonly OriginalFile[];
  readonly modules: readonly OriginalFile[];
}

/** Time after which no further scripts of a folder are run to read them, milliseconds: one that never ends takes 0.5 s. */
const SCRIPTS_MS = 20_000;

/** Parts of the master that reading needs. */
export interface OriginalContext {
  readonly sandboxes: SandboxFactory;
  readonly clock: Pick<Clock, 'monotonicMs'>;
  readonly log: Log;
  /** Trusted modules of this master. */
  readonly library: { has(name: string): boolean };
}

/** @throws ConfigError when the folder is none of an original installation */
export async function foldersOf(folder: string): Promise<OriginalFolders> {
  const folders = await findOriginalFolders(folder);
  if (folders !== undefined) return folders;
  throw new ConfigError(
    `The folder ${folder} (--original-data) must be the folder of an original master, with database/sessions or database/processing in it, or its database folder.`,
  );
}

/**
 * Reads the sessions and modules of an original installation. Its files are not written, and code in them is run in
 * sandboxes alone. [SE-28] [SE-29]
 */
export async function readOriginal(
  folders: OriginalFolders,
  context: OriginalContext,
): Promise<OriginalData> {
  const { log, library } = context;
  const modules = await readModules(folders.processing, context);
  const shadowed = new ShadowedModules(modules, library);
  const sessions = (await readSessions(folders.sessions)).map((file) => shadowed.addTo(file));
  report({ sessions, modules }, shadowed, log);
  return { sessions, modules };
}

async function readModules(
  folder: string | undefined,
  { sandboxes, clock, log }: OriginalContext,
): Promise<OriginalFile[]> {
  if (folder === undefined) return [];
  const endMs = clock.monotonicMs() + SCRIPTS_MS;
  let late = 0;
  const files = await readFiles(folder, {
    '.pm': (text) => withThreeParameters(parseObject(text)),
    '.js': (text) => {
      if (clock.monotonicMs() < endMs) return readScript(text, sandboxes);
      late++;
      throw new Error(
        `It was not read: the scripts before it took ${SCRIPTS_MS / 1_000} s. Remove those that do not end.`,
      );
    },
  });
  if (late > 0) {
    log.warn('scripts of the original were not read, because those before them took too long', {
      folder,
      count: late,
      seconds: SCRIPTS_MS / 1_000,
    });
  }
  return withoutRepeats(files);
}

async function readSessions(folder: string | undefined): Promise<OriginalFile[]> {
  if (folder === undefined) return [];
  return withoutRepeats(await readFiles(folder, { '.session': readSession }));
}

function report({ sessions, modules }: OriginalData, shadowed: ShadowedModules, log: Log): void {
  const isRead = ({ document }: OriginalFile): boolean => document.fault === undefined;
  log.info('original installation read', {
    sessions: sessions.filter(isRead).length,
    modules: modules.filter(isRead).length,
    unreadable: [...sessions, ...modules].filter((file) => !isRead(file)).length,
  });
  for (const module of shadowed.names) {
    log.warn(
      'a module of the original has the name of one of this master: sessions of the original have its code, all others that of this master',
      { module },
    );
  }
}

function readSession(text: string): JsonObject {
  const session = parseObject(text);
  const { interactions, processingModules } = session;
  if (Array.isArray(interactions) && !Array.isArray(processingModules)) {
    throw new Error(
      'It has interactions, which processing modules replaced: write them as modules.',
    );
  }
  if (!Array.isArray(processingModules)) return session;
  return {
    ...session,
    processingModules: processingModules.map((module) =>
      isJsonObject(module) ? withThreeParameters(module) : module,
    ),
  };
}

function readScript(text: string, sandboxes: SandboxFactory): Promise<JsonObject> {
  const size = Buffer.byteLength(text);
  if (size > MAX_SCRIPT_BYTES) {
    throw new Error(`It has ${size} bytes; at most ${MAX_SCRIPT_BYTES} are read of a script.`);
  }
  return classModule(text, sandboxes);
}

function parseObject(text: string): JsonObject {
  const json: unknown = JSON.parse(text);
  if (!isJsonObject(json)) throw new Error('It must be a JSON object.');
  return json;
}

/** Of two files with one name inside, the first one counts, as in the original. */
function withoutRepeats(files: readonly OriginalFile[]): OriginalFile[] {
  const paths = new Map<string, string>();
  return files.map(({ path, document }) => {
    const name = isJsonObject(document.json) ? document.json['name'] : undefined;
    if (typeof name !== 'string' || name === '') return { path, document };
    const first = paths.get(name);
    if (first !== undefined) {
      return { path, document: { fault: `the name "${name}" is that of ${first} already` } };
    }
    paths.set(name, path);
    return { path, document };
  });
}
