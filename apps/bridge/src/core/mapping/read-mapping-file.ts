import * as v from 'valibot';
import { BRIDGE_LIMITS } from '../limits.ts';
import { findMappingProblems } from './find-mapping-problems.ts';
import { predicateOf } from './mapping-fault.ts';
import type { Mapping, Protocol } from './mapping.ts';
import { address } from './written-mapping.ts';

/** Discovery of Home Assistant: `prefix` of its topics, `topics` for the values. */
export interface HomeAssistantSettings {
  readonly prefix: string;
  readonly topics: string;
}

/** A mapping file. */
export interface MappingFile {
  /** Name of the other system, for bridges that reach the same one under different addresses. [BR-22] */
  readonly system: string | undefined;
  /** Address at which the bridge says whether it is there; MQTT only. */
  readonly availability: string | undefined;
  readonly homeAssistant: HomeAssistantSettings | undefined;
  /** Without those that are switched off. */
  readonly mappings: readonly Mapping[];
}

const FILES = {
  mqtt: fileOf({
    availability: v.optional(address),
    homeAssistant: v.optional(
      v.strictObject({ prefix: v.optional(address), topics: v.optional(address) }),
    ),
  }),
  osc: fileOf({}),
  rosbridge: fileOf({}),
};

function fileOf<E extends v.ObjectEntries>(entries: E) {
  const most = `must be a list of at most ${BRIDGE_LIMITS.mappings} mappings`;
  return v.strictObject({
    version: v.literal(1, 'must be 1'),
    system: v.optional(address),
    mappings: v.pipe(v.array(v.unknown(), most), v.maxLength(BRIDGE_LIMITS.mappings, most)),
    ...entries,
  });
}

interface WrittenFile {
  readonly system?: string | undefined;
  readonly availability?: string | undefined;
  readonly homeAssistant?:
    | { readonly prefix?: string | undefined; readonly topics?: string | undefined }
    | undefined;
  readonly mappings: readonly unknown[];
}

/**
 * Reads a mapping file. [BR-1]
 *
 * @throws Error with one sentence: where, what, and what to write instead
 */
export function readMappingFile(text: string, protocol: Protocol): MappingFile {
  const written = parseFile(text, protocol);
  const { problems, mappings, disabled } = findMappingProblems(written.mappings, protocol);
  if (problems[0] !== undefined) throw new Error(problems[0].sentence);
  const { system, availability, homeAssistant } = written;
  if (availability !== undefined) expectTopicName(availability, 'availability');
  return {
    system,
    availability,
    mappings: mappings.filter(
      (mapping, index): mapping is Mapping => mapping !== undefined && !disabled.has(index),
    ),
    homeAssistant: homeAssistant && {
      prefix: homeAssistant.prefix ?? 'homeassistant',
      topics: homeAssistant.topics ?? 'ubii',
    },
  };
}

function parseFile(text: string, protocol: Protocol): WrittenFile {
  if (text.length > BRIDGE_LIMITS.mappingFileChars) {
    throw new Error(
      `The mapping has more than ${BRIDGE_LIMITS.mappingFileChars} characters. Divide it between several bridges.`,
    );
  }
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (error) {
    throw new Error(`The mapping is not JSON: ${(error as Error).message}.`, { cause: error });
  }
  const result = v.safeParse(FILES[protocol], json, { abortEarly: true });
  if (!result.success) throw new Error(sentence(result.issues[0]));
  return result.output as WrittenFile;
}

function expectTopicName(topic: string, place: string): void {
  if (!/[+#]/.test(topic)) return;
  throw new Error(`${place}: "${topic}" has a wildcard. Write one topic.`);
}

/** Says where and what: `homeAssistant.prefix must be a text.` */
function sentence(issue: v.BaseIssue<unknown>): string {
  const place = (issue.path ?? []).map(({ key }) => String(key)).join('.');
  return `${place || 'The mapping'} ${predicateOf(issue, place === '')}`;
}
