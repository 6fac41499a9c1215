/** The published `@tum-far/ubii-msg-formats` 0.16.6, which existing clients are built on. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

const require = createRequire(import.meta.url);

/** A message class of protobufjs 6. */
export interface PublishedMessage {
  encode(message: object): { finish(): Uint8Array };
  decode(bytes: Uint8Array): object;
  toObject(message: object, options: object): Record<string, unknown>;
}

const folder = dirname(require.resolve('@tum-far/ubii-msg-formats/package.json'));
const root = require('@tum-far/ubii-msg-formats/dist/js/protobuf.js') as Record<string, unknown>;

/** Folder of its .proto files. */
export const PUBLISHED_SCHEMA_FOLDER = join(folder, 'src');

/** Its constants.json. */
export const PUBLISHED_CONSTANTS = JSON.parse(
  readFileSync(join(folder, 'dist', 'constants.json'), 'utf8'),
) as {
  DEFAULT_TOPICS: { SERVICES: Record<string, string>; INFO_TOPICS: Record<string, string> };
  MSG_TYPES: Record<string, string>;
};

/** One of its messages by its full name; undefined when it has none. */
export function publishedMessage(type: string): PublishedMessage | undefined {
  let node: unknown = root;
  for (const part of type.split('.')) node = (node as Record<string, unknown> | undefined)?.[part];
  return node as PublishedMessage | undefined;
}

/** Decodes with it into a plain object of the shape our `decode` gives, absent members left out. */
export function decodePublished(message: PublishedMessage, bytes: Uint8Array): object {
  const plain = message.toObject(message.decode(bytes), {
    defaults: true,
    arrays: true,
    longs: Number,
  });
  return withoutNulls(plain) as object;
}

function withoutNulls(value: unknown): unknown {
  if (value instanceof Uint8Array) return new Uint8Array(value);
  if (Array.isArray(value)) return value.map(withoutNulls);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(
    Object.entries(value)
      .filter(([, member]) => member !== null)
      .map(([key, member]) => [key, withoutNulls(member)]),
  );
}
