import { DecodeError, fromJson, toJson, type JsonObject, type ProcessingModule } from '@ubii/proto';
import { fileName, type TextFile } from '../../files/text-file.ts';
import { jsonLines } from '../../sessions/text/json-lines.ts';
import { moduleSpec } from '../../sessions/text/session-spec.ts';

/** Filename extension of an exported module, the same as for the master's own files. [SE-20] */
export const MODULE_FILE_ENDING = '.pm';

const MODULE = 'ubii.processing.ProcessingModule';

/** Modules of a file, or the reason why it has none, one sentence. */
export type ReadModules =
  | { readonly kind: 'read'; readonly modules: readonly ProcessingModule[] }
  | { readonly kind: 'broken'; readonly message: string };

/** JSON of a module without node and status. */
function moduleJson(module: ProcessingModule): JsonObject {
  const json = toJson(MODULE, { ...moduleSpec(module), id: '', nodeId: '' });
  const { id: _id, status: _status, sessionId: _session, nodeId: _node, ...kept } = json;
  return kept;
}

/** Exports a module as a file. */
export function exportModule(module: ProcessingModule): TextFile {
  return {
    name: `${fileName(module.name) || 'module'}${MODULE_FILE_ENDING}`,
    text: `${JSON.stringify(moduleJson(module), undefined, 2)}\n`,
  };
}

/** Exports several modules as one file with a list. */
export function exportModules(modules: readonly ProcessingModule[]): TextFile {
  return {
    name: `modules${MODULE_FILE_ENDING}`,
    text: `${JSON.stringify(modules.map(moduleJson), undefined, 2)}\n`,
  };
}

/** Parses a file with one module or a list of them. */
export function importModules({ name, text }: TextFile): ReadModules {
  const lines = jsonLines(text);
  if (lines.kind === 'broken') {
    return { kind: 'broken', message: `${name}, line ${lines.line}: ${lines.message}` };
  }
  const parsed = JSON.parse(text) as unknown;
  const modules: ProcessingModule[] = [];
  for (const one of Array.isArray(parsed) ? (parsed as unknown[]) : [parsed]) {
    try {
      const module = fromJson(MODULE, one);
      if (module.name === '') {
        return { kind: 'broken', message: `${name} contains a module without a name. Add a name.` };
      }
      modules.push({ ...module, id: '', nodeId: '', sessionId: '', status: 0 });
    } catch (cause) {
      if (!(cause instanceof DecodeError)) throw cause;
      const reason = cause.message.slice(cause.message.indexOf(': ') + 2);
      return { kind: 'broken', message: `${name}: ${reason}.` };
    }
  }
  return { kind: 'read', modules };
}
