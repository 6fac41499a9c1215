import { safeParse, type GenericSchema, type InferOutput } from 'valibot';
import { issueSentence } from './issue-sentence.ts';

/** Kind of JSON that users export and import. */
export interface ImportKind {
  /** Noun for messages: `The file contains no …`. */
  readonly what: string;
  /** Member that identifies the kind, and its value. */
  readonly mark: readonly [member: string, value: string];
  /** Member with the version of the format, and the supported version; the default for files without it. */
  readonly version: readonly [member: string, value: number];
  /** Longest text that is parsed, characters. */
  readonly maxChars: number;
}

/** Imported value, or the reason why it is invalid: sentences with the path and the remedy. */
export type Imported<T> =
  | { readonly kind: 'read'; readonly value: T }
  | { readonly kind: 'broken'; readonly message: string };

export const brokenImport = (message: string) => ({ kind: 'broken', message }) as const;

/** Deepest nesting; more would exhaust the stack of recursive readers. */
const MAX_DEPTH = 100;

/** Parses a file. */
export function readImported<S extends GenericSchema>(
  kind: ImportKind,
  schema: S,
  text: string,
): Imported<InferOutput<S>> {
  if (text.length > kind.maxChars) {
    return brokenImport(`The file is too large: it contains no ${kind.what}.`);
  }
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return brokenImport('The file is not JSON. It may be cut off or damaged. Export it again.');
  }
  return importedValue(kind, schema, json);
}

/** Validates the value of a file or link. */
export function importedValue<S extends GenericSchema>(
  { what, mark, version }: ImportKind,
  schema: S,
  json: unknown,
  source = 'file',
): Imported<InferOutput<S>> {
  const members = (json ?? {}) as Readonly<Record<string, unknown>>;
  if (members[mark[0]] !== mark[1]) {
    const advice = source === 'file' ? ' Choose a file that this page exported.' : '';
    return brokenImport(`The ${source} contains no ${what}.${advice}`);
  }
  if (isTooDeep(json)) return brokenImport(`The ${source} is damaged: it is nested too deeply.`);
  const found = members[version[0]] ?? version[1];
  if (found !== version[1]) {
    const its = typeof found === 'number' ? `version ${found}` : 'an unknown version';
    return brokenImport(
      `The ${source} has ${its}; this page reads version ${version[1]}. Create it with the same version of Ubi-Interact.`,
    );
  }
  // With an empty message, issues without their own message are formatted with the whole path.
  const { success, output, issues } = safeParse(schema, json, { abortEarly: true, message: '' });
  if (success) return { kind: 'read', value: output };
  return brokenImport(`The ${source} cannot be read: ${issueSentence(issues[0])}`);
}

function isTooDeep(json: unknown): boolean {
  let level = [json];
  for (let depth = 0; depth < MAX_DEPTH && level.length > 0; depth++) {
    level = level.flatMap((one) =>
      typeof one === 'object' && one !== null ? (Object.values(one) as unknown[]) : [],
    );
  }
  return level.length > 0;
}
