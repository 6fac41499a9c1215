import type { Seat } from '../../sim/index.ts';

/** In the font of the names, at a size at which rounding does not matter. */
const SIZE_PX = 100;

/** Widths of texts as names are written, without asking the page for its layout. */
export class TextWidths {
  readonly #known = new Map<string, number>();
  readonly #context = document.createElement('canvas').getContext('2d');

  /** In font sizes. */
  of(text: string): number {
    let width = this.#known.get(text);
    if (width === undefined) {
      width = this.#measure(text);
      this.#known.set(text, width);
    }
    return width;
  }

  /** Measures again, such as when the font has come. */
  forget(): void {
    this.#known.clear();
  }

  #measure(text: string): number {
    // A browser without a canvas: as wide as its letters are on average
    if (!this.#context) return text.length * 0.55;
    this.#context.font = `700 ${SIZE_PX}px 'Bricolage Grotesque Variable', system-ui, sans-serif`;
    this.#context.fontStretch = 'semi-condensed';
    return this.#context.measureText(text).width / SIZE_PX;
  }
}

/** A token in the picture with its name. CSS pixels; its foot is at x, y. */
export interface NamedToken {
  readonly seat: Seat;
  readonly name: string;
  readonly x: number;
  readonly y: number;
  readonly height: number;
}

/** A name as it is written: below its token, perhaps shortened. */
export interface Sign {
  readonly seat: Seat;
  readonly text: string;
  /** Its middle, and its top. */
  readonly x: number;
  readonly y: number;
}

export interface SignStyle {
  /** Of a line, CSS pixels. */
  readonly lineHeight: number;
  /** Of the picture: names stay in it. */
  readonly width: number;
  /** Of a text, CSS pixels. */
  readonly widthOf: (text: string) => number;
}

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** A token hides less than its square: shapes have corners. Shares of its height. */
const TOKEN = { halfWidth: 0.4, top: 0.94 } as const;
/** A name that is not written yet needs so much room on all sides, pixels; one that is stays until it touches. */
const ROOM = 5;
const MIN_LETTERS = 3;
/** Shares of a token's height to which a name goes aside, into the gap between two nearer tokens. */
const ASIDE = [0, -0.3, 0.3, -0.55, 0.55] as const;

/**
 * Writes names so that none covers another name or a nearer token: moved aside, shortened, or left out.
 *
 * @param before the signs of the frame before: what was written stays, so that names do not flicker
 */
export function placeSigns(
  tokens: readonly NamedToken[],
  style: SignStyle,
  before: readonly Sign[] = [],
): Sign[] {
  const nearFirst = [...tokens].sort((a, b) => b.y - a.y || a.seat - b.seat);
  const firstWords = tokens.map(({ name }) => firstWordOf(name));
  const isShared = (text: string): boolean =>
    firstWords.indexOf(text) !== firstWords.lastIndexOf(text);
  const written = new Map(before.map((sign) => [sign.seat, sign.text]));
  const taken: Box[] = [];
  const signs: Sign[] = [];
  for (const token of nearFirst) {
    const found = findRoom(token, style, taken, written.get(token.seat), isShared);
    if (found) {
      signs.push(found.sign);
      taken.push(found.box);
    }
    taken.push(boxOfToken(token));
  }
  return signs;
}

function findRoom(
  token: NamedToken,
  style: SignStyle,
  taken: readonly Box[],
  before: string | undefined,
  isShared: (firstWord: string) => boolean,
): { readonly sign: Sign; readonly box: Box } | undefined {
  for (const text of textsOf(token.name, isShared)) {
    const room = text === before ? 0 : ROOM;
    const half = style.widthOf(text) / 2;
    for (const aside of ASIDE) {
      const wanted = token.x + aside * token.height;
      const x = Math.min(style.width - half - ROOM, Math.max(half + ROOM, wanted));
      const [left, right, top, bottom] = [x - half, x + half, token.y, token.y + style.lineHeight];
      const roomy = { left: left - room, right: right + room, top, bottom: bottom + room };
      if (taken.some((other) => meets(roomy, other))) continue;
      const box = { left, right, top, bottom };
      return { sign: { seat: token.seat, text, x, y: token.y }, box };
    }
  }
  return undefined;
}

const firstWordOf = (name: string): string => name.split(/\s/)[0] ?? name;

/** The name, its first word, and ever fewer letters of it. The text after a word that others share distinguishes them. */
function textsOf(name: string, isShared: (firstWord: string) => boolean): string[] {
  const first = firstWordOf(name);
  const rest = isShared(first) ? name.slice(first.length) : '';
  const texts = first + rest === name ? [name] : [name, first];
  const letters = [...first];
  for (let count = letters.length - 2; count >= MIN_LETTERS; count -= 1)
    texts.push(`${letters.slice(0, count).join('')}…${rest}`);
  return texts;
}

function boxOfToken({ x, y, height }: NamedToken): Box {
  const half = height * TOKEN.halfWidth;
  return { left: x - half, right: x + half, top: y - height * TOKEN.top, bottom: y };
}

function meets(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
