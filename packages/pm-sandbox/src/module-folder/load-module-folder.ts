import { readFile, readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { decode, encode, fromJson, type Init, type ProcessingModule } from '@ubii/proto';
import type { AnyModuleDefinition } from '../definition/define-processing-module.ts';
import { moduleProblems } from '../definition/module-problems.ts';
import { moduleToWire } from '../definition/module-to-wire.ts';

const MODULE = 'ubii.processing.ProcessingModule';

/**
 * The module of an object: a definition with functions, or the members of a `ProcessingModule` with
 * source text or with functions.
 *
 * @throws Error with one sentence
 */
function moduleFromExport(value: unknown): ProcessingModule {
  if (!isObject(value)) {
    throw new Error(
      `Expected a processing module, as an object with name and onProcessing, received ${describe(value)}`,
    );
  }
  return typeof value['onProcessing'] === 'function'
    ? checked(fromFunctions(value))
    : moduleFromJson(value);
}

/**
 * The module of a `.pm` file's content.
 *
 * @throws Error with one sentence
 */
function moduleFromJson(json: unknown): ProcessingModule {
  const module = fromJson(MODULE, json);
  if (module.onProcessingStringified.trim() === '') {
    throw new Error('Expected onProcessing, or onProcessingStringified with its source text');
  }
  return checked(module);
}

/** Inputs and outputs are an object by name, or a list as in a message. */
function fromFunctions(value: Record<string, unknown>): ProcessingModule {
  const { inputs = {}, outputs = {}, processingMode } = value;
  const definition = {
    ...value,
    name: typeof value['name'] === 'string' ? value['name'] : '',
    inputs: Array.isArray(inputs) ? {} : inputs,
    outputs: Array.isArray(outputs) ? {} : outputs,
  };
  const init: Init<ProcessingModule> = moduleToWire(definition as unknown as AnyModuleDefinition);
  const listed = fromJson(MODULE, {
    ...(Array.isArray(inputs) ? { inputs: inputs as object[] } : {}),
    ...(Array.isArray(outputs) ? { outputs: outputs as object[] } : {}),
    ...(isObject(processingMode) ? { processingMode } : {}),
  });
  return decode(
    MODULE,
    encode(MODULE, {
      ...init,
      ...(Array.isArray(inputs) ? { inputs: listed.inputs } : {}),
      ...(Array.isArray(outputs) ? { outputs: listed.outputs } : {}),
      ...(listed.processingMode === undefined ? {} : { processingMode: listed.processingMode }),
    }),
  );
}

function checked(module: ProcessingModule): ProcessingModule {
  const problems = moduleProblems(module);
  if (problems.length === 0) return module;
  throw new Error(
    problems
      .map(({ path, message }) =>
        path === '' || path === 'name' ? message : `${path}: ${message}`,
      )
      .join(' '),
  );
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function describe(value: unknown): string {
  if (value === undefined) return 'nothing: the file needs a default export';
  if (Array.isArray(value)) return 'a list';
  return typeof value === 'function' ? 'a function or class' : JSON.stringify(value);
}

/** A file that gives no module. */
export interface FolderProblem {
  /** Its name without the folder. */
  readonly file: string;
  /** One sentence. */
  readonly message: string;
}

/** Content of a folder. */
export interface LoadedFolder {
  /** Complete, by filename from a to z. */
  readonly modules: readonly ProcessingModule[];
  readonly problems: readonly FolderProblem[];
}

/**
 * Loads the modules of a folder: `.pm` files, which are JSON of one `ProcessingModule`, and `.js` and
 * `.mjs` files, ES modules whose default export is one module or a list of them. The latter are run in
 * this process: the folder is the operator's, who vouches for it. [PM-51] A file that cannot be read
 * stops nothing else.
 *
 * @throws Error when the folder itself cannot be read
 */
export async function loadModuleFolder(folder: string): Promise<LoadedFolder> {
  const files = (await readdir(folder)).filter((name) => MODULE_FILE.test(name));
  const modules = new Map<string, { readonly file: string; readonly module: ProcessingModule }>();
  const problems: FolderProblem[] = [];
  for (const file of files.sort()) {
    try {
      for (const module of await loadFile(join(folder, file))) {
        const other = modules.get(module.name)?.file;
        if (other === undefined) modules.set(module.name, { file, module });
        else {
          const message = `The module "${module.name}" is already defined in ${other}, so this one is ignored`;
          problems.push({ file, message });
        }
      }
    } catch (error) {
      problems.push({ file, message: messageOf(error) });
    }
  }
  return { modules: [...modules.values()].map(({ module }) => module), problems };
}

/** Hidden files are what editors write on the way. */
const MODULE_FILE = /^[^.].*\.(pm|js|mjs)$/;

async function loadFile(path: string): Promise<ProcessingModule[]> {
  return path.endsWith('.pm') ? loadJson(path) : loadScript(path);
}

async function loadJson(path: string): Promise<ProcessingModule[]> {
  return [moduleFromJson(JSON.parse(await readFile(path, 'utf8')))];
}

async function loadScript(path: string): Promise<ProcessingModule[]> {
  // Node never imports the same address twice, so each version gets its own.
  const { mtimeMs, size } = await stat(path);
  const address = `${pathToFileURL(path).href}?changed=${mtimeMs}-${size}`;
  const { default: exported } = (await import(/* @vite-ignore */ address)) as {
    default?: unknown;
  };
  return (Array.isArray(exported) ? exported : [exported]).map(moduleFromExport);
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
