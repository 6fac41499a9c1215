import { crc32 } from 'node:zlib';
import type { Random } from '../random.ts';
import { joined, mutateBytes } from './mutate-bytes.ts';
import { mutateJson } from './mutate-json.ts';
import { mutateWire } from './mutate-wire.ts';

/** A record of MCAP, at the top of a file or in a chunk. Source: mcap.dev/spec. */
interface McapPart {
  readonly opcode: number;
  readonly content: Uint8Array;
  /** Where it began in the file that was mutated; -1 for a new one. */
  readonly from: number;
  /** States another length than its content has. */
  readonly statedLength?: bigint;
}

const MAGIC = Uint8Array.of(0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a);
const HEAD_BYTES = 9;
const MAX_CHANGES = 3;

const FOOTER = 0x02;
const MESSAGE = 0x05;
const CHUNK = 0x06;
const CHUNK_INDEX = 0x08;
const ATTACHMENT_INDEX = 0x0a;
const METADATA = 0x0c;
const METADATA_INDEX = 0x0d;
const SUMMARY_OFFSET = 0x0e;

/** Places of offsets, and of the lengths that belong to them, in records of the summary. */
const POINTERS: Readonly<
  Record<number, readonly { readonly at: number; readonly length?: number }[]>
> = {
  [FOOTER]: [{ at: 0 }, { at: 8 }],
  [CHUNK_INDEX]: [{ at: 16, length: 24 }],
  [ATTACHMENT_INDEX]: [{ at: 0, length: 8 }],
  [METADATA_INDEX]: [{ at: 0, length: 8 }],
  [SUMMARY_OFFSET]: [{ at: 1 }],
};

/** Lengths, offsets, counts and times that a reader may stumble over. */
const NUMBERS = [
  ...[0n, 1n, 8n, 9n, 100n, 0x7fn, 0xffffn, 1n << 20n, (1n << 31n) - 1n, 1n << 31n],
  ...[(1n << 32n) - 1n, 3n << 30n, 1n << 40n, 1n << 53n, 1n << 63n, (1n << 64n) - 1n],
];

/** Changes an MCAP file so that it stays plausible: offsets and checksums fit, except where they are meant to lie. */
export function mutateMcap(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  const parts = readParts(seed.subarray(MAGIC.length), MAGIC.length);
  if (parts === undefined || parts.length === 0) return mutateBytes(random, seed, other);
  const changes = random.below(MAX_CHANGES + 1);
  let changed = parts;
  for (let i = 0; i < changes; i++) changed = changeParts(random, changed, other);
  if (changes > 0) changed = fitPointers(changed);
  const lies = changes === 0 ? 1 + random.below(MAX_CHANGES) : random.below(2);
  for (let i = 0; i < lies; i++) changed = lie(random, changed, seed.length);
  const file = joined(MAGIC, ...changed.map(written), MAGIC);
  return random.oneIn(12) ? file.subarray(0, random.below(file.length)) : file;
}

/** @returns undefined when the bytes are no row of records */
function readParts(bytes: Uint8Array, from: number): McapPart[] | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts: McapPart[] = [];
  for (let at = 0; at + HEAD_BYTES <= bytes.length;) {
    const length = Number(view.getBigUint64(at + 1, true));
    const end = at + HEAD_BYTES + length;
    if (end > bytes.length) return undefined;
    parts.push({
      opcode: bytes[at]!,
      content: bytes.subarray(at + HEAD_BYTES, end),
      from: from + at,
    });
    at = end;
  }
  return parts;
}

function written({ opcode, content, statedLength }: McapPart): Uint8Array {
  const head = new Uint8Array(HEAD_BYTES);
  head[0] = opcode;
  new DataView(head.buffer).setBigUint64(1, statedLength ?? BigInt(content.length), true);
  return joined(head, content);
}

function changeParts(random: Random, parts: readonly McapPart[], other: Uint8Array): McapPart[] {
  const at = random.below(parts.length);
  const part = parts[at]!;
  const put = (...instead: readonly McapPart[]): McapPart[] => [
    ...parts.slice(0, at),
    ...instead,
    ...parts.slice(at + 1),
  ];
  switch (random.below(8)) {
    case 0:
      return put();
    case 1:
      return put(
        part,
        ...Array.from({ length: random.oneIn(10) ? 1_000 : 2 }, () => ({ ...part, from: -1 })),
      );
    case 2: {
      const place = random.below(parts.length);
      return put(parts[place]!).map((one, index) => (index === place ? part : one));
    }
    default:
      return put({ ...part, content: changeContent(random, part, other) });
  }
}

function changeContent(
  random: Random,
  { opcode, content }: McapPart,
  other: Uint8Array,
): Uint8Array {
  if (opcode === CHUNK) return changeChunk(random, content, other);
  if (opcode === MESSAGE && content.length > 22) {
    const data = content.subarray(22);
    return joined(content.subarray(0, 22), changeMessage(random, data, other));
  }
  if (opcode === METADATA && random.oneIn(3)) return longText(random, content);
  return mutateBytes(random, content, other);
}

function changeMessage(random: Random, data: Uint8Array, other: Uint8Array): Uint8Array {
  if (data[0] !== 0x7b) return mutateWire(random, data, other);
  const json = JSON.stringify(mutateJson(random, JSON.parse(Buffer.from(data).toString())));
  return Buffer.from(json ?? 'null');
}

/** Changes the records in a chunk that is not compressed; sizes and checksum fit. */
function changeChunk(random: Random, content: Uint8Array, other: Uint8Array): Uint8Array {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const isPlain = content.length >= 40 && view.getUint32(28, true) === 0;
  const inner = isPlain ? readParts(content.subarray(40), 0) : undefined;
  if (inner === undefined || inner.length === 0) return mutateBytes(random, content, other);
  let changed = changeParts(random, inner, other);
  if (random.oneIn(4)) changed = lie(random, changed, content.length);
  const records = joined(...changed.map(written));
  const head = new Uint8Array(content.subarray(0, 40));
  const headView = new DataView(head.buffer);
  headView.setBigUint64(16, BigInt(records.length), true);
  headView.setUint32(24, crc32(records), true);
  headView.setBigUint64(32, BigInt(records.length), true);
  return joined(head, records);
}

/** A key of a metadata record gets a long text. */
function longText(random: Random, content: Uint8Array): Uint8Array {
  const text = Buffer.alloc(1 + random.below(200_000), 'n');
  const key = random.pick(['name', 'notes', 'selection', 'personalData', 'kind']);
  const entry = joined(uint32(key.length), Buffer.from(key), uint32(text.length), text);
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const mapAt = 4 + view.getUint32(0, true);
  if (mapAt + 4 > content.length) return content;
  const entries = joined(content.subarray(mapAt + 4), entry);
  return joined(content.subarray(0, mapAt), uint32(entries.length), entries);
}

/** Moves offsets in the summary to where the records are now. */
function fitPointers(parts: readonly McapPart[]): McapPart[] {
  const places = new Map<bigint, { readonly at: bigint; readonly length: bigint }>();
  let at = BigInt(MAGIC.length);
  for (const { content, from } of parts) {
    const length = BigInt(HEAD_BYTES + content.length);
    if (from >= 0) places.set(BigInt(from), { at, length });
    at += length;
  }
  return parts.map((part) => {
    const content = new Uint8Array(part.content);
    const view = new DataView(content.buffer);
    for (const pointer of POINTERS[part.opcode] ?? []) {
      if (Math.max(pointer.at, pointer.length ?? 0) + 8 > content.length) continue;
      const place = places.get(view.getBigUint64(pointer.at, true));
      if (place === undefined) continue;
      view.setBigUint64(pointer.at, place.at, true);
      if (pointer.length !== undefined) view.setBigUint64(pointer.length, place.length, true);
    }
    // 0: the summary has no checksum.
    if (part.opcode === FOOTER && content.length >= 20) view.setUint32(16, 0, true);
    return { ...part, content };
  });
}

/** A number of a record becomes another one, or the record states another length. */
function lie(random: Random, parts: readonly McapPart[], fileBytes: number): McapPart[] {
  const indexes = parts.flatMap(({ opcode }, index) => (POINTERS[opcode] ? [index] : []));
  const at =
    indexes.length > 0 && !random.oneIn(3) ? random.pick(indexes) : random.below(parts.length);
  const part = parts[at];
  if (part === undefined) return [...parts];
  const value = random.oneIn(4) ? BigInt(random.below(fileBytes + 2)) : random.pick(NUMBERS);
  const replaced = random.oneIn(6)
    ? { ...part, statedLength: value }
    : { ...part, content: withNumber(random, part, value) };
  return parts.map((one, index) => (index === at ? replaced : one));
}

function withNumber(random: Random, { opcode, content }: McapPart, value: bigint): Uint8Array {
  const known = (POINTERS[opcode] ?? []).flatMap(({ at, length }) => [at, length ?? at]);
  const at =
    known.length > 0 && !random.oneIn(3) ? random.pick(known) : random.below(content.length);
  const copy = new Uint8Array(content);
  const view = new DataView(copy.buffer);
  const width = known.includes(at) ? 8 : random.pick([2, 4, 8]);
  if (at + width > copy.length) return copy;
  if (width === 8) view.setBigUint64(at, value, true);
  else if (width === 4) view.setUint32(at, Number(value & 0xffff_ffffn), true);
  else view.setUint16(at, Number(value & 0xffffn), true);
  return copy;
}

function uint32(value: number): Uint8Array {
  const bytes = new Uint8Array(4);
  new DataView(bytes.buffer).setUint32(0, value, true);
  return bytes;
}
