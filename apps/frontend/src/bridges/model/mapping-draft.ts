import { isSameValue } from '@ubii/proto';
import { nameOf, type WrittenMapping } from './mapping-changes.ts';

/** What a form for a mapping holds: texts as they are typed. */
export interface MappingDraft {
  name: string;
  direction: string;
  foreign: string;
  topic: string;
  /** Empty: any. */
  format: string;
  payload: string;
  field: string;
  qos: string;
  retained: boolean;
  timeTag: boolean;
  type: string;
  compression: string;
  queueLength: string;
  maxRateHz: string;
  maxTopics: string;
  maxBytes: string;
}

export type DraftMember = keyof MappingDraft;

/** Members of mappings besides those that all protocols have, by protocol. */
const OWN_MEMBERS: Readonly<Record<string, readonly DraftMember[]>> = {
  mqtt: ['payload', 'field', 'qos', 'retained'],
  osc: ['timeTag'],
  rosbridge: ['type', 'compression', 'queueLength', 'retained'],
};

/** Whether mappings of this protocol have a member. */
export function hasMember(protocol: string, member: DraftMember): boolean {
  return OWN_MEMBERS[protocol]?.includes(member) ?? false;
}

const NUMBERS: readonly DraftMember[] = [
  'qos',
  'queueLength',
  'maxRateHz',
  'maxTopics',
  'maxBytes',
];
const FLAGS: readonly DraftMember[] = ['retained', 'timeTag'];
const COMMON: readonly DraftMember[] = ['name', 'direction', 'foreign', 'topic', 'format'];
const LIMITS: readonly DraftMember[] = ['maxRateHz', 'maxTopics', 'maxBytes'];

/** What a member means when it is not written, where a form has to show something. */
const DEFAULTS: MappingDraft = {
  name: '',
  direction: 'in',
  foreign: '',
  topic: '',
  format: '',
  payload: 'json',
  field: '',
  qos: '0',
  retained: false,
  timeTag: false,
  type: '',
  compression: 'none',
  queueLength: '',
  maxRateHz: '',
  maxTopics: '',
  maxBytes: '',
};

/** The form for a mapping; for a new one without an argument. */
export function draftOf(mapping: WrittenMapping = { format: 'double' }): MappingDraft {
  const draft: Record<string, string | boolean> = { ...DEFAULTS };
  for (const member of Object.keys(DEFAULTS)) {
    const value = mapping[member];
    if (typeof value === 'boolean' || typeof value === 'string') draft[member] = value;
    else if (typeof value === 'number') draft[member] = String(value);
  }
  return draft as unknown as MappingDraft;
}

/**
 * The mapping that a form means. Members keep their order where the mapping had them before; what is the default is not written
 * unless it was. A number that is none stays a text, which the bridge refuses with a reason.
 */
export function mappingOf(
  draft: MappingDraft,
  protocol: string,
  before: WrittenMapping = {},
): WrittenMapping {
  const members = [...COMMON, ...(OWN_MEMBERS[protocol] ?? []), ...LIMITS];
  const after: Record<string, unknown> = { ...before };
  for (const member of members) {
    const value = valueOf(draft, member);
    const isDefault = draft[member] === DEFAULTS[member];
    if (value !== undefined && (!isDefault || member in before || member === 'direction')) {
      after[member] = value;
    } else delete after[member];
  }
  return after;
}

/** True for a draft that would change nothing. */
export function isUnchanged(
  draft: MappingDraft,
  protocol: string,
  before: WrittenMapping,
): boolean {
  return isSameValue(mappingOf(draft, protocol, before), before);
}

/** Words that stand for a mapping in a sentence. */
export function wordsFor(mapping: WrittenMapping): string {
  const name = nameOf(mapping);
  return name.length > 60 ? `${name.slice(0, 59)}…` : name;
}

function valueOf(draft: MappingDraft, member: DraftMember): unknown {
  const value = draft[member];
  if (FLAGS.includes(member)) return value;
  const text = String(value).trim();
  if (text === '') return undefined;
  if (!NUMBERS.includes(member)) return text;
  const number = Number(text);
  return Number.isNaN(number) ? text : number;
}
