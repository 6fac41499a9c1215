import { constantRecord } from '@ubii/pm-sandbox';
import {
  DATA_FORMATS,
  fromJson,
  parseDataFormat,
  type IOMapping,
  type JsonValue,
} from '@ubii/proto';
import { capitalised } from '@ubii/words';
import { initialJson, neutralJson } from '../../draft/io-default.ts';
import type { IoDraft, ModuleDraft } from '../../draft/module-draft.ts';

/** Source of an input's values in the try-out. */
export interface TryInput {
  /** `form`: members as fields; `json`: a record as text; `topic`: live records of the master. */
  readonly source: 'form' | 'json' | 'topic';
  /** Elements of a list; a single input uses the first. */
  readonly values: readonly JsonValue[];
  readonly json: string;
  /** Topic; a glob for lists. */
  readonly topic: string;
}

/** Member of a value that a form can set. */
export interface ValueLeaf {
  /** Path such as `position.x`; empty for the value itself. */
  readonly path: string;
  readonly value: number | string | boolean;
}

/** Most members of a form; larger values are easier to write as JSON. */
const MAX_LEAVES = 16;

/** Whether a form can set values of this format: not for bytes, nor for messages of the master. */
export function hasForm(formatText: string): boolean {
  const format = parseDataFormat(formatText);
  const family = DATA_FORMATS[format ?? 'double'].family;
  return (
    family !== 'image' && family !== 'system' && leavesOf(neutralJson(formatText)) !== undefined
  );
}

/** Returns the members of a value that a form can set; `undefined` when there are none or too many. */
export function leavesOf(value: JsonValue): readonly ValueLeaf[] | undefined {
  const leaves: ValueLeaf[] = [];
  const collect = (part: JsonValue, path: string): boolean => {
    if (typeof part === 'number' || typeof part === 'string' || typeof part === 'boolean') {
      leaves.push({ path, value: part });
      return leaves.length <= MAX_LEAVES;
    }
    if (part === null || Array.isArray(part)) return false;
    return Object.entries(part).every(([name, inner]) =>
      collect(inner as JsonValue, path === '' ? name : `${path}.${name}`),
    );
  };
  return collect(value, '') && leaves.length > 0 ? leaves : undefined;
}

/** Returns the value with one member changed. */
export function withLeaf(value: JsonValue, path: string, leaf: ValueLeaf['value']): JsonValue {
  if (path === '') return leaf;
  const [name = '', ...rest] = path.split('.');
  const object = value as Record<string, JsonValue>;
  return { ...object, [name]: withLeaf(object[name] ?? {}, rest.join('.'), leaf) };
}

/** Returns the initial state of an input: its default, if it has one. */
export function newTryInput(io: IoDraft): TryInput {
  const value = initialJson(io);
  const format = parseDataFormat(io.format) ?? 'double';
  return {
    source: hasForm(io.format) ? 'form' : 'json',
    values: io.isList ? [value, value] : [value],
    json: JSON.stringify(io.isList ? [{ [format]: value }] : { [format]: value }, undefined, 2),
    topic: '',
  };
}

const topicOf = (name: string): string => `/try/${name}`;

/** Records to publish, or the reason why there are none. */
export type TryRecords =
  | { readonly records: readonly { readonly topic: string; readonly bytes: Uint8Array }[] }
  | { readonly problem: string };

/** Returns the records of a form or text; none for a topic. */
export function recordsOf(io: IoDraft, input: TryInput): TryRecords {
  if (input.source === 'topic') return { records: [] };
  const format = parseDataFormat(io.format);
  let members: unknown[];
  if (input.source === 'form') {
    members = input.values
      .slice(0, io.isList ? undefined : 1)
      .map((value) => ({ [format ?? 'double']: value }));
  } else {
    if (input.json.trim() === '') return { records: [] };
    try {
      const parsed = JSON.parse(input.json) as unknown;
      members = Array.isArray(parsed) ? parsed : [parsed];
    } catch (cause) {
      return { problem: `This is not JSON: ${cause instanceof Error ? cause.message : ''}` };
    }
    if (!io.isList && members.length !== 1) return { problem: 'Enter one record, not a list.' };
  }
  const records: { topic: string; bytes: Uint8Array }[] = [];
  for (const [index, member] of members.entries()) {
    const read = constantRecord(JSON.stringify(member), format);
    if ('problem' in read) {
      const problem = read.problem.replace(/the constant/, 'this');
      return { problem: `${capitalised(problem)}.` };
    }
    const topic = io.isList ? `${topicOf(io.name)}/${index + 1}` : topicOf(io.name);
    records.push({ topic, bytes: read.bytes });
  }
  return { records };
}

/**
 * Maps inputs to topics of the try-out. Outputs are mapped as in a session, to a single topic or a list, to get the
 * same errors; their records are dropped.
 */
export function tryMapping(
  { inputs, outputs }: Pick<ModuleDraft, 'inputs' | 'outputs'>,
  inputOf: (name: string) => TryInput | undefined,
): IOMapping {
  return fromJson('ubii.sessions.IOMapping', {
    inputMappings: inputs.map((io) => {
      const input = inputOf(io.name);
      const live = input?.source === 'topic' ? input.topic : '';
      if (!io.isList) return { inputName: io.name, topic: live || topicOf(io.name) };
      const topicGlob = live || `${topicOf(io.name)}/*`;
      const topicMux = live
        ? { id: io.name, topicGlob }
        : { id: io.name, topicGlob, identityMatchPattern: '[^/]+$' };
      return { inputName: io.name, topicMux };
    }),
    outputMappings: outputs.map(({ name, isList }) =>
      isList
        ? { outputName: name, topicDemux: { outputTopicFormat: topicOf(`out/${name}`) } }
        : { outputName: name, topic: topicOf(`out/${name}`) },
    ),
  });
}
