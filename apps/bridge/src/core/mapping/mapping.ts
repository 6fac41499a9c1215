import type { DataFormat } from '@ubii/proto';
import type { AddressPath } from './address-path.ts';

/** Kind of system that a bridge connects with a master. */
export type Protocol = 'mqtt' | 'osc' | 'rosbridge';

/** `in`: into the master, `out`: from the master into the other system. */
export type Direction = 'in' | 'out' | 'both';

/** How a message of MQTT carries a value. */
export const PAYLOADS = ['json', 'text', 'number', 'bytes', 'protobuf'] as const;
/** `event` is for Home Assistant only, and in no mapping file. */
export type PayloadKind = (typeof PAYLOADS)[number] | 'event';

export type Qos = 0 | 1 | 2;

/** One mapping between topics of the master and addresses of the other system. */
export interface Mapping {
  /** Unique. */
  readonly name: string;
  readonly direction: Direction;
  /** Addresses of the other system. */
  readonly foreign: AddressPath;
  /** Topics of the master. */
  readonly topic: AddressPath;
  /** Data format of the topics; `undefined`: any, as the record says. */
  readonly format: DataFormat | undefined;
  /** MQTT only. */
  readonly payload: PayloadKind;
  /** Members and indices that lead to the value in JSON; empty: the value is the whole message. */
  readonly field: readonly (string | number)[];
  readonly qos: Qos;
  /** Whether the other system keeps the newest message, as MQTT does. */
  readonly retained: boolean;
  /** Message type of ROS, such as `std_msgs/Float64`; empty for other systems. */
  readonly rosType: string;
  /** rosbridge only: how messages come, and how many it keeps while the bridge is slow. */
  readonly compression: 'none' | 'cbor';
  readonly queueLength: number;
  /** OSC only: messages leave in bundles with the time of the value. */
  readonly timeTag: boolean;
  /** Messages of one address or topic per second; the newest is never withheld permanently. 0: no limit */
  readonly maxRateHz: number;
  readonly maxTopics: number;
  readonly maxBytes: number;
}

/** Members of a mapping that only OSC and rosbridge have, where they mean nothing. */
export const OTHER_PROTOCOLS = {
  rosType: '',
  compression: 'none',
  queueLength: 1,
  timeTag: false,
} as const;

export const takesIn = ({ direction }: Pick<Mapping, 'direction'>): boolean => direction !== 'out';
export const givesOut = ({ direction }: Pick<Mapping, 'direction'>): boolean => direction !== 'in';

/** Whether two mappings say the same, member by member. */
export function isSameMapping(one: Mapping, other: Mapping): boolean {
  return one === other || isSame(one, other);
}

/** Of plain objects, lists, and values without members. */
function isSame(one: unknown, other: unknown): boolean {
  if (typeof one !== 'object' || typeof other !== 'object' || one === null || other === null) {
    return Object.is(one, other);
  }
  const [members, others] = [one, other] as Readonly<Record<string, unknown>>[];
  const names = new Set([...Object.keys(members!), ...Object.keys(others!)]);
  return [...names].every((name) => isSame(members![name], others![name]));
}
