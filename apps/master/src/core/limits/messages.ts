import { DEFAULT_PATTERN_LIMITS } from '@ubii/patterns';
import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { MIB, limit } from './limit.ts';

/** Limits of messages and of the values in them. */
export const MESSAGE_LIMITS = {
  frameBytes: limit(
    32 * MIB,
    'bytes',
    'messages',
    'One WebSocket message. A raw 4K image (3840 x 2160 RGBA) is 31.6 MiB.',
  ),
  serviceValues: limit(
    8_192,
    'values',
    'messages',
    'Values (texts, numbers, objects, lists) in an ordinary service request. The decoding time grows with their number.',
  ),
  largeServiceValues: limit(
    65_536,
    'values',
    'messages',
    'Values in a request with a session, modules, a registration or subscriptions. A session with 256 modules and 4096 mappings has some 30 000 values.',
  ),
  requestDepth: limit(
    64,
    'levels',
    'messages',
    'Nesting depth of objects and lists in a JSON request. The deepest request of the protocol has 16 levels.',
  ),
  topicBytes: limit(
    DEFAULT_TEXT_LIMITS.topicBytes,
    'bytes',
    'messages',
    'UTF-8 bytes of a topic. Usual topics consist of ids and short names and have some 100 bytes. With 1024 bytes, a full topic table still fits into memory.',
  ),
  patternLength: limit(
    DEFAULT_PATTERN_LIMITS.length,
    'characters',
    'messages',
    'Characters of a regular expression. The time to compile it and the size of the compiled program grow with its length.',
  ),
  patternInstructions: limit(
    DEFAULT_PATTERN_LIMITS.instructions,
    'instructions',
    'messages',
    'Instructions of a compiled regular expression: the worst-case cost for one character of a topic. A UUID pattern has about 60.',
  ),
  listElements: limit(
    20_000,
    'elements',
    'messages',
    'Elements of one list in a service request. Existing clients send a list of all topics they have used when they disconnect.',
  ),
  listProfiles: limit(
    64,
    'profiles',
    'messages',
    'Profiles in one list request. Each profile is compared with every listed item.',
  ),
} as const;
