import { DecodeError, fromJson, toJson, type ProcessingModule } from '@ubii/proto';
import { fileName, type TextFile } from '../../sessions/file/session-file.ts';
import { jsonLines } from '../../sessions/text/json-lines.ts';
import { moduleSpec } from '../../sessions/text/session-spec.ts';

/** Ends the name of an exported module; the master's own files have it too. [SE-20] */
export const MODULE_FILE_ENDING = '.pm';

const MODULE = 'ubii.processing.ProcessingModule';

/** A file's module, or one sentence why it is none. */
export type ReadModule =
  | { readonly kind: 'read'; readonly module: ProcessingModule }
  | { readonly kind: 'broken'; readonly message: string };

/** A module as one file; its place and life are not part of it. */
export function exportModule(module: ProcessingModule): TextFile {
  const json = toJson(MODULE, { ...moduleSpec(module), id: '', nodeId: '' });
  const { id: _id, status: _status, sessionId: _session, nodeId: _node, ...kept } = json;
  return {
    name: `${fileName(module.name) || 'module'}${MODULE_FILE_ENDING}`,
    text: `${JSON.stringify(kept, undefined, 2)}\n`,
  };
}

export function importModule({ name, text }: TextFile): ReadModule {
  const lines = jsonLines(text);
  if (lines.kind === 'broken') {
    return { kind: 'broken', message: `${name}, line ${lines.line}: ${lines.message}` };
  }
  try {
    const module = fromJson(MODULE, JSON.parse(text));
    if (module.name === '') {
      return { kind: 'broken', message: `${name} holds no module: it has no name.` };
    }
    return { kind: 'read', module: { ...module, id: '', nodeId: '', sessionId: '', status: 0 } };
  } catch (cause) {
    if (!(cause instanceof DecodeError)) throw cause;
    const reason = cause.message.slice(cause.message.indexOf(': ') + 2);
    return { kind: 'broken', message: `${name}: ${reason}.` };
  }
}
