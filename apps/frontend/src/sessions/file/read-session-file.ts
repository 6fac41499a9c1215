import type { Session } from '@ubii/proto';
import { readSessionText, type TextProblem } from '../text/session-text.ts';
import { FILE_LIMITS } from './file-limits.ts';
import { isSessionLike, recogniseForeign } from './foreign-file.ts';
import type { TextFile } from '../../files/text-file.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';

/** A session from a file, or the reason why it has none, one sentence. */
export type ReadFile =
  | {
      readonly kind: 'read';
      readonly name: string;
      readonly session: Session;
      /** Warnings. */
      readonly problems: readonly TextProblem[];
    }
  | {
      readonly kind: 'broken';
      readonly name: string;
      /** Includes the filename and the position. */
      readonly message: string;
      /** Text of an invalid session, for manual correction. */
      readonly text: string | undefined;
    };

/** @param text content of the file; a session without a name gets that of the file */
export function readSessionFile({ name, text }: TextFile): ReadFile {
  const broken = (message: string, canEdit = false): ReadFile => ({
    kind: 'broken',
    name,
    message,
    text: canEdit && text.length <= FILE_LIMITS.textToEdit ? text : undefined,
  });
  if (text.trim() === '') return broken(`${name} is empty.`);
  if (text.includes('\0')) return broken(`${name} is not a text file, so it contains no session.`);
  const value = parsed(text);
  const foreign = recogniseForeign(value);
  if (foreign) return broken(`${name} is ${foreign.what}, not a session. ${foreign.advice}`.trim());
  if (value !== undefined && !isObject(value)) {
    return broken(`${name} contains no session: a session is a JSON object, { … }.`);
  }
  const read = readSessionText(text);
  if (read.kind === 'broken') {
    const [first] = read.problems;
    const place = first?.line === undefined ? '' : `, line ${first.line}`;
    const reason = first?.message ?? 'The file cannot be read.';
    return broken(`${name}${place}: ${reason}`, true);
  }
  if (value === undefined || !isSessionLike(value)) {
    return broken(`${name} contains no session: it has neither modules nor mappings.`, true);
  }
  const tooMany = overLimit(read.session);
  if (tooMany) return broken(`${name} has ${tooMany}.`);
  const session =
    read.session.name === ''
      ? { ...read.session, name: name.replace(/\.[^.]+$/, '') }
      : read.session;
  return { kind: 'read', name, session, problems: read.problems };
}

/** Returns why a file is too large to be read; `undefined` when it is not. */
export function refuseSize(name: string, bytes: number): ReadFile | undefined {
  if (bytes <= FILE_LIMITS.bytes) return undefined;
  const size = (of: number): string => `${Math.round(of / 1024 / 1024)} MB`;
  const message = `${name} has ${size(bytes)}. The maximum size of a session is ${size(FILE_LIMITS.bytes)}.`;
  return { kind: 'broken', name, message, text: undefined };
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text) as unknown;
  } catch {
    return undefined;
  }
}

const isObject = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function overLimit({ processingModules, ioMappings }: Session): string | undefined {
  if (processingModules.length > FILE_LIMITS.modules) {
    return `${formatNumber(processingModules.length)} modules; a session has at most ${FILE_LIMITS.modules}`;
  }
  const mapped = ioMappings.reduce(
    (sum, { inputMappings, outputMappings }) => sum + inputMappings.length + outputMappings.length,
    0,
  );
  return mapped > FILE_LIMITS.mappings
    ? `${formatNumber(mapped)} mapped inputs and outputs; a session has at most ${formatNumber(FILE_LIMITS.mappings)}`
    : undefined;
}
