import { parseJson } from './parse-json.ts';
import type { RawOutput } from '../encode-outputs.ts';
import { describeThrown } from '../module-error.ts';

/** Result of a call inside the engine. */
export type CallResult =
  | {
      readonly kind: 'done';
      readonly outputs: readonly RawOutput[];
      readonly problem: string | undefined;
      readonly undeclared?: readonly string[] | undefined;
    }
  | { readonly kind: 'threw'; readonly thrown: ThrownText };

/** Something that was thrown inside. */
export interface ThrownText {
  readonly name: string;
  readonly message: string;
  readonly stack: string;
}

/**
 * Reads the text that the prelude gave. It is text of the author's world: anything may be in it.
 *
 * @param blobOf bytes by their number in the text
 */
export function readResult(
  text: string,
  outputNames: readonly string[],
  blobOf: (index: number) => Uint8Array | undefined,
): CallResult {
  let root: unknown;
  try {
    root = parseJson(text, blobOf);
  } catch (thrown) {
    return { kind: 'done', outputs: [], problem: describeThrown(thrown) };
  }
  const { error, problem, outputs, undeclared } = asObject(root);
  if (error !== undefined) return { kind: 'threw', thrown: readThrown(error) };
  return {
    kind: 'done',
    problem: typeof problem === 'string' ? problem : undefined,
    outputs: Array.isArray(outputs)
      ? outputs.flatMap((entry) => readOutput(entry, outputNames))
      : [],
    ...(Array.isArray(undeclared) && {
      undeclared: undeclared.filter((name) => typeof name === 'string'),
    }),
  };
}

/** Reads the output of the prelude's `describe`. */
export function readThrown(described: unknown): ThrownText {
  const [name, message, stack] = (Array.isArray(described) ? described : []).map((part) =>
    typeof part === 'string' ? part : '',
  );
  return { name: name ?? '', message: message ?? '', stack: stack ?? '' };
}

function readOutput(entry: unknown, outputNames: readonly string[]): RawOutput[] {
  if (!Array.isArray(entry)) return [];
  const name = outputNames[Number(entry[0])];
  if (name === undefined) return [];
  return entry.length > 2
    ? [{ name, problem: readThrown(entry[2]).message || 'the value cannot be sent.' }]
    : [{ name, value: entry[1] as unknown }];
}

function asObject(value: unknown): Record<string, unknown> {
  return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : {};
}
