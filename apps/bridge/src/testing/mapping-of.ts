import { parseSides } from '../core/mapping/address-path.ts';
import { OTHER_PROTOCOLS } from '../core/mapping/mapping.ts';
import type { Mapping } from '../core/mapping/mapping.ts';

/** A mapping with defaults. */
export function mappingOf(
  direction: Mapping['direction'],
  foreign: string,
  topic: string,
  more: Partial<Mapping> = {},
): Mapping {
  return {
    name: `${foreign} ${direction} ${topic}`,
    direction,
    format: 'double',
    payload: 'json',
    ...parseSides(foreign, topic, direction),
    field: [],
    qos: 0,
    retained: false,
    ...OTHER_PROTOCOLS,
    maxRateHz: 0,
    maxTopics: 1_000,
    maxBytes: 65_536,
    ...more,
  };
}
