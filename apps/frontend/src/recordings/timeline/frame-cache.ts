/** What is drawn of a picture. */
export interface FramePicture {
  readonly width: number;
  readonly height: number;
}

/** Pictures kept, of 320 pixels across at most: about 50 MB. */
const MAX_FRAMES = 240;
/** Asked for at the same time: the newest wish comes soon. */
const MAX_PENDING = 3;

/** Small pictures of film strips. What is wished last is read first; those not drawn for longest go. */
export class FrameCache<P extends FramePicture> {
  readonly #pictures = new Map<string, P | undefined>();
  readonly #pending = new Set<string>();
  #wishes: { readonly topic: string; readonly timeMs: number }[] = [];
  readonly #request: (topic: string, timeMs: number) => void;
  readonly #drop: (picture: P) => void;

  constructor(request: (topic: string, timeMs: number) => void, drop: (picture: P) => void) {
    this.#request = request;
    this.#drop = drop;
  }

  /** The picture, or undefined until it was read; it is then asked for. */
  get(topic: string, timeMs: number): P | undefined {
    const key = keyOf(topic, timeMs);
    const picture = this.#pictures.get(key);
    if (this.#pictures.has(key)) {
      this.#pictures.delete(key);
      this.#pictures.set(key, picture);
      return picture;
    }
    if (!this.#pending.has(key)) this.#wishes.push({ topic, timeMs });
    this.#ask();
    return undefined;
  }

  /** Forgets what is not read yet: other places are in view. */
  forgetWishes(): void {
    this.#wishes = [];
  }

  /** @param picture undefined when it cannot be decoded */
  take(topic: string, timeMs: number, picture: P | undefined): void {
    const key = keyOf(topic, timeMs);
    this.#pending.delete(key);
    this.#pictures.set(key, picture);
    for (const [oldest, old] of this.#pictures) {
      if (this.#pictures.size <= MAX_FRAMES) break;
      this.#pictures.delete(oldest);
      if (old) this.#drop(old);
    }
    this.#ask();
  }

  close(): void {
    for (const picture of this.#pictures.values()) if (picture) this.#drop(picture);
    this.#pictures.clear();
    this.#wishes = [];
  }

  #ask(): void {
    while (this.#pending.size < MAX_PENDING) {
      const wish = this.#wishes.pop();
      if (wish === undefined) return;
      const key = keyOf(wish.topic, wish.timeMs);
      if (this.#pending.has(key) || this.#pictures.has(key)) continue;
      this.#pending.add(key);
      this.#request(wish.topic, wish.timeMs);
    }
  }
}

const keyOf = (topic: string, timeMs: number): string => `${timeMs} ${topic}`;
