import type { SandboxFactory } from '@ubii/pm-sandbox';
import { ConfigError } from '@ubii/program';
import type { JsonObject } from '@ubii/proto';

import type { Log } from '../../core/ports/index.ts';
import { classModule, MAX_SCRIPT_BYTES } from './class-module.ts';
import { withThreeParameters } from './four-parameters.ts';
import { findOriginalFolders, readFiles, type OriginalFile } from './original-files.ts';

/** What an original installation has stored. */
export interface OriginalData {
  readonly sessions: readonly OriginalFile[];
  readonly modules: readonly OriginalFile[];
}

/**
 * Reads the sessions and modules of an original installation. Its files are not written, and code in them is run in
 * sandboxes alone. [SE-28] [SE-29]
 *
 * @returns undefined without a folder
 * @throws ConfigError when the folder is none of an original installation
 */
export async function readOriginal(
  folder: string | undefined,
  sandboxes: SandboxFactory,
  log: Log,
): Promise<OriginalData | undefined> {
  if (folder === undefined) return undefined;
  const folders = await findOriginalFolders(folder);
  if (folders === undefined) {
    throw new ConfigError(
      `The folder ${folder} (--original-data) must be the folder of an original master, with database/sessions or database/processing in it, or its database folder.`,
    );
  }
  const { sessions, processing } = folders;
  const data = {
    sessions:
      sessions === undefined
        ? []
        : withoutRepeats(await readFiles(sessions, { '.session': readSession })),
    modules:
      processing === undefined
        ? []
        : withoutRepeats(
            await readFiles(processing, {
              '.pm': (text) => withThreeParameters(parseObject(text)),
              '.js': (text) => readScript(text, sandboxes),
            }),
          ),
  };
  const isRead = ({ document }: OriginalFile): boolean => document.fault === undefined;
  log.info('original installation read', {
    folder,
    sessions: data.sessions.filter(isRead).length,
    modules: data.modules.filter(isRead).length,
    unreadable: [...data.sessions, ...data.modules].filter((file) => !isRead(file)).length,
  });
  return data;
}

function readSession(text: string): JsonObject {
  const session = parseObject(text);
  const { interactions, processingModules } = session;
  if (Array.isArray(interactions) && !Array.isArray(processingModules)) {
    throw new Error(
      'It has interactions, which processing modules replaced in 2020: write them as modules.',
    );
  }
  if (!Array.isArray(processingModules)) return session;
  return {
    ...session,
    processingModules: processingModules.map((module) =>
      isObject(module) ? withThreeParameters(module) : module,
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
  if (!isObject(json)) throw new Error('It must be a JSON object.');
  return json;
}

/** Of two files with one name inside, the first one counts, as in the original. */
function withoutRepeats(files: readonly OriginalFile[]): OriginalFile[] {
  const paths = new Map<string, string>();
  return files.map(({ path, document }) => {
    const name = isObject(document.json) ? document.json['name'] : undefined;
    if (typeof name !== 'string' || name === '') return { path, document };
    const first = paths.get(name);
    if (first !== undefined) {
      return { path, document: { fault: `the name "${name}" is that of ${first} already` } };
    }
    paths.set(name, path);
    return { path, document };
  });
}

function isObject(value: unknown): value is JsonObject {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
