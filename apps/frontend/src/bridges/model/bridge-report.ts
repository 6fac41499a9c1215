import * as v from 'valibot';
import { finite, textCutAt, validElements } from '../../json/schemas.ts';
import { readStored } from '../../json/read-stored.ts';

/** Longest report that is read, characters: 200 mappings with two directions each. */
const MAX_CHARS = 1_000_000;
const MAX_MAPPINGS = 400;

const TOPIC = /^\/([^/]+)\/bridge$/;

/** Topics of the reports of all bridges. [BR-33] */
export const BRIDGE_TOPICS = '/*/bridge';

/** Client whose report is on a topic; `undefined` for other topics. */
export function bridgeOfTopic(topic: string): string | undefined {
  return TOPIC.exec(topic)?.[1];
}

const text = textCutAt(400);
const number = v.fallback(finite, 0);

const lane = v.object({
  passed: number,
  refused: number,
  dropped: number,
  returned: number,
  evicted: number,
  topics: number,
  lastError: v.fallback(
    v.optional(v.object({ message: text, atMs: number, address: text })),
    undefined,
  ),
  lastValue: v.fallback(v.optional(v.object({ address: text, text, atMs: number })), undefined),
});

const SCHEMA = v.object({
  version: v.literal(1),
  protocol: text,
  system: text,
  file: text,
  revision: text,
  status: v.fallback(v.picklist(['connecting', 'connected', 'waiting', 'closed']), 'connecting'),
  reason: text,
  isStandingBy: v.fallback(v.boolean(), false),
  overRate: number,
  refused: number,
  lastRefusal: text,
  homeAssistant: v.fallback(v.optional(v.object({ entities: number, skipped: number })), undefined),
  mappings: validElements(
    v.object({
      name: text,
      in: v.fallback(v.optional(lane), undefined),
      out: v.fallback(v.optional(lane), undefined),
    }),
    MAX_MAPPINGS,
  ),
});

/** How a bridge does, as it says itself. [BR-33] */
export type BridgeReport = v.InferOutput<typeof SCHEMA>;
/** How one direction of a mapping does. */
export type LaneReport = v.InferOutput<typeof lane>;
export type MappingReport = BridgeReport['mappings'][number];

/** Parses a report; `undefined` for a text that is none. */
export function readBridgeReport(json: string): BridgeReport | undefined {
  return readStored(SCHEMA, json, MAX_CHARS);
}
