import type { ProcessingModule } from '@ubii/proto';
import { readFile, readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { moduleFromExport, moduleFromJson } from './module-from-export.ts';

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
