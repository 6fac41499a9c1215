import type { TypedValue } from '../payload/payload-codec.ts';

const [FIRST_SEED, SECOND_SEED] = [0x9747_b28c, 0x3c6e_f372];
const single = new Float32Array(1);
const singleBits = new Uint32Array(single.buffer);

/**
 * Returns a short text that stands for a value, 64 bits of it. Numbers of single precision are enough for two values to be the
 * same, because other systems carry no more; `int32` is compared as it is. [BR-23]
 */
export function contentHash({ format, value }: TypedValue): string {
  const hash = new WordHash();
  hash.addText(format);
  addValue(hash, value, format.startsWith('int32'));
  return hash.end();
}

function addValue(hash: WordHash, value: unknown, isWhole: boolean): void {
  switch (typeof value) {
    case 'number':
      return hash.addWord(isWhole ? value : bitsOf(value));
    case 'string':
      return hash.addText(value);
    case 'boolean':
      return hash.addWord(value ? 2 : 1);
    case 'object':
      if (value instanceof Uint8Array) hash.addBytes(value);
      else if (value !== null) addMembers(hash, value, isWhole);
      return;
    default:
      // What JSON has not, no value has.
      return hash.addWord(0);
  }
}

function addMembers(hash: WordHash, value: object, isWhole: boolean): void {
  const isList = Array.isArray(value);
  const members = Object.entries(value);
  hash.addWord(members.length);
  for (const [name, member] of members) {
    if (!isList) hash.addText(name);
    addValue(hash, member, isWhole);
  }
}

/** Bits in single precision; of both zeros the same. */
function bitsOf(number: number): number {
  single[0] = number + 0;
  return singleBits[0]!;
}

/** MurmurHash3 of 32 bits, twice with two seeds (Austin Appleby, https://github.com/aappleby/smhasher, public domain). */
class WordHash {
  #first = FIRST_SEED;
  #second = SECOND_SEED;
  #count = 0;

  addWord(word: number): void {
    this.#count++;
    this.#first = mixed(this.#first, word);
    this.#second = mixed(this.#second, word);
  }

  addText(text: string): void {
    this.addWord(text.length);
    for (let at = 0; at < text.length; at++) this.addWord(text.charCodeAt(at));
  }

  addBytes(bytes: Uint8Array): void {
    this.addWord(bytes.length);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const wholeWords = bytes.length & ~3;
    for (let at = 0; at < wholeWords; at += 4) this.addWord(view.getUint32(at));
    for (let at = wholeWords; at < bytes.length; at++) this.addWord(bytes[at]!);
  }

  end(): string {
    return [this.#first, this.#second]
      .map((half) => finished(half ^ this.#count).toString(16))
      .join('-');
  }
}

function mixed(hash: number, word: number): number {
  const scrambled = Math.imul(rotated(Math.imul(word, 0xcc9e_2d51), 15), 0x1b87_3593);
  return (Math.imul(rotated(hash ^ scrambled, 13), 5) + 0xe654_6b64) | 0;
}

function rotated(word: number, bits: number): number {
  return (word << bits) | (word >>> (32 - bits));
}

function finished(hash: number): number {
  const once = Math.imul(hash ^ (hash >>> 16), 0x85eb_ca6b);
  const twice = Math.imul(once ^ (once >>> 13), 0xc2b2_ae35);
  return (twice ^ (twice >>> 16)) >>> 0;
}
