import { DEFAULT_PATTERN_LIMITS } from '@ubii/patterns';
import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { MAX_NESTED_MESSAGES } from '@ubii/proto/wire';
import { MIB, limit } from './limit.ts';

/** Limits of messages and of the values in them. */
export const MESSAGE_LIMITS = {
  frameBytes: limit(
    32 * MIB,
    'bytes',
    'messages',
    'One WebSocket message. A raw 4K image (3840 x 2160 RGBA) is 31.6 MiB.',
  ),
  frameBytesOfPlayer: limit(
    8 * MIB,
    'bytes',
    'messages',
    'The same limit for a player or viewer. A picture of a phone camera at full resolution has some 5 MB, one of a video some 100 kB.',
  ),
  frameRecords: limit(
    MAX_NESTED_MESSAGES,
    'records',
    'messages',
    'Records of one WebSocket message. Further records of the message are refused. A large message is read in slices.',
  ),
  frameRecordsOfPlayer: limit(
    4_096,
    'records',
    'messages',
    'The same limit for a player or viewer. A phone with 20 topics at 60 Hz publishes so many in 3 s.',
  ),
  recordFields: limit(
    1_048_576,
    'fields',
    'messages',
    'Fields of one record, with those of nested messages. A record cannot be read in slices; its check takes some 25 ns per field. A list of 40 000 objects with poses has so many.',
  ),
  recordFieldsOfPlayer: limit(
    65_536,
    'fields',
    'messages',
    'The same limit for a player or viewer. Landmarks of a body, a face and hands have some 5000.',
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
