/** Letters and digits that are not taken for each other. */
const LETTERS = 'ABCDEFGHJKLMNPRSTUVWXYZ23456789';
const CODE_LENGTH = 6;
const LASTS_MS = 2 * 60_000;

/** Codes with which another phone takes over a seat: each once, for two minutes, one a seat. */
export class SeatOffers {
  readonly #byCode = new Map<string, { readonly key: string; readonly untilMs: number }>();
  readonly #drawByte: () => number;

  /** @param drawByte a random integer from 0 to 255 */
  constructor(drawByte: () => number) {
    this.#drawByte = drawByte;
  }

  /** A new code for the seat of a client; the one before is good for nothing any more. */
  offer(key: string, nowMs: number): string {
    for (const [code, { key: other, untilMs }] of this.#byCode) {
      if (other === key || untilMs <= nowMs) this.#byCode.delete(code);
    }
    const code = Array.from({ length: CODE_LENGTH }, () => this.#drawLetter()).join('');
    this.#byCode.set(code, { key, untilMs: nowMs + LASTS_MS });
    return code;
  }

  /** The client whose seat a code is for. The code is used up. */
  take(code: string, nowMs: number): string | undefined {
    const wanted = code.toUpperCase().replace(/[^A-Z0-9]/g, '');
    const offer = this.#byCode.get(wanted);
    this.#byCode.delete(wanted);
    return offer && offer.untilMs > nowMs ? offer.key : undefined;
  }

  /** Each letter is as likely as the others: bytes beyond the last whole alphabet are drawn again. */
  #drawLetter(): string {
    for (;;) {
      const byte = this.#drawByte();
      if (byte < 256 - (256 % LETTERS.length)) return LETTERS[byte % LETTERS.length]!;
    }
  }
}
