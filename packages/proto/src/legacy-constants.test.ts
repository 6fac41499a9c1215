import { describe, expect, it } from 'vitest';
import { LEGACY_CONSTANTS } from './legacy-constants.ts';
import { PUBLISHED_CONSTANTS } from './testing/published-formats.ts';

/** Keys that the Python node 0.3.0 does not know, and does not connect because of. */
const UNKNOWN_TO_PYTHON = [
  'NOTIFY_CONDITION_ADD',
  'NOTIFY_CONDITION_REMOVE',
  'NOTIFY_CONDITION_GET_LIST',
  'REGEX_DEVICE_INFOS',
  'NEW_DEVICE',
  'DELETE_DEVICE',
  'NOTIFY_CONDITION',
];

function known(constants: Record<string, string>): Record<string, string> {
  return Object.fromEntries(
    Object.entries(constants).filter(([key]) => !UNKNOWN_TO_PYTHON.includes(key)),
  );
}

describe('LEGACY_CONSTANTS [SV-10] [EC-3]', () => {
  it('are the published constants without the keys the strictest client does not know', () => {
    expect(JSON.parse(JSON.stringify(LEGACY_CONSTANTS))).toEqual({
      DEFAULT_TOPICS: {
        SERVICES: known(PUBLISHED_CONSTANTS.DEFAULT_TOPICS.SERVICES),
        INFO_TOPICS: known(PUBLISHED_CONSTANTS.DEFAULT_TOPICS.INFO_TOPICS),
      },
      MSG_TYPES: known(PUBLISHED_CONSTANTS.MSG_TYPES),
    });
  });
});
