import type { MappingDraft } from '../model/mapping-draft.ts';

/** Options of the direction. */
export const DIRECTIONS = [
  { value: 'in', text: 'In' },
  { value: 'out', text: 'Out' },
  { value: 'both', text: 'Both' },
];

/** How a form names the other side. */
export interface FormWords {
  readonly foreign: string;
  readonly foreignHint: string;
  readonly foreignExample: string;
  readonly topicExample: string;
}

const WORDS: Readonly<Record<string, FormWords>> = {
  mqtt: {
    foreign: 'MQTT topic',
    foreignHint: '+ and # select, {1} and {2} stand for what the topic selects.',
    foreignExample: 'sensors/+/temp',
    topicExample: '/mqtt/{1}/temp',
  },
  osc: {
    foreign: 'OSC address',
    foreignHint: '+ and # select, {1} and {2} stand for what the topic selects.',
    foreignExample: '/fader/+',
    topicExample: '/osc/fader/{1}',
  },
  rosbridge: {
    foreign: 'ROS topic',
    foreignHint: 'One topic for direction in; {1} and {2} stand for what the topic selects.',
    foreignExample: '/cmd_vel',
    topicExample: '/robot/drive',
  },
};

export function wordsOf(protocol: string): FormWords {
  return WORDS[protocol] ?? WORDS['mqtt']!;
}

type TextMember = {
  [M in keyof MappingDraft]: MappingDraft[M] extends string ? M : never;
}[keyof MappingDraft];

/** Fields that few mappings need. */
export const LIMIT_FIELDS: readonly {
  readonly member: TextMember;
  readonly label: string;
  readonly unit?: string;
  readonly placeholder: string;
}[] = [
  { member: 'name', label: 'Name', placeholder: 'made of both sides' },
  { member: 'maxRateHz', label: 'Maximum rate', unit: '/s', placeholder: 'no limit' },
  { member: 'maxTopics', label: 'Maximum topics', placeholder: '1000' },
  { member: 'maxBytes', label: 'Maximum message', unit: 'bytes', placeholder: '4194304' },
];
